// What a LiveRun does with the run that is there: run control, probes and time travel.
#include <algorithm>
#include <limits>
#include <utility>

#include "live/live_run.hpp"

namespace percuss::app {
namespace {

constexpr double seconds_to_play_a_run = 10;

}  // namespace

void LiveRun::add_probe(Probe probe) {
    if (!engine_ && !recording_) return;
    if (engine_) engine_->post(command::AddProbe{probe});
    if (recording_) recording_->add_probe(probe);
    probes_.push_back(std::move(probe));
}

void LiveRun::remove_probe(const std::string& name) {
    if (engine_) engine_->post(command::RemoveProbe{name});
    if (recording_) recording_->remove_probe(name);
    std::erase_if(probes_, [&](const Probe& probe) { return probe.name == name; });
}

std::vector<SetProbe> LiveRun::probe_rows() const {
    if (recording_) return recording_->probes();
    return engine_ ? engine_->probes() : std::vector<SetProbe>{};
}

void LiveRun::run(std::optional<double> until) {
    if (recording_ && until) look_at(*until);
    if (recording_ && !until) play();
    if (!engine_) return;
    go_live();
    if (status_ == RunStatus::finished || status_ == RunStatus::diverged) reset();
    engine_->post(command::Run{until});
    begun_ = true;
}

void LiveRun::pause() {
    if (recording_) stop_playing();
    if (!engine_) return;
    go_live();
    engine_->post(command::Pause{});
    begun_ = false;
}

void LiveRun::step(std::int64_t count) {
    if (recording_) look_step(count);
    if (!engine_) return;
    go_live();
    engine_->post(command::Steps{count});
}

void LiveRun::reset() {
    if (recording_) look_at(timeline_.frames.front());
    if (!engine_) return;
    playhead_.go_live();
    branch_.reset();
    set_back_ = false;
    engine_->post(command::Reset{});
    begun_ = false;
}

void LiveRun::set_speed(std::optional<double> speed) {
    wanted_speed_ = speed;
    if (engine_) engine_->post(command::SetSpeed{speed});
}

double LiveRun::playing_speed() const {
    return wanted_speed_.value_or(timeline_.end / seconds_to_play_a_run);
}

void LiveRun::look_at(double time) {
    if (!snapshot_) return;
    if (branch_ && !branch_->confirmed) cancel_branch();
    if (engine_ && newest_ && time >= newest_->time)
        go_live();
    else
        playhead_.look_at(std::clamp(time, 0.0, timeline_.end));
}

void LiveRun::settle() {
    if (live()) return;
    if (engine_ && status_ != RunStatus::running) {
        engine_->post(command::Seek{playhead_.time()});
        set_back_ = true;
    } else if (const auto kept = frame_at(playhead_.time())) {
        playhead_.look_at(kept->time);
    }
}

void LiveRun::look_step(std::int64_t count) {
    const std::vector<double>& times = timeline_.frames;
    if (times.empty() || count == 0) return;
    stop_playing();
    // Of a recorded run the frame that is shown may not be there yet; what counts is the one asked for.
    const double from = recording_ ? times[static_cast<std::size_t>(recording_->index_at(playhead_.time()))]
                                   : snapshot_->time;
    const double slack = 1e-12 * from;
    std::ptrdiff_t index = 0;
    if (count > 0)
        index = std::upper_bound(times.begin(), times.end(), from + slack) - times.begin() - 1 + count;
    else
        index = std::lower_bound(times.begin(), times.end(), from - slack) - times.begin() + count;
    const auto last = static_cast<std::ptrdiff_t>(times.size()) - 1;
    if (recording_) index = std::min(index, last);
    if (index > last)
        go_live();
    else
        look_at(times[static_cast<std::size_t>(std::max<std::ptrdiff_t>(index, 0))]);
}

void LiveRun::go_live() {
    if (recording_) {
        stop_playing();
        look_at(timeline_.end);
        return;
    }
    playhead_.go_live();
    cancel_branch();
    return_to_end();
}

void LiveRun::return_to_end() {
    if (std::exchange(set_back_, false))
        engine_->post(command::Seek{std::numeric_limits<double>::infinity()});
}

void LiveRun::play() {
    if (recording_ && playhead_.time() >= timeline_.end) look_at(timeline_.frames.front());
    playhead_.play(Playhead::Clock::now());
}

void LiveRun::ask_branch() {
    if (!engine_ || live() || branch_) return;
    stop_playing();
    branch_ = Branch{snapshot_->time, status_ == RunStatus::running, false};
    playhead_.look_at(branch_->from);
    engine_->post(command::Seek{branch_->from});
    set_back_ = true;
}

std::optional<std::array<double, 2>> LiveRun::branch_drops() const {
    if (!branch_ || !sought_ || sought_->time < branch_->from) return std::nullopt;
    return timeline_.branch_drops;
}

void LiveRun::confirm_branch() {
    if (!branch_drops()) return;
    engine_->post(command::Run{});
    branch_->confirmed = true;  // what is shown stays until the engine has gone on
    set_back_ = false;
}

void LiveRun::cancel_branch() {
    const auto asked = std::exchange(branch_, std::nullopt);
    if (!asked || !asked->was_running) return;
    return_to_end();
    engine_->post(command::Run{});
}

std::shared_ptr<const Snapshot> LiveRun::looked_at() const {
    const double time = playhead_.time();
    const auto is_it = [time](const Snapshot& moment) {
        return moment.time >= time * (1 - 1e-12) && (moment.step == 0 || moment.time - moment.dt < time);
    };
    if (sought_ && is_it(*sought_)) return sought_;
    auto kept = engine_->frame_at(time);
    return kept ? kept : newest_;
}

std::shared_ptr<const Snapshot> LiveRun::frame_at(double time) const {
    if (recording_) return recording_->frame_at(time);
    return engine_ ? engine_->frame_at(time) : nullptr;
}

std::function<std::shared_ptr<const Snapshot>(double)> LiveRun::moments() const {
    if (recording_) return [recording = recording_](double time) { return recording->frame_at(time); };
    if (!engine_) return [](double) { return nullptr; };
    return [frames = engine_->frames()](double time) {
        return frames ? frames->at_or_before(time).first : nullptr;
    };
}

}  // namespace percuss::app
