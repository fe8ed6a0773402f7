#include "live/curves.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

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
        } else if (name.starts_with("contact.") && name.ends_with(".changes")) {
            PlotInfo& made = plot("events", "open/close events", quantity);
            made.rate = true;
            made.curves.push_back({i, parts_of(name, "contact.")[0]});
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

void Curves::follow(std::shared_ptr<const History> history, std::vector<double> past) {
    if (history != history_) {
        history_ = std::move(history);
        past_ = std::move(past);
        past_rows_ = history_ ? past_.size() / history_->columns().size() : 0;
        times_ = MinMaxPyramid();
        columns_.clear();
        times_.append(past_column(0));
    }
    if (!history_) return;
    const std::size_t before = times_.size() - past_rows_, now = history_->rows();
    if (now == before) return;
    append(0, before, now, times_);
    for (auto& [index, column] : columns_) append(index, before, now, column);
}

/// In pieces: a whole column of a long run is larger than what is kept of it.
void Curves::append(std::size_t index, std::size_t begin, std::size_t end, MinMaxPyramid& to) const {
    constexpr std::size_t piece = std::size_t{1} << 16;
    for (; begin < end; begin += piece)
        to.append(history_->values(index, begin, std::min(begin + piece, end)));
}

std::vector<double> Curves::past_column(std::size_t index) const {
    std::vector<double> column;
    for (std::size_t row = 0; row < past_rows_; ++row)
        column.push_back(past_[row * history_->columns().size() + index]);
    return column;
}

const MinMaxPyramid& Curves::column(std::size_t index) {
    const auto [place, fresh] = columns_.try_emplace(index);
    if (fresh && history_) {
        place->second.append(past_column(index));
        append(index, 0, times_.size() - past_rows_, place->second);
    }
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
        if (row < values.thinned()) {  // somewhere between them
            const MinMax extremes = values.range(row, row + 1);
            if (extremes.low > extremes.high) return;
            points.push_back({times[row], extremes.low});
            points.push_back({times[row], extremes.high});
        } else if (std::isfinite(values[row])) {
            points.push_back({times[row], values[row]});
        }
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

void straighten(std::vector<std::array<float, 2>>& line, float tolerance) {
    if (line.size() < 3) return;
    constexpr float any = std::numeric_limits<float>::infinity();
    std::size_t kept = 0;                 // what stays is moved to the front: line[kept] is the last of it
    std::array<float, 2> last = line[0];  // the newest point that may still be dropped
    bool pending = false;
    float least = -any, greatest = any;  // slopes from line[kept] that pass all points since near enough
    const auto keep = [&](const std::array<float, 2>& point) {
        line[++kept] = point;
        pending = false;
        least = -any, greatest = any;
    };
    for (std::size_t i = 1; i < line.size(); ++i) {
        const std::array<float, 2> point = line[i];
        // Twice at most: when the point before must stay, the strip begins anew from there.
        for (;;) {
            const float along = point[0] - line[kept][0], up = point[1] - line[kept][1];
            const bool passes =
                along > 0 ? up >= least * along && up <= greatest * along : std::abs(up) <= tolerance;
            if (passes && along > 0) {
                least = std::max(least, (up - tolerance) / along);
                greatest = std::min(greatest, (up + tolerance) / along);
            }
            if (passes || !pending) {
                if (!passes) keep(point);
                last = point;
                pending = passes;
                break;
            }
            keep(last);
        }
    }
    if (pending) line[++kept] = last;
    line.resize(kept + 1);
}

double rate_at(const Curves& curves, const MinMaxPyramid& counts, double time, double window) {
    const std::size_t rows = curves.rows();
    if (rows == 0) return 0;
    const double begin = curves.times()[0], end = curves.times()[rows - 1];
    const double from = std::max(time - 0.5 * window, begin), to = std::min(time + 0.5 * window, end);
    if (!(from < to)) return 0;
    // A window belongs to the steps that begin in it: [from, to), but with the last step of all.
    const auto before = [&](double t) {
        const std::size_t row = t >= end - 1e-9 * window ? rows : curves.row_at(t);
        return row == 0 ? 0 : counts[row - 1];
    };
    return (before(to) - before(from)) / (to - from);
}

void rates(const Curves& curves, const MinMaxPyramid& counts, double from, double to, int parts,
           double window, std::vector<CurvePoint>& points) {
    points.clear();
    const std::size_t rows = curves.rows();
    if (rows < 2 || !(from < to)) return;
    const double part = (to - from) / parts, wide = std::max(window, part);
    const double begin = curves.times()[0], end = curves.times()[rows - 1];
    for (int k = 0; k < parts; ++k) {
        const double time = from + (k + 0.5) * part;
        if (time + 0.5 * part < begin || time - 0.5 * part > end) continue;
        points.push_back({time, rate_at(curves, counts, time, wide)});
    }
}

}  // namespace percuss::app
