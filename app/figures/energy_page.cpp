#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "exit_status.hpp"
#include "figures/run_page.hpp"
#include "report.hpp"
#include "run/energy_budget.hpp"

namespace percuss::app {
namespace {

std::string name_of(const EnergyShare& share) {
    return share.body.empty() ? share.kind : share.kind + ", " + share.body;
}

std::string table_of(const std::vector<double>& times, const std::vector<std::vector<EnergyShare>>& budgets,
                     const Units& units) {
    std::string csv = fmt::format("time [{}]", units.label(Quantity::time));
    for (const EnergyShare& share : budgets.front())
        csv += fmt::format(",{} [{}]", share.body.empty() ? share.kind : share.kind + "." + share.body,
                           units.label(Quantity::energy));
    csv += '\n';
    for (std::size_t f = 0; f < times.size(); ++f) {
        csv += fmt::format("{:.10g}", times[f]);
        for (const EnergyShare& share : budgets[f]) csv += fmt::format(",{:.10g}", share.energy);
        csv += '\n';
    }
    return csv;
}

}  // namespace

RunPage make_energy_page(const RecordedRun& run, const FigureSpec& figure) {
    const Scene& scene = run.setup->scene;
    std::vector<double> times;
    std::vector<std::vector<EnergyShare>> budgets;
    double most = 0;
    for (std::size_t f = 0; f < run.frames.size(); ++f) {
        const auto frame = run.frames[f];
        budgets.push_back(energy_budget(*frame));
        times.push_back(frame->time);
        most = std::max(most, std::abs(frame->energy.external));
    }
    if (budgets.size() < 2 || budgets.front().empty())
        throw UsageError("the run has no energies of bodies: it was recorded by an earlier version");
    const DisplayUnit unit = scene.units.display(Quantity::energy, most), time = time_unit(run);

    render::StackedAreas areas;
    for (const double at : times) areas.x.push_back(time.scale * at);
    render::StackedAreas::Layer other{"other", std::vector<double>(times.size(), 0)};
    bool others = false;
    constexpr double worth_a_layer = 0.01, worth_a_bar = 0.001;
    for (std::size_t k = 0; k < budgets.front().size(); ++k) {
        render::StackedAreas::Layer layer{name_of(budgets.front()[k]), {}};
        double largest = 0;
        for (const auto& budget : budgets) {
            layer.y.push_back(unit.scale * budget[k].energy);
            largest = std::max(largest, std::abs(budget[k].energy));
        }
        if (largest >= worth_a_layer * most) {
            areas.layers.push_back(std::move(layer));
            continue;
        }
        others = true;
        for (std::size_t f = 0; f < times.size(); ++f) other.y[f] += layer.y[f];
    }
    if (others) areas.layers.push_back(std::move(other));
    areas.x_title = titled("time", time.label);
    areas.y_title = titled("energy", unit.label);

    render::Bars bars;
    bars.title = fmt::format("at {}", with_unit(scene.units, Quantity::time, times.back()));
    bars.series = {"energy"};
    bars.x_title = titled("energy", unit.label);
    std::vector<EnergyShare> last = budgets.back();
    std::stable_sort(last.begin(), last.end(), [](const EnergyShare& a, const EnergyShare& b) {
        return std::abs(a.energy) > std::abs(b.energy);
    });
    for (const EnergyShare& share : last) {
        if (std::abs(share.energy) < worth_a_bar * most) break;
        bars.groups.push_back(
            {name_of(share),
             {unit.scale * share.energy},
             {fmt::format("{:.3g} ({:.1f} %)", unit.scale * share.energy, 100 * share.energy / most)}});
    }
    RunPage result;
    result.csv = table_of(times, budgets, scene.units);
    result.page.title = figure.title.empty() ? "Where the energy went" : figure.title;
    result.page.width = 2200;
    result.page.panels.push_back({std::move(areas), {0, 0, 0.55, 1}});
    result.page.panels.push_back({std::move(bars), {0.55, 0, 0.45, 1}});
    return result;
}

}  // namespace percuss::app
