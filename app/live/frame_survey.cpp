#include "live/frame_survey.hpp"

#include <algorithm>

#include "live/probe_curves.hpp"

namespace percuss::app {

void FrameSurvey::add(const RunSetup& setup, const Probe& probe) {
    Reader reader{probe, bind_probe(setup.scene, setup.mesh, probe), nullptr};
    std::vector<HistoryColumn> columns{{"time", Quantity::time}};
    for (const ProbeReading& reading : reader.readings)
        columns.push_back({"probe." + probe.name + "." + reading.field.name, reading.field.quantity});
    reader.rows = std::make_shared<History>(std::move(columns));
    readers_.push_back(std::move(reader));
}

void FrameSurvey::remove(const std::string& name) {
    std::erase_if(readers_, [&](const Reader& reader) { return reader.probe.name == name; });
}

std::int64_t FrameSurvey::next(std::int64_t frames) const {
    std::int64_t least = frames;
    for (const Reader& reader : readers_) least = std::min(least, reader.next);
    return least < frames ? least : -1;
}

void FrameSurvey::take(std::int64_t index, const Snapshot* frame) {
    for (Reader& reader : readers_) {
        if (reader.next != index) continue;
        ++reader.next;
        if (frame == nullptr) continue;
        std::vector<double> row{frame->time};
        for (const ProbeReading& reading : reader.readings) row.push_back(value_of(*frame, reading));
        reader.rows->append(row);
    }
}

std::vector<SetProbe> FrameSurvey::probes() const {
    std::vector<SetProbe> all;
    for (const Reader& reader : readers_) all.push_back({reader.probe, reader.rows});
    return all;
}

}  // namespace percuss::app
