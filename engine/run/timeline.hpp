#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "run/snapshot.hpp"
#include "run/thinned_history.hpp"

namespace percuss {

/// Snapshots kept over a run; places are multiples of the interval between frames.
using FrameHistory = ThinnedHistory<Snapshot>;

/// Where a run is between its start, at 0, and the last moment that it has reached.
struct Timeline {
    double present = 0;  ///< [time]
    /// >= present. Histories and traces end with the step before it; those of a diverged run may hold the row
    /// of the step that failed, too [time].
    double end = 0;
    /// What going on from the present moment would drop, from .. to: set while the run is set back [time].
    std::optional<std::array<double, 2>> branch_drops;
    std::vector<double> kept_states;  ///< times that Seek reaches without stepping, ascending [time]
    std::size_t state_bytes = 0;      ///< memory of the kept states
    std::vector<double> frames;       ///< times of the kept snapshots, ascending [time]
    std::size_t frame_bytes = 0;      ///< their memory
};

/// A run as it goes, newer than its newest snapshot.
struct RunProgress {
    RunStatus status = RunStatus::paused;
    double time = 0;  ///< [time]
    std::int64_t step = 0;
    /// Of the run over about the last half second; 0 unless it runs [time per second of wall time].
    double speed = 0;
    std::optional<double> target_speed;  ///< as set by SetSpeed
};

}  // namespace percuss
