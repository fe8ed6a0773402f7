#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "exit_status.hpp"
#include "figures/run_page.hpp"
#include "report.hpp"
#include "run/series.hpp"

namespace percuss::app {
namespace {

double largest(const std::vector<double>& values) {
    double most = 0;
    for (const double value : values)
        if (std::isfinite(value)) most = std::max(most, std::abs(value));
    return most;
}

}  // namespace

RunPage make_history_page(const RecordedRun& run, const FigureSpec& figure) {
    const Scene& scene = run.setup->scene;
    const History& history = *run.history;
    const DisplayUnit time = time_unit(run);
    const std::vector<double> times = history.values("time");
    std::vector<double> x = times;
    for (double& value : x) value *= time.scale;

    render::Chart chart;
    double most = figure.range ? std::max(std::abs((*figure.range)[0]), std::abs((*figure.range)[1])) : 0;
    Quantity quantity = Quantity::dimensionless;
    std::vector<std::vector<double>> curves;
    for (const std::string& column : figure.columns) {
        const std::size_t index = history.column(column);
        quantity = history.columns()[index].quantity;
        auto values = moving_average(times, history.values(index, 0, times.size()), figure.window);
        for (double& value : values) value *= figure.factor;
        if (!figure.range) most = std::max(most, largest(values));
        curves.push_back(std::move(values));
    }
    const DisplayUnit unit = scene.units.display(quantity, most);
    for (std::size_t k = 0; k < curves.size(); ++k) {
        for (double& value : curves[k]) value *= unit.scale;
        const std::string label = !figure.labels.empty()       ? figure.labels[k]
                                  : figure.columns.size() == 1 ? ""
                                                               : column_title(figure.columns[k]);
        chart.curves.push_back({label, x, std::move(curves[k]), false});
        const ExactHistory* exact = exact_of(scene, figure.columns[k]);
        if (exact == nullptr) continue;
        render::Curve reference{exact->label, {}, {}, true};
        for (const auto& [at, value] : exact->points) {
            reference.x.push_back(time.scale * at);
            reference.y.push_back(unit.scale * figure.factor * value);
        }
        chart.curves.push_back(std::move(reference));
    }
    if (figure.window > 0)
        chart.title =
            fmt::format("moving average over {}", with_unit(scene.units, Quantity::time, figure.window));
    const std::string value_title = !figure.value_title.empty()  ? figure.value_title
                                    : figure.columns.size() == 1 ? column_title(figure.columns[0])
                                                                 : figure.title;
    chart.x_title = titled("time", time.label);
    chart.y_title = titled(value_title, unit.label);
    chart.x_range = time_range(run, figure);
    if (figure.range) chart.y_range = {unit.scale * (*figure.range)[0], unit.scale * (*figure.range)[1]};
    RunPage result;
    result.page.title = figure.title;
    result.page.panels.push_back({std::move(chart), {0, 0, 1, 1}});
    return result;
}

}  // namespace percuss::app
