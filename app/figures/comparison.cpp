#include "figures/comparison.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "exit_status.hpp"
#include "figures/run_page.hpp"
#include "record/summary.hpp"
#include "run/energy_budget.hpp"
#include "run/fields.hpp"

namespace percuss::app {
namespace {

struct Ranked {
    std::string column, label;
    double size;
};

double number(const RecordedRun& run, const std::string& path) {
    return summary_value(run.summary, path).value_or(0);
}

/// The three largest averaged peaks that both runs have, of one direction each.
std::vector<Ranked> largest_forces(const RecordedRun& a, const RecordedRun& b) {
    std::vector<Ranked> forces;
    for (const ContactPair& pair : a.setup->scene.contacts)
        for (const std::string& direction : direction_names(a.setup->scene.geometry)) {
            const std::string path = fmt::format("contact.{}.peak_averaged.{}", pair.name, direction);
            if (!summary_value(b.summary, path)) continue;
            forces.push_back({fmt::format("contact.{}.{}", pair.name, direction),
                              pair.name + ", " + direction,
                              std::max(std::abs(number(a, path)), std::abs(number(b, path)))});
        }
    std::stable_sort(forces.begin(), forces.end(),
                     [](const Ranked& x, const Ranked& y) { return x.size > y.size; });
    forces.resize(std::min<std::size_t>(forces.size(), 3));
    return forces;
}

/// The bodies that both runs have, those that change their velocity most.
std::vector<Ranked> largest_velocities(const RecordedRun& a, const RecordedRun& b) {
    std::vector<Ranked> bodies;
    const std::string direction = direction_names(a.setup->scene.geometry)[1];
    for (const Body& body : a.setup->scene.bodies) {
        const std::string column = fmt::format("body.{}.velocity.{}", body.name, direction);
        const auto& others = b.setup->scene.bodies;
        if (std::none_of(others.begin(), others.end(),
                         [&](const Body& other) { return other.name == body.name; }))
            continue;
        const std::vector<double> values = a.history->values(column);
        const auto [low, high] = std::minmax_element(values.begin(), values.end());
        bodies.push_back({column, body.name, values.empty() ? 0 : *high - *low});
    }
    std::stable_sort(bodies.begin(), bodies.end(),
                     [](const Ranked& x, const Ranked& y) { return x.size > y.size; });
    bodies.resize(std::min<std::size_t>(bodies.size(), 4));
    return bodies;
}

/// Curves of both runs in one chart: the first run full, the second dashed, one colour a quantity.
render::Chart chart_of(const RecordedRun& a, const RecordedRun& b, const std::vector<Ranked>& columns,
                       const std::string& title, double window) {
    render::Chart chart;
    const RecordedRun& longer = a.setup->scene.duration >= b.setup->scene.duration ? a : b;
    for (const RecordedRun* run : {&a, &b}) {
        FigureSpec figure;
        figure.value_title = title;
        figure.window = window;
        double most = 0;  // both runs in one unit
        for (const Ranked& column : columns) {
            figure.columns.push_back(column.column);
            figure.labels.push_back(run == &a ? column.label : "");
            for (const RecordedRun* each : {&a, &b})
                for (const double value : each->history->values(column.column))
                    most = std::max(most, std::abs(value));
        }
        if (columns.empty()) return chart;
        figure.range = {-most, most};
        figure.time = {0.0, longer.setup->scene.duration};
        auto made = std::get<render::Chart>(make_history_page(*run, figure).page.panels.front().panel);
        std::erase_if(made.curves, [](const render::Curve& curve) { return curve.exact; });
        for (std::size_t k = 0; k < made.curves.size(); ++k) {
            made.curves[k].colour = k;
            made.curves[k].dashed = run == &b;
            chart.curves.push_back(std::move(made.curves[k]));
        }
        chart.title = made.title;
        chart.x_title = made.x_title;
        chart.y_title = made.y_title;
        chart.x_range = made.x_range;
    }
    return chart;
}

std::map<std::string, double> energies_by_kind(const Snapshot& snapshot) {
    std::map<std::string, double> kinds;
    for (const EnergyShare& share : energy_budget(snapshot)) {
        const std::string name = share.kind == "plastic" ? share.kind + ", " + share.body : share.kind;
        kinds[name] += share.energy;
    }
    return kinds;
}

render::Bars energy_bars(const Snapshot& a, const Snapshot& b, const std::array<std::string, 2>& names) {
    const auto of_a = energies_by_kind(a), of_b = energies_by_kind(b);
    const Units& units = a.setup->scene.units;
    const double most = std::max(std::abs(a.energy.external), std::abs(b.energy.external));
    const DisplayUnit unit = units.display(Quantity::energy, most);
    render::Bars bars;
    bars.title = "Where the energy is at the end";
    bars.x_title = titled("energy", unit.label);
    bars.series = {names[0], names[1]};
    for (const auto& [kind, energy] : of_a) {
        const auto other = of_b.find(kind);
        if (other == of_b.end() || std::max(std::abs(energy), std::abs(other->second)) < 0.002 * most)
            continue;
        bars.groups.push_back({kind,
                               {unit.scale * energy, unit.scale * other->second},
                               {fmt::format("{:.4g}", unit.scale * energy),
                                fmt::format("{:.4g}", unit.scale * other->second)}});
    }
    std::stable_sort(bars.groups.begin(), bars.groups.end(), [](const auto& x, const auto& y) {
        return std::abs(x.values[0]) > std::abs(y.values[0]);
    });
    return bars;
}

std::string short_value(double value) { return fmt::format("{:.4g}", value); }

render::Table table_of(const std::vector<Difference>& differences, const std::array<std::string, 2>& names) {
    render::Table table;
    table.title = "What differs";
    table.header = {"", "unit", names[0], names[1], "change"};
    constexpr std::size_t most_rows = 30;
    constexpr double worth_a_row = 1e-3;
    const auto add = [&](const Difference& d) {
        const double change = 100 * d.relative();
        table.rows.push_back(
            {d.path, d.unit, short_value(d.a), short_value(d.b),
             std::isfinite(change) && std::abs(change) < 1e4 ? fmt::format("{:+.1f} %", change) : ""});
    };
    const auto listed = [&](const Difference& d) {
        if (std::abs(d.relative()) < worth_a_row) return false;
        // Of the forces and extents those that say most in a line: peaks, and the lowest points.
        return d.path.starts_with("parameters.") || d.path.starts_with("analysis.") ||
               d.path.find(".peak_averaged.") != std::string::npos ||
               d.path.find(".residual.") != std::string::npos ||
               d.path.find(".velocity.") != std::string::npos || d.path.ends_with(".min") ||
               d.path.ends_with("plastic_strain_max");
    };
    std::map<std::string, double> largest;  // of each unit: small numbers differ by much and mean little
    for (const Difference& d : differences)
        largest[d.unit] = std::max({largest[d.unit], std::abs(d.a), std::abs(d.b)});
    for (const Difference& d : differences) {
        const bool changed_by_hand = d.path.starts_with("parameters.");
        const bool small = !changed_by_hand && std::abs(d.b - d.a) < 0.002 * largest[d.unit];
        if (listed(d) && !small && table.rows.size() < most_rows) add(d);
    }
    if (table.rows.empty()) table.rows.push_back({"nothing by more than 0.1 %", "", "", "", ""});
    return table;
}

void check(const RecordedRun& run, const std::string& name) {
    if (run.summary.empty())
        throw UsageError(
            fmt::format("{}: the run did not come to its end and has no summary to compare", name));
    if (run.history->rows() < 2)
        throw UsageError(fmt::format("{}: the run has no histories to compare", name));
}

}  // namespace

render::Page make_comparison(const RecordedRun& a, const RecordedRun& b,
                             const std::array<std::string, 2>& names) {
    check(a, names[0]);
    check(b, names[1]);
    const Units &units = a.setup->scene.units, &other = b.setup->scene.units;
    if (units.length_name() != other.length_name() || units.time_name() != other.time_name() ||
        units.mass_name() != other.mass_name() || a.setup->scene.geometry != b.setup->scene.geometry)
        throw UsageError(
            fmt::format("{} and {} have different units or geometries; runs of like scenes can be compared",
                        names[0], names[1]));
    render::Page page;
    page.title = a.setup->scene.title;
    page.width = 2000;
    page.height = 2500;
    page.type = 1.4;
    std::array<std::shared_ptr<const Snapshot>, 2> last;
    for (std::size_t k = 0; k < 2; ++k) {
        const RecordedRun& run = k == 0 ? a : b;
        last[k] = frame_near(run.frames, run.setup->scene.duration);
        render::MeshPicture picture;
        picture.snapshot = last[k];
        picture.options = run.setup->scene.view;
        const DisplayUnit time = time_unit(run);
        picture.title = fmt::format("{}, t = {:.4g} {}", names[k], time.scale * last[k]->time, time.label);
        picture.coloured = true;
        if (!last[k]->plastic_strain.empty()) {
            picture.options.field = "plastic_strain";
            if (a.setup->scene.view.field != "plastic_strain") picture.options.range = std::array{0.0, 1.0};
        } else {
            picture.options.range = a.setup->scene.view.range;
        }
        picture.colour_bar = picture.scale_bar = true;
        picture.room_below = render::MeshPicture::colour_bar_room;
        page.panels.push_back({std::move(picture), {0.5 * static_cast<double>(k), 0, 0.5, 0.36}});
    }
    const double window = a.setup->scene.analysis.window.value_or(a.setup->scene.duration / 200);
    const std::string which = fmt::format("{} full, {} dashed", names[0], names[1]);
    render::Chart forces = chart_of(a, b, largest_forces(a, b), "contact force", window);
    forces.title = which + "; " + forces.title;
    render::Chart velocities = chart_of(a, b, largest_velocities(a, b), "mean velocity", 0);
    velocities.title = which;
    page.panels.push_back({std::move(forces), {0, 0.37, 0.5, 0.27}});
    page.panels.push_back({std::move(velocities), {0.5, 0.37, 0.5, 0.27}});
    page.panels.push_back({energy_bars(*last[0], *last[1], names), {0, 0.65, 0.42, 0.35}});
    page.panels.push_back({table_of(compare_runs(a, b), names), {0.44, 0.65, 0.56, 0.35}});
    return page;
}

}  // namespace percuss::app
