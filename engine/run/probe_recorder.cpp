#include "run/probe_recorder.hpp"

#include <algorithm>
#include <stdexcept>

#include "solver.hpp"

namespace percuss {

void ProbeRecorder::add(const RunSetup& setup, const Probe& probe) {
    const bool taken = std::any_of(entries_.begin(), entries_.end(),
                                   [&](const Entry& entry) { return entry.probe.name == probe.name; });
    if (taken) throw std::invalid_argument("there is a probe '" + probe.name + "' already");
    if (const std::string fault = fault_of_probe(setup.scene, setup.mesh, probe); !fault.empty())
        throw std::invalid_argument(fault);

    Entry entry{probe, bind_probe(setup.scene, setup.mesh, probe), {}, {}, nullptr};
    std::vector<HistoryColumn> columns{{"time", Quantity::time}};
    for (const ProbeReading& reading : entry.readings)
        columns.push_back({"probe." + probe.name + "." + reading.field.name, reading.field.quantity});
    entry.row.resize(columns.size());
    entry.before.resize(entry.readings.size());
    entry.rows = std::make_shared<History>(std::move(columns), history_memory_);
    entries_.push_back(std::move(entry));
}

void ProbeRecorder::remove(std::string_view name) {
    std::erase_if(entries_, [&](const Entry& entry) { return entry.probe.name == name; });
}

std::vector<SetProbe> ProbeRecorder::probes() const {
    std::vector<SetProbe> all;
    for (const Entry& entry : entries_) all.push_back({entry.probe, entry.rows});
    return all;
}

void ProbeRecorder::before_step(const Solver& solver) {
    for (Entry& entry : entries_) {
        for (std::size_t k = 0; k < entry.readings.size(); ++k) {
            const ProbeReading& reading = entry.readings[k];
            if (reading.cell >= 0)
                entry.row[k + 1] = read_cell(reading, solver.batches(), solver.nodes().data());
            else
                entry.before[k] = solver.nodes()[static_cast<std::size_t>(reading.node)];
        }
    }
}

void ProbeRecorder::after_step(const Solver& solver, double time) {
    for (Entry& entry : entries_) {
        entry.row[0] = time;
        for (std::size_t k = 0; k < entry.readings.size(); ++k) {
            const ProbeReading& reading = entry.readings[k];
            if (reading.cell >= 0) continue;
            entry.row[k + 1] =
                read_node(reading, entry.before[k], solver.nodes()[static_cast<std::size_t>(reading.node)],
                          solver.setup()->mesh);
        }
        entry.rows->append(entry.row);
    }
}

void ProbeRecorder::branch(double time) {
    for (Entry& entry : entries_) {
        // Rows stand at the times of steps, which come again bit by bit.
        const std::vector<double> times = entry.rows->values(0, 0, entry.rows->rows());
        const auto kept = std::lower_bound(times.begin(), times.end(), time) - times.begin();
        if (static_cast<std::size_t>(kept) < times.size())
            entry.rows = entry.rows->first(static_cast<std::size_t>(kept));
    }
}

}  // namespace percuss
