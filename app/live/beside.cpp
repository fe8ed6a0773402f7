#include "live/beside.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace percuss::app {
namespace {

EngineOptions modest(int threads) {
    EngineOptions options;
    options.threads = threads;
    options.state_memory = 0;  // it is never set back: the kept moments are what is looked at
    return options;
}

bool is_of_scheme(const std::string& key) {
    return key == "contact_solver.scheme" || key == "model.lagged" ||
           (key.starts_with("contact.") && (key.ends_with(".sign") || key.ends_with(".scheme")));
}

}  // namespace

BesideRun::BesideRun(const std::filesystem::path& file, const std::vector<std::string>& overrides,
                     std::string label, int threads)
    : run_(modest(threads)), label_(std::move(label)) {
    run_.open(file, overrides);
}

void BesideRun::follow(double reached, double shown) {
    run_.update();
    if (!run_.newest()) {
        busy_ = run_.building();
        return;
    }
    const Snapshot& newest = *run_.newest();
    const bool ended = run_.status() == RunStatus::finished || run_.status() == RunStatus::diverged;
    busy_ = !ended && newest.time < reached;
    if (busy_) run_.run(reached);  // no further: the window's run sets the pace
    // A run that waits is at the first step that reached the time, less than a step beyond it.
    if (std::abs(newest.time - shown) <= newest.dt || newest.time < shown)
        moment_ = run_.newest();
    else if (auto kept = run_.frame_at(shown))
        moment_ = std::move(kept);
    curves_.follow(run_.history());
}

std::optional<std::size_t> BesideRun::column(const std::string& name) const {
    return column_named(run_.history(), name);
}

std::string label_of(const LiveRun& run) {
    std::string label;
    for (const SchemeChoice& choice : run.schemes())
        if (choice.present) label = choice.name;
    for (const std::string& setting : run.overrides()) {
        const std::string key = setting.substr(0, setting.find('='));
        if (is_of_scheme(key)) continue;
        label += (label.empty() ? "" : ", ") + key.substr(key.rfind('.') + 1) + " " +
                 setting.substr(std::min(key.size() + 1, setting.size()));
    }
    return label;
}

}  // namespace percuss::app
