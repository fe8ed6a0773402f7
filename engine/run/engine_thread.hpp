#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "run/engine.hpp"
#include "run/pace.hpp"
#include "run/travelling_run.hpp"

namespace percuss {

/// The engine's thread: it steps the run, obeys commands in between (engine_commands.cpp) and publishes what
/// it did.
struct Engine::Impl {
    Impl(Scene scene_in, EngineOptions options_in);

    // Owned by the engine thread once it runs.
    Scene scene;
    EngineOptions options;
    std::unique_ptr<TravellingRun> run;
    std::shared_ptr<FrameHistory> kept_frames;
    double kept_frame_interval = 0;
    std::int64_t kept_frame = 0;  // multiples of the interval reached
    Pace pace;
    bool paced = false;  // Run is, Steps are not
    std::int64_t frames = 0, published_step = 0;
    double pause_at = 0;
    std::int64_t steps_left = 0;
    RunStatus state = RunStatus::paused;
    Divergence failure;                          // why the run diverged, if it did
    RunStatus state_at_end = RunStatus::paused;  // while the run is set back
    Divergence failure_at_end;
    bool stop = false;

    // Shared, each behind `mutex`, which is held only to copy or swap a pointer or a small value.
    mutable std::mutex mutex;
    std::condition_variable work_came, fell_idle;
    std::deque<Command> commands;
    bool idle = false, ended = false;
    std::shared_ptr<const Snapshot> published;
    std::shared_ptr<const History> history;
    std::vector<Trace> traces;
    std::vector<SetProbe> probes;
    std::shared_ptr<const Scene> scene_as_set;
    std::shared_ptr<const StateHistory> states;
    std::shared_ptr<const FrameHistory> scrub_frames;
    std::optional<double> end;
    std::optional<double> target_speed;
    RunStatistics statistics;
    std::vector<std::string> messages;

    std::atomic<bool> commands_waiting{false}, snapshot_wanted{false};
    std::atomic<RunStatus> status{RunStatus::paused};
    std::atomic<double> time{0}, speed{0};
    std::atomic<std::int64_t> step{0};
    std::thread thread;

    [[nodiscard]] const Solver& solver() const { return run->solver(); }

    // The thread.
    void serve();
    std::optional<Command> next_command();  // waits for one when there is nothing to step

    // Runs and what is seen of them.
    std::unique_ptr<TravellingRun> make_run(const Scene& of) const;
    void begin_run();
    std::shared_ptr<const Snapshot> take_snapshot() const;
    void publish(bool complete);
    void emit_frame();
    bool reached(double when) const;
    bool emits_frames() const;
    void emit_due_frame();
    void skip_reached_frames();  // a step that jumps over several frame times gives one frame, the newest
    std::int64_t multiple_of_kept_frames() const;
    void keep_due_frame();
    void end_run(RunStatus how);
    void step_once();
    bool is_due();  // waits for the next step's turn; false: a command came first, or ask again

    // Commands.
    void obey(const Command& command);
    void start(double until, std::int64_t count, bool with_pace);
    void begin_branch();  // the run goes on from a moment before its end
    void say(std::string text);
    void take_over(Scene changed);
    void set(const command::Set& command);
    void change(Scene changed, bool harmless);  // harmless: the run reads nothing of what differs
    void add_probe(const Probe& probe);
    void replace_run(const Scene& of);  // with the probes that were set
    void set_speed(std::optional<double> wanted);
    bool seek_is_superseded();  // the next command makes it useless to go on with a Seek
    void seek(double to);
};

}  // namespace percuss
