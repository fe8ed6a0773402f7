#include "workbench/shown_curves.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace percuss::app {

Curves& curves_of(PlotsState& state, const CurveInfo& curve) { return curve.own ? *curve.own : state.curves; }

int parts_of_rate(float width) { return std::max(1, static_cast<int>(0.5F * width)); }

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
    for (const ProbeCurve& probe : w.marks.probes.all())  // the last frame of a recorded run is a step later
        if (const Curves& own = *probe.curves; own.rows() > 0)
            last = std::max(last, own.times()[own.rows() - 1]);
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

namespace {

/// The greatest magnitude of the curves of a quantity that the plots show.
double largest_of_kind(Workbench& w, Quantity quantity) {
    double largest = 0;
    for (const PlotInfo& plot : w.plots.plots) {
        if (plot.rate || plot.quantity != quantity || w.plots.folded.contains(plot.name)) continue;
        for (const CurveInfo& curve : plot.curves) {
            Curves& curves = curves_of(w.plots, curve);
            if (!shown(w.plots, plot, curve) || curves.rows() == 0) continue;
            const MinMax all = curves.column(curve.column).range(0, curves.rows());
            largest = std::max({largest, std::abs(all.low), std::abs(all.high)});
        }
    }
    return largest;
}

}  // namespace

std::array<double, 2> shown_values(Workbench& w, const PlotInfo& plot, const std::array<double, 2>& times,
                                   float width) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    const auto include = [&](const MinMax& part) {
        low = std::min(low, part.low);
        high = std::max(high, part.high);
    };
    static thread_local std::vector<CurvePoint> points;
    const auto look_at = [&](Curves& curves, std::size_t column) {
        if (plot.rate) {
            rates(curves, curves.column(column), times[0], times[1], parts_of_rate(width), rate_window(w),
                  points);
            for (const CurvePoint& point : points) include({0, point.value});
            return;
        }
        const std::size_t begin = curves.row_at(times[0]),
                          end = std::min(curves.rows(), curves.row_at(times[1]) + 1);
        if (begin < end) include(curves.column(column).range(begin, end));
    };
    for (const CurveInfo& curve : plot.curves) {
        if (!shown(w.plots, plot, curve)) continue;
        look_at(curves_of(w.plots, curve), curve.column);
        if (const auto column = reference_column(w, curve)) look_at(w.reference->curves, *column);
        for (const BesideView& each : w.beside)
            if (const auto column = beside_column(w, *each.run, curve)) look_at(each.run->curves(), *column);
    }
    if (!(low <= high)) return {0, 1};
    // Beside others of its kind it is nothing but rounding: a line at zero, in their unit.
    const double kin = plot.rate ? 0 : largest_of_kind(w, plot.quantity);
    if (std::max(std::abs(low), std::abs(high)) <= 1e-12 * kin) return {-kin, kin};
    if (low == 0 && high == 0) return {-1, 1};
    if (low > 0 && low < 0.6 * high) low = 0;
    if (high < 0 && high > 0.6 * low) high = 0;
    const double span = high - low, least = 1e-9 * std::max(std::abs(low), std::abs(high));
    const double room = span > least ? 0.06 * span : std::max(0.5 * std::abs(high), 1e-12);
    return {low - room, high + room};
}

}  // namespace percuss::app
