#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "run/probe_recorder.hpp"
#include "run/run_record.hpp"
#include "run/state_history.hpp"
#include "solver.hpp"

namespace percuss {

/// A run that can be set back to any of its moments. It keeps a state every so many steps; in between it
/// steps again, with the values that were in force, so that every moment is the one that was, bit by bit.
///
/// Set back, the run keeps what it has recorded until resume(): going on from an earlier moment is a branch,
/// which drops all that came after. One thread; the engine's.
class TravellingRun {
  public:
    /// @param state_memory bound of the kept states [bytes]; 0 keeps none: the run cannot be set back, and
    /// that costs nothing. @param history_memory of the histories [bytes]; 0: no bound. @throws SceneError.
    TravellingRun(const Scene& scene, int threads, std::size_t state_memory, std::size_t history_memory = 0);

    [[nodiscard]] const Solver& solver() const { return *solver_; }
    /// Of the whole run, whatever moment it is set back to.
    [[nodiscard]] const RunRecord& record() const { return record_; }
    /// Probes that are set while the run goes on. Those of a run that is set back keep what they have read
    /// until resume(), like the rest of the record.
    [[nodiscard]] ProbeRecorder& probes() { return probes_; }
    [[nodiscard]] const ProbeRecorder& probes() const { return probes_; }
    /// Kept states; null when none are. A branch begins a new one.
    [[nodiscard]] std::shared_ptr<const StateHistory> states() const { return states_; }
    /// The last moment that was reached, when the run is set back from it [time].
    [[nodiscard]] std::optional<double> end() const;

    /// Makes and records one step. @pre the run is not set back. @returns why the run cannot go on, if so; it
    /// then stands at its last good step.
    std::optional<Divergence> step();
    /// Goes on with other values from the next step of the run on. @pre, @throws as Solver::change.
    void change(const InFlight& values);

    /// Goes to the first step that reaches `time`; to the last one when none does [time]. @pre states are
    /// kept.
    /// @param give_up asked before each step that is made again: true leaves the run where it is then.
    /// @returns false when it was given up.
    bool seek(double time, const std::function<bool()>& give_up);
    /// Makes ready for step(). @returns whether this was a branch. @throws SceneError when the fixed step
    /// that was set cannot be taken at this moment; nothing has changed then.
    bool resume();

  private:
    struct Change {
        std::int64_t step;
        std::shared_ptr<const InFlight> values;
    };
    [[nodiscard]] bool reached(double time) const { return solver_->time() >= time * (1 - 1e-12); }
    [[nodiscard]] std::shared_ptr<const KeptState> keep() const;
    void keep_if_due();
    void leave_end();
    void back_at_end();
    void note_change();
    void take_up_change();
    bool step_again();

    std::unique_ptr<Solver> solver_;
    RunRecord record_;
    ProbeRecorder probes_;
    std::shared_ptr<StateHistory> states_;
    std::shared_ptr<const KeptState> safe_;  // not far back, for a run that diverges
    std::vector<Change> changes_;            // by step, one a step at most
    std::shared_ptr<const InFlight> wanted_;
    bool travelled_ = false;  // since it was last resumed: the solver's values are those of the moment
    bool tried_ = false;      // no, they are the wanted ones
    std::shared_ptr<const KeptState> end_;    // null unless set back
    std::optional<RunRecord> record_so_far_;  // up to the moment that the run is set back to
};

}  // namespace percuss
