#pragma once

#include <ctime>

namespace percuss::benchmarks {

/// Processor seconds of this thread: what a benchmark's rate is taken over, so that a busy machine spoils
/// neither the rate nor the limit it is compared with.
[[nodiscard]] inline double thread_seconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace percuss::benchmarks
