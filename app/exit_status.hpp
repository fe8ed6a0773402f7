#pragma once

#include <stdexcept>

namespace percuss::app {

/// What the program returns to the shell.
namespace exit_status {
inline constexpr int ok = 0;
inline constexpr int run_failed = 1;  ///< diverged, disk full, no ffmpeg, ...
inline constexpr int bad_input = 2;   ///< faulty scene, unknown option, output that must not be overwritten
inline constexpr int promise_broken =
    3;  ///< with --strict: the run is whole, a promise of [expect] is not kept
inline constexpr int interrupted = 130;  ///< 128 + SIGINT, as shells expect
}  // namespace exit_status

/// What was asked for cannot be done as asked; ends the program with exit_status::bad_input.
class UsageError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

}  // namespace percuss::app
