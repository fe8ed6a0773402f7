#include "view/side_charts.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>

#include <fmt/format.h>

#include "nearest_name.hpp"
#include "run/fields.hpp"
#include "run/series.hpp"

namespace percuss::render {

namespace {

struct ChartCurve {
    std::vector<std::string> columns;  ///< summed
    std::string label;
};

const FigureSpec* history_figure(const Scene& scene, const std::string& name) {
    const auto found = std::find_if(
        scene.figures.begin(), scene.figures.end(),
        [&](const FigureSpec& figure) { return figure.kind == FigureKind::history && figure.name == name; });
    return found == scene.figures.end() ? nullptr : &*found;
}

std::vector<ChartCurve> curves_of(const FigureSpec& figure) {
    std::vector<ChartCurve> curves;
    for (std::size_t k = 0; k < figure.columns.size(); ++k)
        curves.push_back({{figure.columns[k]}, figure.labels.empty() ? figure.columns[k] : figure.labels[k]});
    return curves;
}

/// Columns of one vector quantity for all `owners`; each direction named when more than one is worth drawing.
std::vector<ChartCurve> vector_curves(const Scene& scene, const std::vector<std::string>& owners,
                                      const std::string& format, const History& history) {
    const auto directions = direction_names(scene.geometry);
    std::array<double, 2> largest{0, 0};
    for (const std::string& owner : owners)
        for (std::size_t d = 0; d < 2; ++d)
            for (const double value : history.values(fmt::format(fmt::runtime(format), owner, directions[d])))
                if (std::isfinite(value)) largest[d] = std::max(largest[d], std::abs(value));
    constexpr double worth_drawing = 0.01;
    const bool both = std::min(largest[0], largest[1]) > worth_drawing * std::max(largest[0], largest[1]);
    std::vector<ChartCurve> wanted;
    for (std::size_t d : {1, 0}) {
        if (!both && largest[d] < largest[1 - d]) continue;
        if (!both && d == 0 && largest[0] == largest[1]) continue;  // nothing moves yet: the second direction
        for (const std::string& owner : owners)
            wanted.push_back({{fmt::format(fmt::runtime(format), owner, directions[d])},
                              both ? owner + ", " + directions[d] : owner});
    }
    return wanted;
}

/// K, I, the contact's work, and K + I, which a sound run never lets grow.
std::vector<ChartCurve> energy_curves() {
    return {{{"energy.kinetic"}, "kinetic"},
            {{"energy.internal"}, "internal"},
            {{"energy.contact"}, "contact"},
            {{"energy.kinetic", "energy.internal"}, "kinetic + internal"}};
}

/// The run's own time axis: its duration, or what has been computed when that is longer.
double end_of_run(const Scene& scene, const std::vector<double>& times) {
    return std::max(scene.duration, times.empty() ? 0.0 : times.back());
}

}  // namespace

Chart make_side_chart(const std::string& name, const Scene& scene, const History& history, double time,
                      const DisplayUnit& time_unit) {
    std::vector<std::string> owners;
    std::vector<ChartCurve> wanted;
    std::string title = name;
    const FigureSpec* figure = history_figure(scene, name);
    if (figure) {
        wanted = curves_of(*figure);
        title = figure->value_title.empty() ? figure->title : figure->value_title;
    } else if (name == "force") {
        for (const ContactPair& pair : scene.contacts) owners.push_back(pair.name);
        wanted = vector_curves(scene, owners, "contact.{}.{}", history);
        title = "contact force";
    } else if (name == "velocity") {
        for (const Body& body : scene.bodies) owners.push_back(body.name);
        wanted = vector_curves(scene, owners, "body.{}.velocity.{}", history);
        title = "mean velocity";
    } else if (name == "energy") {
        wanted = energy_curves();
    } else {
        std::vector<std::string> names{"force", "velocity", "energy"};
        for (const HistoryColumn& column : history.columns()) names.push_back(column.name);
        if (std::find(names.begin(), names.end(), name) == names.end())
            throw std::invalid_argument("unknown chart '" + name + "'" + suggest_name(name, names));
        wanted = {{{name}, ""}};
    }

    Chart chart;
    const std::vector<double> times = history.values("time");
    const auto shown = static_cast<std::size_t>(
        std::upper_bound(times.begin(), times.end(), time * (1 + 1e-12)) - times.begin());
    std::vector<double> x(times.begin(), times.begin() + static_cast<std::ptrdiff_t>(shown));
    for (double& value : x) value *= time_unit.scale;

    // The y axis spans all rows that exist, so that drawing a finished run again does not rescale it every
    // frame.
    std::vector<std::vector<double>> curves;
    double low = 0, high = 0;
    Quantity quantity = Quantity::dimensionless;
    for (const ChartCurve& curve : wanted) {
        std::vector<double> sum(times.size(), 0.0);
        for (const std::string& name_of_part : curve.columns) {
            const std::size_t index = history.column(name_of_part);
            quantity = history.columns()[index].quantity;
            const std::vector<double> part = history.values(index, 0, times.size());
            std::transform(sum.begin(), sum.end(), part.begin(), sum.begin(), std::plus<>());
        }
        if (figure) {
            sum = moving_average(times, sum, figure->window);
            for (double& value : sum) value *= figure->factor;
        }
        for (const double value : sum)
            if (std::isfinite(value)) {
                low = std::min(low, value);
                high = std::max(high, value);
            }
        curves.push_back(std::move(sum));
    }
    const DisplayUnit unit = scene.units.display(quantity, std::max(-low, high));
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        Curve curve{wanted[i].label, x, std::move(curves[i]), false};
        curve.y.resize(shown);
        for (double& value : curve.y) value *= unit.scale;
        chart.curves.push_back(std::move(curve));
    }
    const double span = high > low ? unit.scale * (high - low) : 1;
    chart.y_range = {low < 0 ? unit.scale * low - 0.08 * span : -0.03 * span,
                     high > 0 ? unit.scale * high + 0.08 * span : 0.03 * span};
    if (figure && figure->range)
        chart.y_range = {unit.scale * (*figure->range)[0], unit.scale * (*figure->range)[1]};
    chart.x_range = {0, std::max(time_unit.scale * end_of_run(scene, times), 1e-300)};
    chart.title = unit.label.empty() ? title : fmt::format("{} [{}]", title, unit.label);
    chart.x_title = fmt::format("time [{}]", time_unit.label);
    return chart;
}

}  // namespace percuss::render
