#include "run/run_record.hpp"

#include <algorithm>
#include <cmath>

#include "run/history_columns.hpp"
#include "run/phase_timer.hpp"
#include "solver.hpp"

namespace percuss {

RunRecord::RunRecord(const RunSetup& setup, std::size_t history_memory)
    : history_(std::make_shared<History>(history_columns(setup.scene), history_memory)), traces_(setup) {}

void RunRecord::before_step(const Solver& solver) {
    if (traces_.none()) return;
    PhaseTimer timer;
    traces_.before_step(solver);
    timer.book(seconds_);
}

void RunRecord::after_step(const Solver& solver, double time, bool sound) {
    PhaseTimer timer;
    if (sound && !traces_.none()) traces_.after_step(solver, time);
    const auto row = solver.history_row();
    // A step that failed early left the row of the one before, one that diverged may have left no numbers.
    if (row.front() == time && std::all_of(row.begin(), row.end(), [](double x) { return std::isfinite(x); }))
        history_->append(row);
    timer.book(seconds_);
}

RunRecord RunRecord::from(const Progress& progress) const {
    RunRecord record = *this;
    record.history_ = history_->first(progress.rows);
    record.traces_ = traces_.from(progress.traces);
    return record;
}

}  // namespace percuss
