#include "workbench/timing.hpp"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>

#include <unistd.h>

#include "live/live_run.hpp"

namespace percuss::app {
namespace {

constexpr std::chrono::seconds remembered{2};

/// How long this program has been there, the loading of its libraries included [s]. Linux tells when a
/// process began in ticks of a hundredth of a second.
std::optional<double> age_of_program() {
    std::ifstream stat("/proc/self/stat"), uptime("/proc/uptime");
    std::string text;
    double now = 0;
    if (!std::getline(stat, text) || !(uptime >> now)) return std::nullopt;
    std::istringstream fields(text.substr(std::min(text.rfind(')') + 1, text.size())));
    std::string field;
    constexpr int start_time = 22 - 2;  // proc(5) counts from 1; two stand before the bracket
    for (int i = 0; i < start_time; ++i) fields >> field;
    return now - std::strtod(field.c_str(), nullptr) / static_cast<double>(sysconf(_SC_CLK_TCK));
}

double seconds(Timing::Clock::duration duration) { return std::chrono::duration<double>(duration).count(); }

}  // namespace

void Timing::count(const LiveRun& run, Clock::time_point began, Clock::time_point ended, bool shows_newest) {
    frames_.push_back({began, ended});
    while (frames_.front().ended < ended - remembered) frames_.pop_front();
    if (shows_newest && run.builds() != builds_) {
        builds_ = run.builds();
        rebuild_ = seconds(ended - run.built_for());
        if (!first_picture_) first_picture_ = age_of_program();
    }
    if (!run.snapshot()) return;
    const std::int64_t step = run.snapshot()->step;
    const bool running = run.status() == RunStatus::running;
    if (history_ != run.history() || step < step_) {
        history_ = run.history();
        ran_at_.reset();
        steps_ = 0;
        seconds_ = 0;
    } else if (ran_at_) {
        steps_ += step - step_;
        seconds_ += seconds(began - *ran_at_);
    }
    step_ = step;
    ran_at_ = running ? std::optional(began) : std::nullopt;
}

double Timing::frames_per_second() const {
    if (frames_.size() < 2) return 0;
    return static_cast<double>(frames_.size() - 1) / seconds(frames_.back().ended - frames_.front().ended);
}

double Timing::frame_seconds() const {
    double sum = 0;
    for (const Frame& frame : frames_) sum += seconds(frame.ended - frame.began);
    return frames_.empty() ? 0 : sum / static_cast<double>(frames_.size());
}

double Timing::steps_per_second() const { return seconds_ > 0 ? static_cast<double>(steps_) / seconds_ : 0; }

}  // namespace percuss::app
