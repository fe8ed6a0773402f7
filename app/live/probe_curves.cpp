#include "live/probe_curves.hpp"

#include <algorithm>
#include <limits>

#include <fmt/format.h>

namespace percuss::app {
namespace {

/// As TOML writes a text.
std::string quoted(const std::string& text) {
    std::string result = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') result += '\\';
        result += c;
    }
    return result + '"';
}

bool same_place(const Probe& a, const Probe& b) {
    return a.name == b.name && a.body == b.body && a.at == b.at && a.record == b.record;
}

}  // namespace

double value_of(const Snapshot& snapshot, const ProbeReading& reading) {
    return field_value(snapshot, reading.field,
                       static_cast<std::size_t>(reading.cell >= 0 ? reading.cell : reading.node));
}

std::array<double, 2> place_of(const Snapshot& snapshot, const ProbeReading& reading) {
    const auto at = [&](std::int32_t node) {
        const auto n = 2 * static_cast<std::size_t>(node);
        return std::array{snapshot.position[n], snapshot.position[n + 1]};
    };
    if (reading.cell < 0) return at(reading.node);
    const Cell& cell = snapshot.setup->mesh.cells[static_cast<std::size_t>(reading.cell)];
    const auto corners = static_cast<std::size_t>(corner_count(cell));
    std::array<double, 2> sum{0, 0};
    for (std::size_t i = 0; i < corners; ++i)
        for (std::size_t d = 0; d < 2; ++d) sum[d] += at(cell[i])[d] / static_cast<double>(corners);
    return sum;
}

std::vector<double> kept_readings(const LiveRun& run, const std::vector<ProbeReading>& readings,
                                  double until) {
    std::vector<double> rows;
    if (run.recorded()) return rows;  // the probe reads all of its frames anyway
    for (const double time : run.timeline().frames) {
        if (time >= until) break;
        const auto frame = run.frame_at(time);
        // A branch or reset in between leaves moments of another time or mesh.
        if (!frame || frame->time != time || frame->setup != run.snapshot()->setup) continue;
        rows.push_back(time);
        for (const ProbeReading& reading : readings) rows.push_back(value_of(*frame, reading));
    }
    return rows;
}

bool ProbeCurves::follow(const LiveRun& run) {
    const auto& snapshot = run.snapshot();
    if (!snapshot) return false;
    bool changed = snapshot->setup != setup_ && !all_.empty();
    if (snapshot->setup != setup_) {
        setup_ = snapshot->setup;
        all_.clear();
        sources_.clear();
    }
    const std::vector<SetProbe> present = run.probe_rows();
    const bool same =
        std::equal(present.begin(), present.end(), all_.begin(), all_.end(),
                   [](const SetProbe& a, const ProbeCurve& b) { return same_place(a.probe, b.probe); });
    if (!same) {
        all_.clear();
        sources_.assign(present.size(), {});
        for (const SetProbe& set : present)
            all_.push_back(
                {set.probe, bind_probe(setup_->scene, setup_->mesh, set.probe), std::make_shared<Curves>()});
        changed = true;
    }
    for (std::size_t k = 0; k < present.size(); ++k) {
        const auto& rows = present[k].rows;
        Source& source = sources_[k];
        const bool begun = rows->rows() > 0;
        if (rows != source.rows || begun != source.begun) {
            source = {rows, begun};
            const double until =
                begun ? rows->values(0, 0, 1).front() : std::numeric_limits<double>::infinity();
            all_[k].curves->follow(nullptr);
            all_[k].curves->follow(rows, kept_readings(run, all_[k].readings, until));
        }
        all_[k].curves->follow(rows);
    }
    return changed;
}

void add_probe_plots(const std::vector<ProbeCurve>& probes, std::vector<PlotInfo>& plots) {
    for (const ProbeCurve& curve : probes)
        for (std::size_t k = 0; k < curve.readings.size(); ++k) {
            const FieldInfo& field = curve.readings[k].field;
            const std::string name = "probes." + field.name;
            auto plot =
                std::find_if(plots.begin(), plots.end(), [&](const PlotInfo& p) { return p.name == name; });
            if (plot == plots.end())
                plot = plots.insert(plots.end(), {name, "probes: " + field.title, field.quantity, {}});
            plot->curves.push_back({k + 1, curve.probe.name, true, curve.curves});
        }
}

std::string free_probe_name(const Scene& scene, const std::vector<Probe>& probes) {
    for (int i = 1;; ++i) {
        const std::string name = fmt::format("p{}", i);
        const auto named = [&](const Probe& probe) { return probe.name == name; };
        if (std::none_of(scene.probes.begin(), scene.probes.end(), named) &&
            std::none_of(probes.begin(), probes.end(), named))
            return name;
    }
}

std::string probes_as_scene_text(const std::vector<Probe>& probes) {
    std::string text;
    for (const Probe& probe : probes) {
        std::string record;
        for (const std::string& quantity : probe.record)
            record += (record.empty() ? "" : ", ") + quoted(quantity);
        text += fmt::format("[[probe]]\nname = {}\nbody = {}\nat = [{:.9g}, {:.9g}]\nrecord = [{}]\n\n",
                            quoted(probe.name), quoted(probe.body), probe.at.x(), probe.at.y(), record);
    }
    return text;
}

}  // namespace percuss::app
