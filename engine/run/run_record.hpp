#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "run/history.hpp"
#include "run/trace.hpp"

namespace percuss {

class Solver;

/// What a run leaves while it is made: a row of history for each step, and the traces of its figures.
class RunRecord {
  public:
    /// @throws SceneError when the line of a figure does not cross its body.
    /// @param history_memory of the histories [bytes]; 0: no bound.
    explicit RunRecord(const RunSetup& setup, std::size_t history_memory = 0);

    void before_step(const Solver& solver);
    /// @param time at which the step began [time]. @param sound false: the step diverged; its row is kept if
    /// it is one of numbers.
    void after_step(const Solver& solver, double time, bool sound);

    [[nodiscard]] std::shared_ptr<const History> history() const { return history_; }
    [[nodiscard]] const std::vector<Trace>& traces() const { return traces_.traces(); }
    [[nodiscard]] double seconds() const { return seconds_; }  ///< wall time spent here

    /// How far the record has come, to go back to.
    struct Progress {
        std::size_t rows = 0;
        std::vector<TraceRecorder::Progress> traces;
    };
    [[nodiscard]] Progress progress() const { return {history_->rows(), traces_.progress()}; }
    /// A record that goes on from an earlier moment of this one. It shares the rows up to then; this one and
    /// its readers are not disturbed.
    [[nodiscard]] RunRecord from(const Progress& progress) const;

  private:
    std::shared_ptr<History> history_;
    TraceRecorder traces_;
    double seconds_ = 0;
};

}  // namespace percuss
