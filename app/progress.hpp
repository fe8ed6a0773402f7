#pragma once

#include <chrono>
#include <cstdint>
#include <string>

#include "units.hpp"

namespace percuss::app {

/// How far a run is.
struct Advance {
    double time = 0;  ///< simulated, in scene units
    std::int64_t steps = 0;
    double seconds = 0;  ///< wall seconds since the start
};

/// One line: bar, simulated time of the duration with unit, steps/s, element-steps/s, remaining time.
[[nodiscard]] std::string progress_line(const Advance& advance, double duration, std::int64_t cells,
                                        const Units& units);

/// Keeps stderr informed: on a terminal one line rewritten in place, elsewhere a line at each tenth of the
/// way.
class Progress {
  public:
    Progress(double duration, std::int64_t cells, const Units& units, bool terminal);
    ~Progress();  ///< ends the line
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;
    void show(const Advance& advance);

  private:
    double duration_;
    std::int64_t cells_;
    Units units_;
    bool terminal_;
    bool line_open_ = false;
    int tenths_shown_ = 0;
};

/// Whether stderr is a terminal that can rewrite a line.
[[nodiscard]] bool stderr_is_terminal();

/// 750000 -> "750 k", 12.3e6 -> "12.3 M"
[[nodiscard]] std::string short_number(double value);
/// 75 s -> "1:15", 0.42 s -> "0.42 s"
[[nodiscard]] std::string short_duration(double seconds);

}  // namespace percuss::app
