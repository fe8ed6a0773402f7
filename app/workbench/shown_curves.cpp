#include "workbench/shown_curves.hpp"

#include <algorithm>

namespace percuss::app {

bool shown(const PlotsState& state, const PlotInfo& plot, const CurveInfo& curve) {
    return curve.shown != state.toggled.contains(plot.name + "/" + curve.label);
}

std::optional<std::size_t> reference_column(const Workbench& w, const CurveInfo& curve) {
    if (!w.reference || curve.own || w.reference->history == w.run.history()) return std::nullopt;
    return w.reference->column(w.plots.columns[curve.column].name);
}

std::optional<std::size_t> beside_column(const Workbench& w, const BesideRun& run, const CurveInfo& curve) {
    if (curve.own) return std::nullopt;
    return run.column(w.plots.columns[curve.column].name);
}

std::array<double, 2> shown_times(const Workbench& w) {
    if (w.plots.time) return *w.plots.time;
    const Curves& curves = w.plots.curves;
    const double duration = w.run.snapshot()->setup->scene.duration;
    double last = curves.rows() > 0 ? curves.times()[curves.rows() - 1] : 0;
    if (w.reference && w.reference->curves.rows() > 0)
        last = std::max(last, w.reference->curves.times()[w.reference->curves.rows() - 1]);
    for (const BesideView& each : w.beside)
        if (const Curves& curves_beside = each.run->curves(); curves_beside.rows() > 0)
            last = std::max(last, curves_beside.times()[curves_beside.rows() - 1]);
    return {0, std::max(last, 0.02 * duration)};
}

double rate_window(const Workbench& w) {
    const Scene& scene = w.run.snapshot()->setup->scene;
    return 1 / scene.units.display(Quantity::time, scene.duration).scale;
}

DisplayUnit unit_of(const Workbench& w, const PlotInfo& plot, double largest) {
    const Scene& scene = w.run.snapshot()->setup->scene;
    if (!plot.rate) return scene.units.display(plot.quantity, largest);
    const DisplayUnit time = scene.units.display(Quantity::time, scene.duration);
    return {1 / time.scale, "1/" + time.label};
}

}  // namespace percuss::app
