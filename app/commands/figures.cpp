#include <optional>

#include <fmt/format.h>

#include "commands.hpp"
#include "context/context.hpp"
#include "exit_status.hpp"
#include "finished_run.hpp"
#include "image.hpp"
#include "options.hpp"
#include "output.hpp"
#include "run_figure.hpp"

namespace percuss::app {
namespace {

struct FigureOptions {
    std::vector<std::string> runs, columns;
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

int draw_figures(const FigureOptions& options) {
    const std::filesystem::path out = options.out;
    if (out.extension() != ".png")
        throw UsageError(fmt::format("--out {}: the name must end in .png", options.out));
    if (!options.force && std::filesystem::exists(out)) {
        throw UsageError(fmt::format("--out {}: the file exists; choose another, or replace it with --force",
                                     options.out));
    }
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
    CLI::App& command = *app.add_subcommand("figures", "Charts for print of one or several recorded runs");
    command.footer(
        "A run's chart is titled by its step. Exact answers of the scene are drawn dashed.\n"
        "Columns are those of history.csv, e.g. contact.impact.axial, energy.kinetic.");
    command.add_option("RUN", options->runs, "directories of runs, or their run.h5")->required();
    command
        .add_option("--column", options->columns,
                    "history column, repeatable; default: the first contact's force")
        ->expected(1)
        ->take_all();
    command.add_option("--out", options->out, "the figure")->type_name("FILE.png")->required();
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
