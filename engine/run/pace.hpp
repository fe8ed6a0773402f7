#pragma once

#include <chrono>
#include <deque>
#include <optional>

namespace percuss {

/// How fast a run goes: holds it back to a speed, and measures the one that it reaches. Times of the run in
/// scene units [time], speeds in [time] per second of wall time. Clock readings are arguments: it never waits
/// and never looks at a clock itself.
class Pace {
  public:
    using Clock = std::chrono::steady_clock;

    /// The run begins or goes on at `time`.
    void start(double time, Clock::time_point now);
    /// @param speed > 0; absent: as fast as can be.
    void set_target(std::optional<double> speed, double time, Clock::time_point now);
    [[nodiscard]] std::optional<double> target() const { return target_; }
    /// Until when to wait before the step that begins at `time`, if at all. A run that has fallen behind does
    /// not make up for it; one that is less than a millisecond ahead does not wait.
    [[nodiscard]] std::optional<Clock::time_point> wait_until(double time, Clock::time_point now);
    /// The run has come to `time`.
    void count(double time, Clock::time_point now);
    /// Over the last half second, or since the start when that was less long ago; where steps are rarer, over
    /// the last one. 0 for the first twenty milliseconds.
    [[nodiscard]] double speed() const { return speed_; }

  private:
    struct Sample {
        Clock::time_point at;
        double time;
    };
    std::optional<double> target_;
    Sample anchor_{};  // where the present speed began
    std::deque<Sample> samples_;
    double speed_ = 0;
};

}  // namespace percuss
