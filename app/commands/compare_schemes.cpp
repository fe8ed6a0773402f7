#include <filesystem>

#include <fmt/format.h>

#include "commands/compare.hpp"
#include "context/context.hpp"
#include "exit_status.hpp"
#include "image.hpp"
#include "output.hpp"
#include "report.hpp"
#include "scene/parse.hpp"
#include "scheme_cases.hpp"
#include "study/grid.hpp"

namespace percuss::app {
namespace {

namespace fs = std::filesystem;

/// Where the figure and the numbers go.
struct Targets {
    fs::path figure, csv;
};

Targets targets_of(const CompareOptions& options) {
    Targets targets;
    const fs::path out = options.out;
    if (out.extension() == ".png") {
        targets.figure = out;
    } else {
        if (fs::is_regular_file(out))
            throw UsageError(
                fmt::format("--out {}: a file is there; name FILE.png or a directory", options.out));
        targets = {out / "compare.png", out / "compare.csv"};
    }
    if (options.csv) targets.csv = *options.csv;
    for (const fs::path& file : {targets.figure, targets.csv}) check_free(file.string(), options.force);
    return targets;
}

/// What was asked for, and the scene's lesson where nothing was.
SchemeGrid grid_of(const CompareOptions& options) {
    SchemeGrid grid{options.schemes, options.steps, "", {}};
    for (const double step : grid.steps)
        if (!(step > 0 && step <= 1))
            throw UsageError(fmt::format(
                "--steps: {:g} is no fraction of the critical step; write e.g. 0.1,0.5,0.9", step));
    if (options.vary) {
        const StudyAxis axis = parse_axis(*options.vary, "--vary");
        grid.key = axis.key;
        grid.values = axis.values;
    }
    const Scene scene = load_scene(options.a, options.overrides);
    for (const std::string& warning : scene.warnings) fmt::print(stderr, "{}\n", warning);
    if (!scene.lesson || !scene.lesson->compare) return grid;
    const Comparison& lesson = *scene.lesson->compare;
    if (grid.schemes.empty()) grid.schemes = lesson.schemes;
    if (grid.steps.empty()) grid.steps = lesson.steps;
    if (grid.values.empty() && !lesson.values.empty()) {
        grid.key = scene.lesson->control;
        for (const double value : lesson.values) grid.values.push_back(fmt::format("{}", value));
    }
    return grid;
}

}  // namespace

int compare_schemes(const CompareOptions& options) {
    const Targets targets = targets_of(options);
    const std::vector<SchemeCase> cases = make_cases(options.a, options.overrides, grid_of(options));
    std::vector<CaseRun> runs;
    int status = exit_status::ok;
    for (const SchemeCase& each : cases) {
        auto run = run_case(each, options.threads);
        if (!run) {
            status = exit_status::interrupted;
            break;
        }
        if (run->diverged) {
            fmt::print(stderr, "{}: {}\n", each.label, run->run.summary["message"].get<std::string>());
            status = exit_status::run_failed;
        }
        runs.push_back(std::move(*run));
    }
    if (runs.empty()) return status;
    const CaseTable table = make_case_table(runs);
    print_aligned(table.rows());
    for (const std::string& note : table.notes) fmt::print("{}\n", note);
    for (const fs::path& file : {targets.figure, targets.csv})
        if (file.has_parent_path()) fs::create_directories(file.parent_path());
    const auto context = render::make_offscreen_context();
    const render::Image image = render::draw_page(*context, make_scheme_page(runs, table));
    write_whole(targets.figure, [&](const fs::path& aside) { render::write_png(image, aside); });
    fmt::print("{}\n", targets.figure.string());
    if (!targets.csv.empty()) {
        write_text_file(targets.csv, table.csv());
        fmt::print("{}\n", targets.csv.string());
    }
    return status;
}

}  // namespace percuss::app
