#pragma once

#include <functional>

#include <CLI/App.hpp>

namespace percuss::app {

/// What a parsed command line asks for; returns the exit status.
using Job = std::function<int()>;

// Each adds one subcommand; when it is the one called, `job` becomes its work.
void add_run(CLI::App& app, Job& job);
void add_check(CLI::App& app, Job& job);
void add_info(CLI::App& app, Job& job);
void add_render(CLI::App& app, Job& job);
void add_figures(CLI::App& app, Job& job);
void add_compare(CLI::App& app, Job& job);
void add_study(CLI::App& app, Job& job);
void add_study_case(CLI::App& app, Job& job);  ///< what add_study starts processes of
void add_view(CLI::App& app, Job& job);

}  // namespace percuss::app
