#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "commands/compare.hpp"
#include "context/context.hpp"
#include "exit_status.hpp"
#include "figures/comparison.hpp"
#include "finished_run.hpp"
#include "image.hpp"
#include "output.hpp"

namespace percuss::app {
namespace {

/// The last part of a run's path that is a name of its own: out/thin/run.h5 -> thin.
std::string run_name(const std::string& argument) {
    std::filesystem::path path = std::filesystem::path(argument).lexically_normal();
    if (path.filename() == "run.h5") path = path.parent_path();
    if (path.filename().empty()) path = path.parent_path();
    return path.filename().empty() ? argument : path.filename().string();
}

void print_table(const std::vector<Difference>& differences, const std::array<std::string, 2>& names,
                 double least) {
    std::size_t width = 8;
    std::vector<const Difference*> shown;
    std::map<std::string, double> largest;  // of each unit: rounding noise beside it is no difference
    for (const Difference& d : differences)
        largest[d.unit] = std::max({largest[d.unit], std::abs(d.a), std::abs(d.b)});
    for (const Difference& d : differences)
        if (100 * std::abs(d.relative()) >= least && std::abs(d.b - d.a) > 1e-9 * largest[d.unit]) {
            shown.push_back(&d);
            width = std::max(width, d.path.size());
        }
    fmt::print("{:<{}}  {:>8}  {:>12}  {:>12}  {:>9}\n", "quantity", width, "unit", names[0], names[1],
               "change");
    for (const Difference* d : shown) {
        const double change = 100 * d->relative();
        fmt::print("{:<{}}  {:>8}  {:>12.5g}  {:>12.5g}  {:>9}\n", d->path, width, d->unit, d->a, d->b,
                   std::isfinite(change) ? fmt::format("{:+.1f} %", change) : "");
    }
    fmt::print("{} of {} numbers differ by {} % or more\n", shown.size(), differences.size(), least);
}

/// What --set changed is no parameter of the scene but may be all that differs.
void print_settings(const RecordedRun& run, const std::string& name) {
    for (const std::string& setting : run.setup->scene.overrides) fmt::print("{}: --set {}\n", name, setting);
}

}  // namespace

void check_free(const std::string& file, bool force) {
    if (!force && !file.empty() && std::filesystem::exists(file))
        throw UsageError(
            fmt::format("{}: the file exists; choose another, or replace it with --force", file));
}

int compare_two_runs(const CompareOptions& options) {
    const std::filesystem::path out = options.out;
    if (out.extension() != ".png")
        throw UsageError(fmt::format("--out {}: the name must end in .png", options.out));
    for (const std::string& file : {options.out, options.csv.value_or("")}) check_free(file, options.force);
    const RecordedRun a = load_recorded_run(run_file_of(options.a)),
                      b = load_recorded_run(run_file_of(options.b));
    std::array<std::string, 2> names{run_name(options.a), run_name(options.b)};
    if (names[0] == names[1]) names = {options.a, options.b};
    const render::Page page = make_comparison(a, b, names);
    const std::vector<Difference> differences = compare_runs(a, b);
    print_settings(a, names[0]);
    print_settings(b, names[1]);
    print_table(differences, names, options.least.value_or(0.1));
    if (out.has_parent_path()) std::filesystem::create_directories(out.parent_path());
    const auto context = render::make_offscreen_context();
    const render::Image image = render::draw_page(*context, page);
    write_whole(out, [&](const std::filesystem::path& aside) { render::write_png(image, aside); });
    fmt::print("{}\n", options.out);
    if (options.csv) {
        write_text_file(*options.csv, differences_csv(differences));
        fmt::print("{}\n", *options.csv);
    }
    return exit_status::ok;
}

}  // namespace percuss::app
