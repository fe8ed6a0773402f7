#pragma once

#include <chrono>

namespace percuss {

/// Books the wall time since the last call under one phase.
class PhaseTimer {
  public:
    void book(double& seconds) {
        const auto now = Clock::now();
        seconds += std::chrono::duration<double>(now - last_).count();
        last_ = now;
    }

  private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point last_ = Clock::now();
};

}  // namespace percuss
