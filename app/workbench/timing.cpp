#include "workbench/timing.hpp"

#include "live/live_run.hpp"

namespace percuss::app {
namespace {

constexpr std::chrono::seconds remembered{2};

double seconds(Timing::Clock::duration duration) { return std::chrono::duration<double>(duration).count(); }

}  // namespace

void Timing::count(const LiveRun& run, Clock::time_point began, Clock::time_point ended, bool shows_newest) {
    frames_.push_back({began, ended});
    while (frames_.front().ended < ended - remembered) frames_.pop_front();
    if (shows_newest && run.builds() != builds_) {
        builds_ = run.builds();
        rebuild_ = seconds(ended - run.built_for());
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
