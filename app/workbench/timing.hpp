#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>

#include "run/history.hpp"

namespace percuss::app {

class LiveRun;

/// What the window measures of itself and of the engine beside it, for scripts and whoever tunes them.
class Timing {
  public:
    using Clock = std::chrono::steady_clock;

    /// A frame is on the screen. @param began when it was begun; @param shows_newest whether its picture is
    /// that of the newest snapshot.
    void count(const LiveRun& run, Clock::time_point began, Clock::time_point ended, bool shows_newest);

    /// Over the last two seconds, waiting for the next frame's turn included [1/s].
    [[nodiscard]] double frames_per_second() const;
    /// What they took without that, mean [s].
    [[nodiscard]] double frame_seconds() const;
    /// From the start of the program to the first picture of a model [s]; absent before.
    [[nodiscard]] std::optional<double> first_picture() const { return first_picture_; }
    /// From asking for a scene or a value to the first picture of the run that it took [s]; absent before.
    [[nodiscard]] std::optional<double> rebuild_seconds() const { return rebuild_; }
    /// Of the present run while it ran [steps/s of wall time]; 0 before.
    [[nodiscard]] double steps_per_second() const;

  private:
    struct Frame {
        Clock::time_point began, ended;
    };
    std::deque<Frame> frames_;
    int builds_ = 0;
    std::optional<double> rebuild_, first_picture_;
    std::shared_ptr<const History> history_;  // of the run whose speed is measured
    std::optional<Clock::time_point> ran_at_;
    std::int64_t step_ = 0, steps_ = 0;
    double seconds_ = 0;
};

}  // namespace percuss::app
