#include <cstdio>
#include <exception>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "commands/commands.hpp"
#include "exit_status.hpp"
#include "scene/parse.hpp"

namespace {

constexpr const char* description =
    R"(percuss: impact of deformable bodies in two dimensions, by explicit dynamics.

A scene (a TOML file) says what is made of what, how fast it moves and what touches what. A run steps it through
time and leaves in DIR: run.h5 (mesh, frames, histories), history.csv (one row a step), summary.json (energies, peak
forces, timings), frames/000000.png, ... and the figures that the scene declares. Units are those that the scene declares.)";

constexpr const char* examples = R"(Examples:
  percuss check scenes/rods.toml                     is the scene sound, how large is it
  percuss info scenes/rods.toml                      masses, critical step, which effects are on
  percuss run scenes/rods.toml --out out/rods        compute, record, draw
  percuss run scenes/rods.toml --out out/half --set model.step.courant=0.5 --film out/half.mp4
  percuss render out/rods --field velocity.axial --all --out out/rods/velocity
  percuss figures out/nail                           all figures of a run: out/nail/figures/NAME.png
  percuss figures out/rods out/half --column contact.impact.axial --out out/force.png
  percuss compare out/nail out/thin --out out/thin.png    two designs on one page
  percuss study scenes/rods.toml                     what accuracy costs: steps, meshes, schemes on one page
  percuss view scenes/nail.toml                      a window: watch it run, turn its parameters

Exit status: 0 done, 1 the run failed, 2 bad scene or bad usage, 3 a promise was broken (run --strict),
130 interrupted (what was computed is complete on disk).)";

}  // namespace

int main(int argc, char** argv) {
    using namespace percuss::app;
    CLI::App app(description, "percuss");
    app.footer(examples);
    app.set_version_flag("--version", "percuss " PERCUSS_VERSION);
    app.require_subcommand(1);
    Job job;
    add_run(app, job);
    add_check(app, job);
    add_info(app, job);
    add_render(app, job);
    add_figures(app, job);
    add_compare(app, job);
    add_study(app, job);
    add_study_case(app, job);
    add_view(app, job);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? exit_status::ok : exit_status::bad_input;
    }
    try {
        return job();
    } catch (const percuss::SceneError& error) {
        fmt::print(stderr, "{}\n", error.what());
        return exit_status::bad_input;
    } catch (const UsageError& error) {
        fmt::print(stderr, "percuss: {}\n", error.what());
        return exit_status::bad_input;
    } catch (const std::exception& error) {
        fmt::print(stderr, "percuss: {}\n", error.what());
        return exit_status::run_failed;
    }
}
