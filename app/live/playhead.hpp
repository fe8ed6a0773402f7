#pragma once

#include <chrono>
#include <optional>

namespace percuss::app {

/// Which moment of a run is looked at: the newest one, or an earlier one that may be played from. Clock
/// readings are arguments.
class Playhead {
  public:
    using Clock = std::chrono::steady_clock;

    [[nodiscard]] bool live() const { return !time_; }
    [[nodiscard]] double time() const { return *time_; }  ///< @pre not live() [time]
    [[nodiscard]] bool playing() const { return since_.has_value(); }

    void go_live() {
        time_.reset();
        since_.reset();
    }
    /// Stays there; one that is played goes on from there.
    void look_at(double time) { time_ = time; }
    void play(Clock::time_point now) {
        if (time_) since_ = now;
    }
    void pause() { since_.reset(); }

    /// Moves on by the time that went by since the last call. @param speed [time per second of wall time]
    /// @returns whether it has come to `end`, where it stays and plays no more [time].
    bool advance(Clock::time_point now, double speed, double end) {
        if (!since_) return false;
        *time_ += speed * std::chrono::duration<double>(now - *since_).count();
        since_ = now;
        if (*time_ < end) return false;
        time_ = end;
        since_.reset();
        return true;
    }

  private:
    std::optional<double> time_;
    std::optional<Clock::time_point> since_;  // while it plays
};

}  // namespace percuss::app
