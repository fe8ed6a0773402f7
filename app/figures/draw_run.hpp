#pragma once

#include <filesystem>
#include <vector>

#include "context/context.hpp"
#include "figures/run_figure.hpp"

namespace percuss::app {

/// Draws figures of a run into NAME.png, and NAME.csv where a figure has numbers of its own. Each file
/// appears whole.
/// @returns the files. @throws UsageError when the run lacks what a figure shows.
std::vector<std::filesystem::path> draw_run_figures(render::Context& context, const RecordedRun& run,
                                                    const std::vector<FigureSpec>& figures,
                                                    const std::filesystem::path& folder);

/// Draws the figures that the scene of a recorded run declares; none: makes no folder.
std::vector<std::filesystem::path> draw_declared_figures(const std::filesystem::path& run_file,
                                                         const std::filesystem::path& folder);

}  // namespace percuss::app
