#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "figures/run_page.hpp"
#include "report.hpp"
#include "run/contact_forces.hpp"
#include "run/fields.hpp"

namespace percuss::app {

RunPage make_clamping_page(const RecordedRun& run, const FigureSpec& figure) {
    const Scene& scene = run.setup->scene;
    const ContactAnalysis analysis = analyse_contacts(scene, *run.history);
    const std::string direction = direction_names(scene.geometry)[figure.direction];

    FigureSpec histories = figure;
    histories.kind = FigureKind::history;
    histories.window = figure.window > 0 ? figure.window : analysis.window;
    histories.value_title = direction + " force between the bodies";
    histories.columns.clear();
    render::Bars bars;
    double most = 0;
    const std::vector<std::string> labels = figure.labels.empty() ? figure.columns : figure.labels;
    for (const ForceMeans& pair : analysis.pairs)
        most = std::max(
            {most, std::abs(pair.peak[figure.direction]), std::abs(pair.residual[figure.direction])});
    const DisplayUnit unit = scene.units.display(Quantity::force, most);
    for (std::size_t k = 0; k < figure.columns.size(); ++k) {
        histories.columns.push_back(fmt::format("contact.{}.{}", figure.columns[k], direction));
        const auto pair =
            std::find_if(analysis.pairs.begin(), analysis.pairs.end(),
                         [&](const ForceMeans& means) { return means.name == figure.columns[k]; });
        // Which of the two bodies is the master is no matter of clamping: magnitudes.
        const double peak = unit.scale * std::abs(pair->peak[figure.direction]);
        const double residual = unit.scale * std::abs(pair->residual[figure.direction]);
        bars.groups.push_back(
            {labels[k],
             {peak, residual},
             {fmt::format("{:.3g} at {}", peak,
                          with_unit(scene.units, Quantity::time, pair->peak_time[figure.direction])),
              fmt::format("{:.3g}", residual)}});
    }
    histories.labels = labels;
    RunPage result = make_history_page(run, histories);
    for (render::Curve& curve : std::get<render::Chart>(result.page.panels.front().panel).curves)
        for (double& value : curve.y) value = std::abs(value);
    bars.series = {"peak", fmt::format("mean from {} on",
                                       with_unit(scene.units, Quantity::time, analysis.residual_from))};
    bars.title = fmt::format("peak of the average over {} and residual",
                             with_unit(scene.units, Quantity::time, analysis.window));
    bars.x_title = titled(histories.value_title, unit.label);
    result.page.title = figure.title.empty() ? "Forces between the bodies" : figure.title;
    result.page.width = 2200;
    result.page.panels.front().place = {0, 0, 0.55, 1};
    result.page.panels.push_back({std::move(bars), {0.55, 0, 0.45, 1}});
    return result;
}

}  // namespace percuss::app
