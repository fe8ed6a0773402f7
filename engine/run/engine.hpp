#pragma once

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <variant>

#include "run/history.hpp"
#include "run/snapshot.hpp"
#include "run/statistics.hpp"
#include "run/trace.hpp"

namespace percuss {

/// Commands to the engine thread; drained between steps, in the order given. None waits for the steps that an
/// earlier one asked for: Run, Pause pauses at once.
namespace command {
struct Run {
    std::optional<double>
        until;  ///< pause at the first step that reaches this time; absent: the scene's duration
};
struct Pause {};
struct Steps {
    std::int64_t count = 1;  ///< then pause; counts not yet done add up
};
struct Reset {};  ///< back to time 0, paused, with new histories
/// Changes a value of the scene ("model.step.courant", "0.5"). The time step changes in flight, from the next
/// step on; any other value resets the run. A key or value that is not valid leaves everything as it was and
/// gives a message.
struct Set {
    std::string key, value;
};
struct Stop {};  ///< ends the thread
}  // namespace command
using Command =
    std::variant<command::Run, command::Pause, command::Steps, command::Reset, command::Set, command::Stop>;

struct EngineOptions {
    int threads = 1;
    /// Called on the engine thread with a snapshot at the first step that reaches each multiple of this
    /// simulated time (0 included) and at the end. It may block: a recorder that cannot keep up then slows
    /// the run instead of losing frames. It may post commands, not wait(). An exception from it ends the run
    /// with its message.
    std::optional<double> frame_interval;
    std::function<void(std::shared_ptr<const Snapshot>)> on_frame;
};

/// Steps a scene on a thread of its own. Everything it hands out is immutable or append-only, so a window
/// reads it at its own pace while stepping goes on.
class Engine {
  public:
    /// Builds the solver; paused at time 0 with a first snapshot published. @throws SceneError.
    explicit Engine(Scene scene, EngineOptions options = {});
    ~Engine();  ///< stops after the present step and joins
    Engine(const Engine&) = delete;
    Engine& operator=(const Engine&) = delete;

    void post(Command command);  ///< ignored after Stop
    /// The newest published snapshot; asks the engine to publish a fresh one after its present step.
    [[nodiscard]] std::shared_ptr<const Snapshot> snapshot();
    /// Histories of the present run (a reset begins a new one).
    [[nodiscard]] std::shared_ptr<const History> history() const;
    /// What the scene's figures sample in the present run; their rows are append-only, too.
    [[nodiscard]] std::vector<Trace> traces() const;
    [[nodiscard]] RunStatistics statistics() const;  ///< as of the newest published snapshot
    /// Never ahead of the snapshot: once this says finished, the last snapshot is published.
    [[nodiscard]] RunStatus status() const;
    /// Why a command was refused (unknown key, bad value), oldest first; emptied by the call.
    [[nodiscard]] std::vector<std::string> take_messages();
    /// Blocks until all posted commands are drained and the engine is paused, finished, diverged or stopped.
    void wait();

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace percuss
