#include "live/reference.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace percuss::app {
namespace {

double peak(const MinMaxPyramid& values, std::size_t rows) {
    if (rows == 0) return 0;
    const MinMax all = values.range(0, rows);
    if (!(all.low <= all.high)) return 0;
    return std::abs(all.low) > std::abs(all.high) ? all.low : all.high;
}

}  // namespace

void Reference::follow(double shown) {
    if (auto kept = moments(shown)) moment = std::move(kept);
    curves.follow(history);
}

std::optional<std::size_t> Reference::column(const std::string& name) const {
    return column_named(history, name);
}

std::optional<std::size_t> column_named(const std::shared_ptr<const History>& history,
                                        const std::string& name) {
    if (!history) return std::nullopt;
    const auto& columns = history->columns();
    const auto found =
        std::find_if(columns.begin(), columns.end(), [&](const auto& c) { return c.name == name; });
    if (found == columns.end()) return std::nullopt;
    return static_cast<std::size_t>(found - columns.begin());
}

std::vector<PeakDifference> peak_differences(const std::vector<PlotInfo>& plots,
                                             const std::vector<HistoryColumn>& columns, Curves& present,
                                             Reference& reference) {
    std::vector<PeakDifference> found;
    const std::size_t rows = present.rows(), reference_rows = reference.curves.rows();
    if (rows == 0 || reference_rows == 0) return found;
    // A run that has just begun has no peaks yet: what is compared is the time that both have.
    const double until = std::min(present.times()[rows - 1], reference.curves.times()[reference_rows - 1]);
    const double late = until * (1 + 1e-9);
    for (const PlotInfo& plot : plots) {
        if (plot.folded || (plot.quantity != Quantity::force && plot.quantity != Quantity::velocity))
            continue;
        for (const CurveInfo& curve : plot.curves) {
            if (curve.own) continue;  // a probe of the window: the reference did not read it
            const auto other = reference.column(columns[curve.column].name);
            if (!other) continue;
            found.push_back({curve.label, plot.quantity,
                             peak(present.column(curve.column), present.row_at(late)),
                             peak(reference.curves.column(*other), reference.curves.row_at(late))});
        }
    }
    return found;
}

}  // namespace percuss::app
