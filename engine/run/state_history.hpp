#pragma once

#include <cstddef>

#include "run/run_record.hpp"
#include "run/thinned_history.hpp"
#include "solver.hpp"

namespace percuss {

/// A moment of a run that it can be set back to.
struct KeptState {
    SolverState solver;
    RunRecord::Progress record;
};

/// Moments kept over a run; places are steps.
using StateHistory = ThinnedHistory<KeptState>;

/// What a kept state takes [bytes]; of what contact remembers an estimate.
[[nodiscard]] std::size_t memory_of(const KeptState& kept);

}  // namespace percuss
