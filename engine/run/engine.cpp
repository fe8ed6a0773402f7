#include "run/engine.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <exception>
#include <limits>
#include <utility>
#include <vector>

#include "run/history_columns.hpp"
#include "scene/parse.hpp"
#include "solver.hpp"

namespace percuss {
namespace {

/// Steps between copies of the state from which a diverged run goes back to its last good step.
constexpr std::int64_t steps_between_safe_states = 256;

template <class... Handlers>
struct Overloaded : Handlers... {
    using Handlers::operator()...;
};

}  // namespace

struct Engine::Impl {
    Impl(Scene scene_in, EngineOptions options_in)
        : scene(std::move(scene_in)), options(std::move(options_in)), solver(make_solver(scene)) {
        begin_run();
        thread = std::thread([this] { serve(); });
    }

    std::unique_ptr<Solver> make_solver(const Scene& of) const {
        return std::make_unique<Solver>(of, options.threads);
    }

    // Owned by the engine thread once it runs.
    Scene scene;
    EngineOptions options;
    std::unique_ptr<Solver> solver;
    std::shared_ptr<History> recording;
    std::unique_ptr<TraceRecorder> tracing;
    SolverState safe_state;
    std::int64_t next_safe_state = 0;
    std::int64_t frames = 0;
    double history_seconds = 0;
    double pause_at = 0;
    std::int64_t steps_left = 0;
    RunStatus state = RunStatus::paused;
    std::string message;
    bool stop = false;

    // Shared, each behind `mutex`, which is held only to copy or swap a pointer or a small value.
    mutable std::mutex mutex;
    std::condition_variable work_came, fell_idle;
    std::deque<Command> commands;
    bool idle = false, ended = false;
    std::shared_ptr<const Snapshot> published;
    std::shared_ptr<const History> history;
    std::vector<Trace> traces;
    RunStatistics statistics;
    std::vector<std::string> messages;

    std::atomic<bool> commands_waiting{false}, snapshot_wanted{false};
    std::atomic<RunStatus> status{RunStatus::paused};
    std::thread thread;

    void begin_run() {
        recording = std::make_shared<History>(history_columns(solver->setup()->scene));
        tracing = std::make_unique<TraceRecorder>(*solver->setup());
        frames = 0;
        next_safe_state = 0;
        history_seconds = 0;
        message.clear();
        state = RunStatus::paused;
        publish(true);
    }

    std::shared_ptr<const Snapshot> take_snapshot() const {
        auto snapshot = solver->snapshot();
        snapshot->status = state;
        snapshot->message = message;
        return snapshot;
    }

    void publish(bool complete) {
        auto snapshot = take_snapshot();
        RunStatistics counted = solver->statistics(complete);
        counted.seconds.history = history_seconds;
        counted.step_seconds += history_seconds;
        const std::lock_guard lock(mutex);
        published = std::move(snapshot);
        history = recording;
        traces = tracing->traces();
        statistics = std::move(counted);
        status = state;
    }

    void emit_frame() {
        if (options.on_frame) options.on_frame(take_snapshot());
    }

    bool reached(double time) const { return solver->time() >= time * (1 - 1e-12); }

    void emit_due_frame() {
        if (!options.on_frame || !options.frame_interval) return;
        if (!reached(static_cast<double>(frames) * *options.frame_interval)) return;
        emit_frame();
        // A step that jumps over several frame times gives one frame, the newest.
        while (reached(static_cast<double>(frames) * *options.frame_interval)) ++frames;
    }

    void end_run(RunStatus how) {
        state = how;
        emit_frame();
        publish(true);
    }

    /// Goes back to the last step before `failed_step` whose stresses are known to be sound.
    void diverge(std::string why, std::int64_t failed_step) {
        solver->restore(safe_state);
        while (solver->steps() < failed_step - 1) {
            if (!solver->step()) continue;
            solver->restore(safe_state);
            break;
        }
        message = std::move(why);
        end_run(RunStatus::diverged);
    }

    template <class Sampling>
    void trace(Sampling sampling) {
        if (tracing->none()) return;
        const auto before = std::chrono::steady_clock::now();
        sampling();
        history_seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - before).count();
    }

