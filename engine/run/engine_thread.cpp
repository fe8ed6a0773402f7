#include "run/engine_thread.hpp"

#include <chrono>
#include <exception>
#include <utility>

namespace percuss {
namespace {

constexpr double kept_frames_in_a_run = 500;
/// A longer wait for a step's turn shows as a picture that stands still.
constexpr std::chrono::milliseconds worth_a_snapshot{10};

}  // namespace

Engine::Impl::Impl(Scene scene_in, EngineOptions options_in)
    : scene(std::move(scene_in)), options(std::move(options_in)), run(make_run(scene)) {
    begin_run();
    thread = std::thread([this] { serve(); });
}

std::unique_ptr<TravellingRun> Engine::Impl::make_run(const Scene& of) const {
    return std::make_unique<TravellingRun>(of, options.threads, options.state_memory, options.history_memory);
}

void Engine::Impl::begin_run() {
    frames = kept_frame = 0;
    kept_frames.reset();
    if (options.frame_memory > 0) kept_frames = std::make_shared<FrameHistory>(options.frame_memory, 1);
    kept_frame_interval = options.frame_memory_interval.value_or(scene.duration / kept_frames_in_a_run);
    failure = {};
    state = RunStatus::paused;
    publish(true);
}

std::shared_ptr<const Snapshot> Engine::Impl::take_snapshot() const {
    auto snapshot = solver().snapshot();
    snapshot->status = state;
    snapshot->message = failure.message;
    snapshot->failed_cell = failure.cell;
    return snapshot;
}

void Engine::Impl::publish(bool complete) {
    auto snapshot = take_snapshot();
    // The newest moment is kept whether its time has come or not: a run that is set back can show it.
    if (complete && kept_frames && !run->end())
        kept_frames->set_newest(kept_frame, snapshot->time, snapshot, memory_of(*snapshot));
    RunStatistics counted = solver().statistics(complete);
    counted.seconds.history = run->record().seconds();
    counted.step_seconds += counted.seconds.history;
    published_step = snapshot->step;
    time = snapshot->time;
    step = snapshot->step;
    speed = state == RunStatus::running ? pace.speed() : 0;
    const std::lock_guard lock(mutex);
    published = std::move(snapshot);
    history = run->record().history();
    traces = run->record().traces();
    probes = run->probes().probes();
    states = run->states();
    scrub_frames = kept_frames;
    end = run->end();
    statistics = std::move(counted);
    if (!scene_as_set) scene_as_set = std::make_shared<const Scene>(scene);
    status = state;
}

void Engine::Impl::emit_frame() {
    if (options.on_frame) options.on_frame(take_snapshot());
}

bool Engine::Impl::reached(double when) const { return solver().time() >= when * (1 - 1e-12); }

bool Engine::Impl::emits_frames() const { return options.on_frame && options.frame_interval; }

void Engine::Impl::emit_due_frame() {
    if (!emits_frames() || !reached(static_cast<double>(frames) * *options.frame_interval)) return;
    emit_frame();
    skip_reached_frames();
}

void Engine::Impl::skip_reached_frames() {
    if (!emits_frames()) return;
    while (reached(static_cast<double>(frames) * *options.frame_interval)) ++frames;
}

std::int64_t Engine::Impl::multiple_of_kept_frames() const {
    return static_cast<std::int64_t>(solver().time() / kept_frame_interval * (1 + 1e-12));
}

void Engine::Impl::keep_due_frame() {
    if (!kept_frames) return;
    const std::int64_t multiple = multiple_of_kept_frames();
    if (multiple == kept_frame) return;
    kept_frame = multiple;
    if (!kept_frames->due(kept_frame)) return;
    const auto snapshot = take_snapshot();
    kept_frames->add(kept_frame, snapshot->time, snapshot, memory_of(*snapshot));
}

void Engine::Impl::end_run(RunStatus how) {
    state = how;
    emit_frame();
    publish(true);
}

void Engine::Impl::step_once() {
    emit_due_frame();
    keep_due_frame();
    auto divergence = run->step();
    pace.count(solver().time(), Pace::Clock::now());
    time = solver().time();
    step = solver().steps();
    speed = pace.speed();
    if (divergence) {
        failure = std::move(*divergence);
        end_run(RunStatus::diverged);
    } else if (solver().finished()) {
        end_run(RunStatus::finished);
    } else if (--steps_left <= 0 || reached(pause_at)) {
        state = RunStatus::paused;
        publish(true);
    } else if (snapshot_wanted.exchange(false)) {
        publish(false);
    }
}

bool Engine::Impl::is_due() {
    if (!paced) return true;
    const auto now = Pace::Clock::now();
    const auto until = pace.wait_until(solver().time(), now);
    if (!until) return true;
    // Whoever looks while nothing happens sees the present state.
    if (published_step != solver().steps() && *until - now > worth_a_snapshot) publish(false);
    std::unique_lock lock(mutex);
    work_came.wait_until(lock, *until, [this] { return !commands.empty(); });
    return false;
}

std::optional<Command> Engine::Impl::next_command() {
    const bool running = state == RunStatus::running;
    if (running && !commands_waiting.load(std::memory_order_acquire)) return std::nullopt;
    std::unique_lock lock(mutex);
    if (!running && commands.empty()) {
        idle = true;
        fell_idle.notify_all();
        work_came.wait(lock, [this] { return !commands.empty(); });
        idle = false;
    }
    if (commands.empty()) return std::nullopt;
    Command command = std::move(commands.front());
    commands.pop_front();
    commands_waiting.store(!commands.empty(), std::memory_order_release);
    return command;
}

void Engine::Impl::serve() {
    while (!stop) {
        try {
            while (const auto command = next_command()) {
                obey(*command);
                if (stop) break;
            }
            if (!stop && state == RunStatus::running && is_due()) step_once();
        } catch (const std::exception& error) {
            // A full disk in the recorder, memory that ran out: the run ends, the program goes on.
            failure = {error.what(), -1};
            options.on_frame = nullptr;
            state = RunStatus::diverged;
            publish(true);
        }
    }
    const std::lock_guard lock(mutex);
    commands.clear();
    idle = ended = true;
    fell_idle.notify_all();
}

}  // namespace percuss
