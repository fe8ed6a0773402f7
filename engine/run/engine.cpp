#include "run/engine.hpp"

#include <utility>

#include "run/engine_thread.hpp"

namespace percuss {

Engine::Engine(Scene scene, EngineOptions options)
    : impl_(std::make_unique<Impl>(std::move(scene), std::move(options))) {}

Engine::~Engine() {
    post(command::Stop{});
    impl_->thread.join();
}

void Engine::post(Command command) {
    const std::lock_guard lock(impl_->mutex);
    if (impl_->ended) return;
    impl_->commands.push_back(std::move(command));
    impl_->idle = false;
    impl_->commands_waiting.store(true, std::memory_order_release);
    impl_->work_came.notify_one();
}

std::shared_ptr<const Snapshot> Engine::snapshot() {
    impl_->snapshot_wanted = true;
    const std::lock_guard lock(impl_->mutex);
    return impl_->published;
}

std::shared_ptr<const History> Engine::history() const {
    const std::lock_guard lock(impl_->mutex);
    return impl_->history;
}

std::shared_ptr<const FrameHistory> Engine::frames() const {
    const std::lock_guard lock(impl_->mutex);
    return impl_->scrub_frames;
}

std::shared_ptr<const Snapshot> Engine::frame_at(double time) const {
    std::shared_ptr<const Snapshot> newest;
    std::shared_ptr<const FrameHistory> frames;
    {
        const std::lock_guard lock(impl_->mutex);
        newest = impl_->published;
        frames = impl_->scrub_frames;
    }
    if (!frames) return nullptr;
    auto kept = frames->at_or_before(time).first;
    return newest->time <= time && (!kept || kept->time < newest->time) ? newest : kept;
}

std::shared_ptr<const Scene> Engine::scene() const {
    const std::lock_guard lock(impl_->mutex);
    return impl_->scene_as_set;
}

Timeline Engine::timeline() const {
    Timeline timeline;
    std::shared_ptr<const StateHistory> states;
    std::shared_ptr<const FrameHistory> frames;
    {
        const std::lock_guard lock(impl_->mutex);
        timeline.present = impl_->end ? impl_->published->time : impl_->time.load();
        timeline.end = impl_->end.value_or(timeline.present);
        states = impl_->states;
        frames = impl_->scrub_frames;
    }
    if (timeline.end > timeline.present) timeline.branch_drops = {timeline.present, timeline.end};
    if (states) {
        timeline.kept_states = states->times();
        timeline.state_bytes = states->bytes();
    }
    if (frames) {
        timeline.frames = frames->times();
        timeline.frame_bytes = frames->bytes();
    }
    return timeline;
}

RunProgress Engine::progress() const {
    RunProgress progress{impl_->status, impl_->time, impl_->step, impl_->speed, {}};
    const std::lock_guard lock(impl_->mutex);
    progress.target_speed = impl_->target_speed;
    return progress;
}

std::vector<Trace> Engine::traces() const {
    const std::lock_guard lock(impl_->mutex);
    return impl_->traces;
}

std::vector<SetProbe> Engine::probes() const {
    const std::lock_guard lock(impl_->mutex);
    return impl_->probes;
}

RunStatistics Engine::statistics() const {
    const std::lock_guard lock(impl_->mutex);
    return impl_->statistics;
}

RunStatus Engine::status() const { return impl_->status; }

std::vector<std::string> Engine::take_messages() {
    const std::lock_guard lock(impl_->mutex);
    return std::exchange(impl_->messages, {});
}

void Engine::wait() {
    std::unique_lock lock(impl_->mutex);
    impl_->fell_idle.wait(lock, [this] { return impl_->idle && impl_->commands.empty(); });
}

}  // namespace percuss
