#include "run/engine.hpp"

#include <atomic>
#include <chrono>
#include <exception>
#include <limits>
#include <utility>
#include <vector>

#include "scene/parse.hpp"
#include "solver.hpp"

namespace percuss {
namespace {

/// Steps between copies of the state that a diverging run goes back to.
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

    std::unique_ptr<Solver> make_solver(const Scene& of) const { return std::make_unique<Solver>(of, options.threads); }

    // Owned by the engine thread once it runs.
    Scene scene;
    EngineOptions options;
    std::unique_ptr<Solver> solver;
    SolverState safe_state;
    std::int64_t next_safe_state = 0;
    std::int64_t frames = 0;
    double history_seconds = 0;
    double pause_at = 0;
    std::int64_t steps_left = std::numeric_limits<std::int64_t>::max();
    std::string message;
    bool stop = false;

    // Shared, each behind `mutex`, which is held only to copy or swap a pointer or a small value.
    mutable std::mutex mutex;
    std::condition_variable work_came, fell_idle;
    std::deque<Command> commands;
    bool idle = false;
    std::shared_ptr<const Snapshot> published;
    std::shared_ptr<History> history;
    RunStatistics statistics;
    std::vector<std::string> messages;

    std::atomic<bool> commands_waiting{false}, snapshot_wanted{false};
    std::atomic<RunStatus> status{RunStatus::paused};
    std::thread thread;

    void begin_run() {
        auto fresh = std::make_shared<History>(Solver::history_columns(solver->setup()->scene));
        {
            const std::lock_guard lock(mutex);
            history = std::move(fresh);
        }
        frames = 0;
        next_safe_state = 0;
        history_seconds = 0;
        message.clear();
        status = RunStatus::paused;
        publish(true);
    }

    void publish(bool complete) {
        auto snapshot = std::make_shared<Snapshot>(*solver->snapshot());
        snapshot->status = status;
        snapshot->message = message;
        RunStatistics counted = solver->statistics(complete);
        counted.seconds.history = history_seconds;
        counted.step_seconds += history_seconds;
        const std::lock_guard lock(mutex);
        published = std::move(snapshot);
        statistics = std::move(counted);
    }

    void emit_frame() {
        if (!options.on_frame) return;
        auto snapshot = std::make_shared<Snapshot>(*solver->snapshot());
        snapshot->status = status;
        snapshot->message = message;
        options.on_frame(std::move(snapshot));
    }

    void emit_due_frame() {
        if (!options.on_frame || !options.frame_interval) return;
        // A step that jumps over several frame times gives one frame, the newest.
        if (solver->time() < static_cast<double>(frames) * *options.frame_interval * (1 - 1e-12)) return;
        emit_frame();
        while (solver->time() >= static_cast<double>(frames) * *options.frame_interval * (1 - 1e-12)) ++frames;
    }

    void end_run(RunStatus how) {
        status = how;
        emit_frame();
        publish(true);
    }

    void diverge(std::string why) {
        message = std::move(why);
        if (next_safe_state > 0) solver->restore(safe_state);
        end_run(RunStatus::diverged);
    }

    void step_once() {
        if (solver->steps() >= next_safe_state) {
            safe_state = solver->save();
            next_safe_state = solver->steps() + steps_between_safe_states;
        }
        emit_due_frame();
        const auto divergence = solver->step();
        const auto before = std::chrono::steady_clock::now();
        history->append(solver->history_row());
        history_seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - before).count();
        if (divergence) {
            diverge(divergence->message);
            return;
        }
        if (solver->finished()) {
            end_run(RunStatus::finished);
        } else if (--steps_left <= 0 || solver->time() >= pause_at) {
            status = RunStatus::paused;
            publish(true);
        } else if (snapshot_wanted.exchange(false)) {
            publish(false);
        }
    }

    void start(double until, std::int64_t steps) {
        if (status == RunStatus::finished || status == RunStatus::diverged) {
            say("the run has ended; reset it to run again");
            return;
        }
        pause_at = until;
        steps_left = steps;
        status = RunStatus::running;
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
                return;
            }
            auto fresh = make_solver(changed);
            scene = std::move(changed);
            solver = std::move(fresh);
            begin_run();
        } catch (const SceneError& error) {
            for (const std::string& line : error.messages()) say(line);
        }
    }

    void obey(const Command& command) {
        constexpr double forever = std::numeric_limits<double>::infinity();
        constexpr auto no_limit = std::numeric_limits<std::int64_t>::max();
        std::visit(Overloaded{[&](const command::Run& run) { start(run.until.value_or(forever), no_limit); },
                              [&](const command::Steps& steps) { start(forever, steps.count); },
                              [&](const command::Pause&) {
                                  if (status == RunStatus::running) status = RunStatus::paused;
                                  publish(true);
                              },
                              [&](const command::Reset&) {
                                  solver = make_solver(scene);
                                  begin_run();
                              },
                              [&](const command::Set& what) { set(what); }, [&](const command::Stop&) { stop = true; }},
                   command);
    }

    /// Takes the next command, waiting for one when there is nothing to step.
    std::optional<Command> next_command() {
        const bool running = status == RunStatus::running;
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
                if (!stop && status == RunStatus::running) step_once();
            } catch (const std::exception& error) {
                // A full disk in the recorder, memory that ran out: the run ends, the program goes on.
                message = error.what();
                options.on_frame = nullptr;
                status = RunStatus::diverged;
                publish(true);
            }
        }
        const std::lock_guard lock(mutex);
        idle = true;
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
