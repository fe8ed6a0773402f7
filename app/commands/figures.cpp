#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "commands.hpp"
#include "context/context.hpp"
#include "exit_status.hpp"
#include "figures/draw_run.hpp"
#include "figures/run_figure.hpp"
#include "figures/run_page.hpp"
#include "finished_run.hpp"
#include "image.hpp"
#include "nearest_name.hpp"
#include "options.hpp"
#include "output.hpp"

namespace percuss::app {
namespace {

struct FigureOptions {
    std::vector<std::string> runs, columns, figures, settings;
    std::string out, title;
    std::optional<std::string> size, time, range;
    bool together = false, no_exact = false, force = false;
};

/// The first contact's axial (or y) force: what the paper draws.
std::string default_column(const RecordedRun& run) {
    for (const HistoryColumn& column : run.history->columns()) {
        if (column.name.starts_with("contact.") &&
            (column.name.ends_with(".axial") || column.name.ends_with(".y"))) {
            return column.name;
        }
    }
    throw UsageError("the run has no contact; name what to draw with --column");
}

void check_free(const std::filesystem::path& file, bool force) {
    if (force || !std::filesystem::exists(file)) return;
    throw UsageError(
        fmt::format("--out {}: the file exists; choose another, or replace it with --force", file.string()));
}

/// Figures that the scene declares or that any run has, each into a file of its own.
int draw_scene_figures(const FigureOptions& options) {
    if (options.runs.size() > 1)
        throw UsageError(
            "figures of the scene are drawn of one run; for several name a --column, or use 'percuss "
            "compare'");
    for (const std::string& setting : options.settings)
        if (!setting.starts_with("figure.") && !setting.starts_with("analysis.") &&
            !setting.starts_with("view."))
            throw UsageError(
                fmt::format("--set {}: only figure, analysis and view can change after the run", setting));
    const std::filesystem::path run_file = run_file_of(options.runs.front());
    const RecordedRun run = load_recorded_run(run_file, options.settings);
    std::vector<FigureSpec> figures = all_figures(run);
    if (!options.figures.empty()) {
        std::vector<FigureSpec> chosen;
        std::vector<std::string> names;
        for (const FigureSpec& figure : figures) names.push_back(figure.name);
        for (const std::string& name : options.figures) {
            const auto found = std::find(names.begin(), names.end(), name);
            if (found == names.end())
                throw UsageError(
                    fmt::format("--figure: unknown figure '{}'{}", name, suggest_name(name, names)));
            chosen.push_back(figures[static_cast<std::size_t>(found - names.begin())]);
        }
        figures = std::move(chosen);
    }
    const std::filesystem::path folder =
        options.out.empty() ? run_file.parent_path() / "figures" : std::filesystem::path(options.out);
    for (const FigureSpec& figure : figures) check_free(folder / (figure.name + ".png"), options.force);
    const auto context = render::make_offscreen_context();
    for (const auto& file : draw_run_figures(*context, run, figures, folder))
        fmt::print("{}\n", file.string());
    return exit_status::ok;
}

int draw_figures(const FigureOptions& options) {
    const std::filesystem::path out = options.out;
    if (!options.figures.empty() || (options.columns.empty() && out.extension().empty()))
        return draw_scene_figures(options);
    if (out.extension() != ".png")
        throw UsageError(fmt::format("--out {}: the name must end in .png", options.out));
    check_free(out, options.force);
    std::vector<RecordedRun> runs;
    for (const std::string& run : options.runs) runs.push_back(load_recorded_run(run_file_of(run)));

    FigureLayout layout{options.columns, options.together, !options.no_exact};
    if (layout.columns.empty()) layout.columns = {default_column(runs.front())};
    render::Figure figure = make_figure(runs, layout);
    figure.title = options.title;
    for (render::Chart& chart : figure.charts) {
        if (options.time) chart.x_range = parse_numbers<2>("--time", *options.time);
        if (options.range) chart.y_range = parse_numbers<2>("--range", *options.range);
    }
    const auto rows = static_cast<int>(figure.charts.size()) / figure.columns;
    const std::array<int, 2> size =
        options.size ? parse_size(*options.size) : std::array{1000 + 600 * figure.columns, 100 + 500 * rows};
    figure.width = size[0];
    figure.height = size[1];

    if (out.has_parent_path()) std::filesystem::create_directories(out.parent_path());
    const auto context = render::make_offscreen_context();
    const render::Image image = render::draw_figure(*context, figure);
    write_whole(out, [&](const std::filesystem::path& aside) { render::write_png(image, aside); });
    fmt::print("{}\n", options.out);
    return exit_status::ok;
}

}  // namespace

void add_figures(CLI::App& app, Job& job) {
    auto options = std::make_shared<FigureOptions>();
    CLI::App& command = *app.add_subcommand("figures", "Figures for print of recorded runs");
    command.footer(
        "Without --column: the figures that the scene declares in [[figure]], and one of each kind that any "
        "run has\n"
        "(forces, velocities, mesh, clamping, energy), each into DIR/NAME.png; default DIR: figures/ beside "
        "run.h5.\n"
        "With --column: charts of histories of one or several runs in one FILE.png. Columns are those of "
        "history.csv,\n"
        "e.g. contact.impact.axial, energy.kinetic. A run's chart is titled by its step, exact answers are "
        "dashed.");
    command.add_option("RUN", options->runs, "directories of runs, or their run.h5")->required();
    command
        .add_option("--figure", options->figures, "figure of the scene, by name, repeatable; default: all")
        ->type_name("NAME")
        ->expected(1)
        ->take_all();
    command
        .add_option("--set", options->settings,
                    "other keys for the scene's figures, e.g. figure.velocities.range=[0,100]; repeatable")
        ->type_name("KEY=VALUE")
        ->expected(1)
        ->take_all();
    command.add_option("--column", options->columns, "history column, repeatable")->expected(1)->take_all();
    command.add_option("--out", options->out, "directory of figures, or the chart of --column")
        ->type_name("DIR|FILE.png");
    command.add_option("--title", options->title, "title of the page");
    command.add_option("--time", options->time, "shown times, in the unit of the time axis")
        ->type_name("FROM,TO");
    command.add_option("--range", options->range, "shown values, in the unit of the axis")
        ->type_name("LOW,HIGH");
    command.add_option("--size", options->size, "pixels")->type_name("WxH");
    command.add_flag("--together", options->together, "all runs in one chart instead of a chart each");
    command.add_flag("--no-exact", options->no_exact, "leave exact answers out");
    command.add_flag("--force", options->force, "replace an existing figure");
    command.callback([&job, options] { job = [options] { return draw_figures(*options); }; });
}

}  // namespace percuss::app
