#pragma once

namespace percuss::app {

/// While it lives, the first SIGINT or SIGTERM only asks the run to end; a second one kills as usual.
class InterruptGuard {
  public:
    InterruptGuard();
    ~InterruptGuard();
    InterruptGuard(const InterruptGuard&) = delete;
    InterruptGuard& operator=(const InterruptGuard&) = delete;
    [[nodiscard]] static bool requested();
};

}  // namespace percuss::app
