#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "figures/run_page.hpp"
#include "report.hpp"
#include "run/fields.hpp"
#include "run/force_density.hpp"
#include "run/series.hpp"

namespace percuss::app {
namespace {

std::string table_of(const ForceDensity& density, const Units& units, const std::string& place) {
    const std::size_t bins = density.edges.size() - 1;
    std::string csv = fmt::format("time [{}]", units.label(Quantity::time));
    for (std::size_t b = 0; b < bins; ++b)
        csv += fmt::format(",{} {:.6g} [{}/{}]", place, 0.5 * (density.edges[b] + density.edges[b + 1]),
                           units.label(Quantity::force), units.label(Quantity::length));
    csv += '\n';
    for (std::size_t f = 0; f < density.times.size(); ++f) {
        csv += fmt::format("{:.10g}", density.times[f]);
        for (std::size_t b = 0; b < bins; ++b) csv += fmt::format(",{:.8g}", density.values[f * bins + b]);
        csv += '\n';
    }
    return csv;
}

}  // namespace

RunPage make_surface_forces_page(const RecordedRun& run, const FigureSpec& figure) {
    const Scene& scene = run.setup->scene;
    ForceDensity density =
        force_density(trace_of(run, figure.name), figure.direction, figure.along, figure.bins);
    for (double& value : density.values) value *= figure.factor;
    const std::size_t bins = density.edges.size() - 1, rows = density.times.size();
    const DisplayUnit time = time_unit(run);
    const std::string place =
        figure.along ? "initial " + coordinate_name(scene, *figure.along) : "length along the edge";
    const std::string unit = scene.units.label(Quantity::force) + "/" + scene.units.label(Quantity::length);
    const std::string value = direction_names(scene.geometry)[figure.direction] + " force per length";

    render::HeatMap map;
    for (const double at : density.times) map.x.push_back(time.scale * at);
    for (std::size_t b = 0; b < bins; ++b) map.y.push_back(0.5 * (density.edges[b] + density.edges[b + 1]));
    map.values = density.values;
    map.x_title = titled("time", time.label);
    map.y_title = titled(place, scene.units.label(Quantity::length));
    map.value_title = titled(value, unit);
    map.title = fmt::format("on {}.{}", figure.body, figure.edge);
    map.x_range = time_range(run, figure);
    map.range = figure.range;
    map.colour_map = figure.colour_map;

    RunPage result;
    result.csv = table_of(density, scene.units, place);
    result.page.title = figure.title.empty() ? "Contact force along the surface" : figure.title;
    result.page.width = figure.times.empty() ? 1600 : 2200;
    if (figure.times.empty() || rows < 2) {
        result.page.panels.push_back({std::move(map), {0, 0, 1, 1}});
        return result;
    }

    render::Chart profiles;
    profiles.title = figure.window > 0
                         ? fmt::format("means over {}", with_unit(scene.units, Quantity::time, figure.window))
                         : fmt::format("means over {}", with_unit(scene.units, Quantity::time,
                                                                  density.times[1] - density.times[0]));
    for (const double at : figure.times) {
        render::Curve curve{fmt::format("{:.4g} {}", time.scale * at, time.label), {}, map.y, false};
        for (std::size_t b = 0; b < bins; ++b) {
            std::vector<double> of_bin;
            for (std::size_t f = 0; f < rows; ++f) of_bin.push_back(density.values[f * bins + b]);
            const double half = 0.5 * std::max(figure.window, density.times[1] - density.times[0]);
            curve.x.push_back(mean_between(density.times, of_bin, at - half, at + half));
        }
        profiles.curves.push_back(std::move(curve));
    }
    profiles.x_title = map.value_title;
    profiles.y_title = map.y_title;
    profiles.y_range = {density.edges.front(), density.edges.back()};
    profiles.x_range = figure.range;
    result.page.panels.push_back({std::move(map), {0, 0, 0.58, 1}});
    result.page.panels.push_back({std::move(profiles), {0.58, 0, 0.42, 1}});
    return result;
}

}  // namespace percuss::app
