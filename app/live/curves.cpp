#include "live/curves.hpp"

#include <algorithm>
#include <cmath>

#include "run/fields.hpp"

namespace percuss::app {
namespace {

/// "contact.piston-nail.axial" -> {"piston-nail", "axial"} for the prefix "contact."
std::array<std::string, 2> parts_of(const std::string& name, const std::string& prefix) {
    const std::size_t dot = name.find('.', prefix.size());
    return {name.substr(prefix.size(), dot - prefix.size()),
            dot == std::string::npos ? "" : name.substr(dot + 1)};
}

}  // namespace

std::vector<PlotInfo> plots_of(const Scene& scene, const std::vector<HistoryColumn>& columns) {
    const bool axisymmetric = scene.geometry == Geometry::axisymmetric;
    std::vector<PlotInfo> plots;
    const auto plot = [&](const std::string& name, const std::string& title, Quantity quantity) -> PlotInfo& {
        for (PlotInfo& made : plots)
            if (made.name == name) return made;
        plots.push_back({name, title, quantity, {}});
        return plots.back();
    };
    const auto by_direction = [&](const std::string& kind, const std::string& title, Quantity quantity,
                                  const std::string& direction) -> PlotInfo& {
        PlotInfo& made = plot(kind + "." + direction,
                              axisymmetric ? direction + " " + title : title + " " + direction, quantity);
        made.folded = axisymmetric && direction == "radial";  // the axis is the main direction
        return made;
    };
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const auto& [name, quantity] = columns[i];
        if (name.starts_with("contact.") && quantity == Quantity::force) {
            const auto [pair, what] = parts_of(name, "contact.");
            const std::string direction = what.substr(what.rfind('.') + 1);
            const bool friction = what.starts_with("friction.");
            by_direction(friction ? "friction" : "forces", friction ? "friction force" : "contact force",
                         quantity, direction)
                .curves.push_back({i, pair});
        } else if (name.starts_with("body.") && quantity == Quantity::velocity) {
            const auto [body, what] = parts_of(name, "body.");
            by_direction("velocities", "mean velocity", quantity, what.substr(what.rfind('.') + 1))
                .curves.push_back({i, body});
        } else if (name.starts_with("energy.")) {
            const std::string what = name.substr(7);
            const bool first = what == "kinetic" || what == "internal" || what == "plastic" ||
                               what == "balance" || what == "friction";
            plot("energies", "energy", quantity)
                .curves.push_back({i, what == "balance" ? "balance e" : what, first});
        } else if (name.starts_with("step.")) {
            plot("step", "time step", quantity)
                .curves.push_back({i, name == "step.dt" ? "step" : "critical"});
        } else if (name.starts_with("probe.")) {
            const auto [probe, what] = parts_of(name, "probe.");
            plot("probes." + what, "probes: " + what, quantity).curves.push_back({i, probe});
        }
    }
    // Folded ones last of their kind would part what belongs together; those that are open come first.
    std::stable_partition(plots.begin(), plots.end(), [](const PlotInfo& made) { return !made.folded; });
    return plots;
}

void Curves::follow(std::shared_ptr<const History> history) {
    if (history != history_) {
        history_ = std::move(history);
        times_ = {};
        columns_.clear();
    }
    if (!history_) return;
    const std::size_t before = times_.size(), now = history_->rows();
    if (now == before) return;
    times_.append(history_->values(0, before, now));
    for (auto& [index, column] : columns_) column.append(history_->values(index, before, now));
}

const MinMaxPyramid& Curves::column(std::size_t index) {
    const auto [place, fresh] = columns_.try_emplace(index);
    if (fresh && history_) place->second.append(history_->values(index, 0, times_.size()));
    return place->second;
}

std::size_t Curves::row_at(double time) const {
    std::size_t low = 0, high = times_.size();
    while (low < high) {
        const std::size_t middle = (low + high) / 2;
        if (times_[middle] < time)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

void decimate(const Curves& curves, const MinMaxPyramid& values, double from, double to, int parts,
              std::vector<CurvePoint>& points) {
    points.clear();
    const MinMaxPyramid& times = curves.times();
    const std::size_t begin = curves.row_at(from), end = curves.row_at(to);
    const auto add = [&](std::size_t row) {
        if (std::isfinite(values[row])) points.push_back({times[row], values[row]});
    };
    if (begin > 0) add(begin - 1);
    if (end - begin <= 2 * static_cast<std::size_t>(std::max(parts, 1))) {
        for (std::size_t row = begin; row < end; ++row) add(row);
    } else {
        std::size_t row = begin;
        for (int part = 0; part < parts && row < end; ++part) {
            const double until = from + (to - from) * (part + 1) / parts;
            const std::size_t next = part + 1 == parts ? end : std::min(curves.row_at(until), end);
            if (next == row) continue;
            const MinMax extremes = values.range(row, next);
            if (extremes.low <= extremes.high) {
                const double middle = 0.5 * (times[row] + times[next - 1]);
                const double last = points.empty() ? extremes.low : points.back().value;
                const bool low_first = std::abs(last - extremes.low) <= std::abs(last - extremes.high);
                points.push_back({middle, low_first ? extremes.low : extremes.high});
                if (extremes.high > extremes.low)
                    points.push_back({middle, low_first ? extremes.high : extremes.low});
            }
            row = next;
        }
    }
    if (end < curves.rows()) add(end);
}

}  // namespace percuss::app
