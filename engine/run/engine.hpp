#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "run/history.hpp"
#include "run/probe_recorder.hpp"
#include "run/snapshot.hpp"
#include "run/statistics.hpp"
#include "run/timeline.hpp"
#include "run/trace.hpp"

namespace percuss {

/// Commands to the engine thread; drained between steps, in the order given. None waits for the steps that an
/// earlier one asked for: Run, Pause pauses at once; so do Seek, Reset and Stop, whatever the speed.
namespace command {
struct Run {
    std::optional<double>
        until;  ///< pause at the first step that reaches this time; absent: the scene's duration
};
struct Pause {};
/// Steps made at once, whatever the speed that is set; then pause. Counts not yet done add up.
struct Steps {
    std::int64_t count = 1;
};
struct Reset {};  ///< back to time 0, paused, with new histories
/// Goes to the first step that reaches a time of the run so far, its last moment when none does, and pauses
/// there [time]. That moment is the one that was, bit by bit. Histories, traces and frames stay as they are
/// until the run goes on from there: that is a branch, and all that came after the moment is dropped
/// (Engine::timeline says beforehand what). Those who hold the former histories keep them whole. A Seek that
/// is followed by another one may be left undone.
struct Seek {
    double time = 0;
};
/// Changes a value of the scene ("model.step.courant", "0.5"). What it takes: effect_of_change
/// (run/in_flight.hpp). What can act from the next step on does; what the run does not read only changes
/// Engine::scene; any other value resets the run. A key or value that is not valid leaves everything as it
/// was and gives a message.
struct Set {
    std::string key, value;
};
/// Goes on with another scene, likewise: one that was read elsewhere, so that the run does not wait for it.
struct Change {
    std::shared_ptr<const Scene> scene;
};
/// Holds runs back to so much simulated time per second of wall time, > 0 [time/s]; absent: as fast as can
/// be.
struct SetSpeed {
    std::optional<double> speed;
};
/// Reads quantities at a place of a body from the next step on, a row a step, until it is removed. A reset
/// takes it along. One that the scene has no place or quantity for gives a message.
struct AddProbe {
    Probe probe;
};
struct RemoveProbe {
    std::string name;
};
struct Stop {};  ///< ends the thread
}  // namespace command
using Command = std::variant<command::Run, command::Pause, command::Steps, command::Reset, command::Seek,
                             command::Set, command::Change, command::SetSpeed, command::AddProbe,
                             command::RemoveProbe, command::Stop>;

struct EngineOptions {
    int threads = 1;
    /// Called on the engine thread with a snapshot at the first step that reaches each multiple of this
    /// simulated time (0 included) and at the end. It may block: a recorder that cannot keep up then slows
    /// the run instead of losing frames. It may post commands, not wait(). An exception from it ends the run
    /// with its message. After a branch frames come anew from that moment on.
    std::optional<double> frame_interval;
    std::function<void(std::shared_ptr<const Snapshot>)> on_frame;
    /// Bound of the states kept for Seek [bytes]; when it is reached every second one is dropped. 0 keeps
    /// none, costs nothing, and Seek is refused.
    std::size_t state_memory = std::size_t{512} << 20;
    /// Bound of the snapshots kept for frame_at, likewise [bytes].
    std::size_t frame_memory = std::size_t{256} << 20;
    /// Of the histories, those of probes that are set on the way beside them, each a sixteenth of it [bytes]:
    /// older rows are thinned then (History). 0 keeps every row as it is, as a recorder needs it.
    std::size_t history_memory = 0;
    /// Simulated time between those snapshots while they are few; absent: duration / 500 [time].
    std::optional<double> frame_memory_interval;
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
    /// The newest kept snapshot that is not later than `time`, of the run so far: to look back while the
    /// engine goes on, undisturbed. The newest published one counts as kept. Null when there is none, as with
    /// frame_memory = 0 [time].
    [[nodiscard]] std::shared_ptr<const Snapshot> frame_at(double time) const;
    /// Those snapshots together. It goes on with the run; a reset or a branch begins a new one. Null when
    /// none are kept.
    [[nodiscard]] std::shared_ptr<const FrameHistory> frames() const;
    /// Histories of the present run (a reset or a branch begins a new one).
    [[nodiscard]] std::shared_ptr<const History> history() const;
    /// What the scene's figures sample in the present run; their rows are append-only, too.
    [[nodiscard]] std::vector<Trace> traces() const;
    /// The probes of AddProbe in the present run; their rows are append-only, too.
    [[nodiscard]] std::vector<SetProbe> probes() const;
    /// The scene with all that was set, newer than that of a snapshot's set-up, where what the run does not
    /// read stays as it was when the run began.
    [[nodiscard]] std::shared_ptr<const Scene> scene() const;
    [[nodiscard]] RunStatistics statistics() const;  ///< as of the newest published snapshot
    /// Where the run is and what is kept of it; what a branch from here would drop.
    [[nodiscard]] Timeline timeline() const;
    [[nodiscard]] RunProgress progress() const;  ///< cheap: for every picture
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
