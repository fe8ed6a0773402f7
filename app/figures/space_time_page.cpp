#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "exit_status.hpp"
#include "figures/run_page.hpp"
#include "run/fields.hpp"

namespace percuss::app {
namespace {

/// The coordinate that changes along the line, when only one does.
std::optional<std::size_t> only_direction(const Trace& trace) {
    const Vec2 span = (trace.points.back() - trace.points.front()).cwiseAbs();
    if (span.x() <= 1e-9 * span.y()) return 1;
    if (span.y() <= 1e-9 * span.x()) return 0;
    return std::nullopt;
}

}  // namespace

RunPage make_space_time_page(const RecordedRun& run, const FigureSpec& figure) {
    const Scene& scene = run.setup->scene;
    const Trace& trace = trace_of(run, figure.name);
    const std::size_t rows = trace.rows->rows(), points = trace.points.size();
    const DisplayUnit time = time_unit(run);
    std::vector<double> place = trace.along;
    std::string place_title = "distance along the line";
    if (const auto direction = only_direction(trace)) {
        for (std::size_t k = 0; k < points; ++k)
            place[k] = trace.points[k][static_cast<Eigen::Index>(*direction)];
        place_title = "initial " + coordinate_name(scene, *direction);
    }
    const bool falls = place.back() < place.front();
    const auto [least, most_place] = std::minmax_element(place.begin(), place.end());
    const DisplayUnit length =
        scene.units.display(Quantity::length, std::max(std::abs(*least), std::abs(*most_place)));

    render::HeatMap map;
    double most = 0;
    for (std::size_t f = 0; f < rows; ++f) {
        const std::vector<double> row = trace.rows->table(f, f + 1);
        map.x.push_back(time.scale * row[0]);
        for (std::size_t k = 0; k < points; ++k) {
            map.values.push_back(row[1 + (falls ? points - 1 - k : k)]);
            if (std::isfinite(map.values.back())) most = std::max(most, std::abs(map.values.back()));
        }
    }
    const FieldInfo field = find_field(scene, figure.field);
    const DisplayUnit unit = scene.units.display(
        field.quantity,
        figure.range ? std::max(std::abs((*figure.range)[0]), std::abs((*figure.range)[1])) : most);
    for (double& value : map.values) value *= unit.scale;
    if (falls) std::reverse(place.begin(), place.end());
    for (const double at : place) map.y.push_back(length.scale * at);
    map.x_title = titled("time", time.label);
    map.y_title = titled(place_title, length.label);
    map.value_title = titled(field.title, unit.label);
    map.title = figure.body;
    if (const auto direction = only_direction(trace)) {
        const std::size_t other = 1 - *direction;
        map.title += fmt::format(", initial {} = {:.4g} {}", coordinate_name(scene, other),
                                 trace.points.front()[static_cast<Eigen::Index>(other)],
                                 scene.units.label(Quantity::length));
    }
    map.x_range = time_range(run, figure);
    if (figure.range) map.range = {unit.scale * (*figure.range)[0], unit.scale * (*figure.range)[1]};
    map.colour_map = figure.colour_map;

    RunPage result;
    result.page.title = figure.title.empty() ? field.title + " over position and time" : figure.title;
    result.page.panels.push_back({std::move(map), {0, 0, 1, 1}});
    return result;
}

}  // namespace percuss::app
