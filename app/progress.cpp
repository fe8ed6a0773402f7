#include "progress.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include <fmt/format.h>
#include <unistd.h>

namespace percuss::app {

bool stderr_is_terminal() {
    const char* term = std::getenv("TERM");
    return isatty(STDERR_FILENO) != 0 && term != nullptr && std::string(term) != "dumb";
}

std::string short_number(double value) {
    for (const auto& [limit, suffix] : {std::pair{1e9, " G"}, std::pair{1e6, " M"}, std::pair{1e3, " k"}}) {
        if (value >= 0.9995 * limit) return fmt::format("{:.3g}{}", value / limit, suffix);
    }
    return fmt::format("{:.3g}", value);
}

std::string short_duration(double seconds) {
    if (seconds < 9.95) return fmt::format("{:.2g} s", seconds);
    const auto whole = static_cast<std::int64_t>(std::lround(seconds));
    if (whole < 60) return fmt::format("{} s", whole);
    if (whole < 3600) return fmt::format("{}:{:02} min", whole / 60, whole % 60);
    return fmt::format("{}:{:02} h", whole / 3600, whole % 3600 / 60);
}

std::string progress_line(const Advance& advance, double duration, std::int64_t cells, const Units& units) {
    constexpr int width = 24;
    const double way = std::clamp(advance.time / duration, 0.0, 1.0);
    const int filled = static_cast<int>(way * width);
    const DisplayUnit unit = units.display(Quantity::time, duration);
    std::string line =
        fmt::format("[{:#>{}}{:.>{}}] {:3.0f} %  {:.4g} of {:.4g} {}", "", filled, "", width - filled,
                    100 * way, unit.scale * advance.time, unit.scale * duration, unit.label);
    if (advance.seconds > 0 && advance.steps > 0) {
        const double rate = static_cast<double>(advance.steps) / advance.seconds;
        line += fmt::format("  {} steps/s  {} element-steps/s", short_number(rate),
                            short_number(rate * static_cast<double>(cells)));
    }
    if (way > 0 && way < 1)
        line += fmt::format("  {} left", short_duration(advance.seconds * (1 - way) / way));
    return line;
}

Progress::Progress(double duration, std::int64_t cells, const Units& units, bool terminal)
    : duration_(duration), cells_(cells), units_(units), terminal_(terminal) {}

Progress::~Progress() {
    if (line_open_) std::fputc('\n', stderr);
}

void Progress::show(const Advance& advance) {
    const std::string line = progress_line(advance, duration_, cells_, units_);
    if (terminal_) {
        fmt::print(stderr, "\r{}\x1b[K", line);  // clears what a longer line left
        std::fflush(stderr);
        line_open_ = true;
        return;
    }
    const int tenths = static_cast<int>(10 * advance.time / duration_ + 1e-9);
    if (tenths <= tenths_shown_) return;
    tenths_shown_ = tenths;
    fmt::print(stderr, "{}\n", line);
}

}  // namespace percuss::app