    void append_history(double time) {
        const auto before = std::chrono::steady_clock::now();
        const auto row = solver->history_row();
        // A step that failed early left the row of the one before, one that diverged may have left no
        // numbers.
        const bool sound = row.front() == time &&
                           std::all_of(row.begin(), row.end(), [](double x) { return std::isfinite(x); });
        if (sound) recording->append(row);
        history_seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - before).count();
    }

    void step_once() {
        if (solver->steps() >= next_safe_state) {
            safe_state = solver->save();
            next_safe_state = solver->steps() + steps_between_safe_states;
        }
        emit_due_frame();
        const double time = solver->time();
        const std::int64_t step = solver->steps();
        trace([&] { tracing->before_step(*solver); });
        const auto divergence = solver->step();
        if (!divergence) trace([&] { tracing->after_step(*solver, time); });
        append_history(time);
        if (divergence) {
            diverge(divergence->message, step);
        } else if (solver->finished()) {
            end_run(RunStatus::finished);
        } else if (--steps_left <= 0 || reached(pause_at)) {
            state = RunStatus::paused;
            publish(true);
        } else if (snapshot_wanted.exchange(false)) {
            publish(false);
        }
    }

    void start(double until, std::int64_t steps) {
        if (state == RunStatus::finished || state == RunStatus::diverged) {
            say("the run has ended; reset it to run again");
            return;
        }
        if (steps <= 0 || reached(until)) return;
        pause_at = until;
        steps_left = steps;
        state = RunStatus::running;
        status = state;
    }

    void say(std::string text) {
        const std::lock_guard lock(mutex);
        messages.push_back(std::move(text));
    }

    void set(const command::Set& command) {
        std::vector<std::string> overrides = scene.overrides;
        overrides.push_back(command.key + "=" + command.value);
        try {
            Scene changed = parse_scene(scene.text, scene.file, overrides);
            if (command.key.starts_with("model.step.")) {
                solver->set_step(changed.step);
                scene = std::move(changed);
                next_safe_state = solver->steps();  // steps from here on are not those of the copy
                return;
            }
            auto fresh = make_solver(changed);
            static_cast<void>(TraceRecorder(*fresh->setup()));  // throws before anything is changed
            scene = std::move(changed);
            solver = std::move(fresh);
            begin_run();
        } catch (const SceneError& error) {
            for (const std::string& line : error.messages()) say(line);
        } catch (const std::exception& error) {
            say(command.key + " = " + command.value + ": " + error.what());
        }
    }

    void obey(const Command& command) {
        constexpr double forever = std::numeric_limits<double>::infinity();
        constexpr auto no_limit = std::numeric_limits<std::int64_t>::max();
        const bool counting = state == RunStatus::running && steps_left < no_limit;
        std::visit(Overloaded{[&](const command::Run& run) { start(run.until.value_or(forever), no_limit); },
                              [&](const command::Steps& steps) {
                                  start(forever, steps.count + (counting ? steps_left : 0));
                              },
                              [&](const command::Pause&) {
                                  if (state == RunStatus::running) state = RunStatus::paused;
                                  publish(true);
                              },
                              [&](const command::Reset&) {
                                  solver = make_solver(scene);
                                  begin_run();
                              },
                              [&](const command::Set& what) { set(what); },
                              [&](const command::Stop&) {
                                  if (state == RunStatus::running) state = RunStatus::paused;
                                  publish(true);
                                  stop = true;
                              }},
                   command);
    }

    /// Takes the next command, waiting for one when there is nothing to step.
    std::optional<Command> next_command() {
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

    void serve() {
        while (!stop) {
            try {
                while (const auto command = next_command()) {
                    obey(*command);
                    if (stop) break;
                }
                if (!stop && state == RunStatus::running) step_once();
            } catch (const std::exception& error) {
                // A full disk in the recorder, memory that ran out: the run ends, the program goes on.
                message = error.what();
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
};

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

std::vector<Trace> Engine::traces() const {
    const std::lock_guard lock(impl_->mutex);
    return impl_->traces;
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
