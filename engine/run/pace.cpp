#include "run/pace.hpp"

#include <algorithm>

namespace percuss {
namespace {

using namespace std::chrono_literals;
using Seconds = std::chrono::duration<double>;

constexpr Seconds window = 500ms, between_samples = 20ms;
constexpr Seconds not_worth_waiting = 1ms;  // a short sleep costs more than it lasts
constexpr Seconds behind = 50ms;
constexpr Seconds longest_wait = 1h;  // then it is asked again; longer ones overflow the clock

}  // namespace

void Pace::start(double time, Clock::time_point now) {
    anchor_ = {now, time};
    samples_.assign(1, anchor_);
    speed_ = 0;
}

void Pace::set_target(std::optional<double> speed, double time, Clock::time_point now) {
    target_ = speed;
    anchor_ = {now, time};
}

std::optional<Pace::Clock::time_point> Pace::wait_until(double time, Clock::time_point now) {
    if (!target_) return std::nullopt;
    const Seconds ahead = Seconds((time - anchor_.time) / *target_) - (now - anchor_.at);
    if (ahead < -behind) anchor_ = {now, time};
    if (ahead < not_worth_waiting) return std::nullopt;
    return now + std::chrono::duration_cast<Clock::duration>(std::min(ahead, longest_wait));
}

void Pace::count(double time, Clock::time_point now) {
    if (samples_.empty() || now - samples_.back().at < between_samples) return;
    samples_.push_back({now, time});
    while (samples_.size() > 2 && now - samples_[1].at >= window) samples_.pop_front();
    const Sample& first = samples_.front();
    speed_ = (time - first.time) / Seconds(now - first.at).count();
}

}  // namespace percuss
