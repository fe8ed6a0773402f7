#include "run/force_error.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>

namespace percuss {

RunningIntegral::RunningIntegral(TimePoints points) : points_(std::move(points)) {
    if (points_.empty()) throw std::invalid_argument("a piecewise-linear function needs points");
    until_.reserve(points_.size());
    until_.push_back(0);
    for (std::size_t i = 1; i < points_.size(); ++i) {
        const double width = points_[i].first - points_[i - 1].first;
        if (!(width >= 0))
            throw std::invalid_argument("the times of a piecewise-linear function must not decrease");
        until_.push_back(until_.back() + 0.5 * width * (points_[i - 1].second + points_[i].second));
    }
}

double RunningIntegral::operator()(double time) const {
    const auto next = std::upper_bound(points_.begin(), points_.end(), time,
                                       [](double t, const auto& point) { return t < point.first; });
    if (next == points_.begin()) return 0;
    const auto last = static_cast<std::size_t>(next - points_.begin()) - 1;
    if (next == points_.end()) return until_[last];
    const auto& [t0, f0] = points_[last];
    const double s = time - t0;
    const double slope = (next->second - f0) / (next->first - t0);
    return until_[last] + s * (f0 + 0.5 * slope * s);
}

TimePoints force_between_midpoints(std::span<const double> time, std::span<const double> force) {
    const std::size_t rows = time.size();
    if (rows < 2 || force.size() != rows)
        throw std::invalid_argument("a force history needs two rows or more");
    TimePoints points;
    points.reserve(2 * rows);
    for (std::size_t n = 0; n < rows; ++n) {
        const double begin = n > 0 ? 0.5 * (time[n - 1] + time[n]) : time[0] - 0.5 * (time[1] - time[0]);
        const double end =
            n + 1 < rows ? 0.5 * (time[n] + time[n + 1]) : time[n] + 0.5 * (time[n] - time[n - 1]);
        points.emplace_back(begin, force[n]);
        points.emplace_back(end, force[n]);
    }
    return points;
}

double force_error(std::span<const double> time, std::span<const double> force, const TimePoints& exact,
                   double window, double duration) {
    const TimePoints steps = force_between_midpoints(time, force);
    const double mean_step = (time.back() - time.front()) / static_cast<double>(time.size() - 1);
    if (!(mean_step > 0)) throw std::invalid_argument("the times of a force history must grow");
    if (!(window > 0)) window = mean_step;

    const RunningIntegral computed_integral(steps);
    const RunningIntegral exact_integral(exact);
    const double end = std::min(duration, steps.back().first - 0.5 * window);
    // 32 samples a step resolve the corners of both running averages to about 1e-3 of the error.
    const auto samples = static_cast<std::size_t>(std::clamp(std::ceil(32 * end / mean_step), 1000.0, 4e6));
    double difference = 0, reference = 0;
    for (std::size_t i = 0; i < samples; ++i) {
        const double t = end * (static_cast<double>(i) + 0.5) / static_cast<double>(samples);
        const double from = t - 0.5 * window, to = t + 0.5 * window;
        const double computed_mean = (computed_integral(to) - computed_integral(from)) / window;
        const double exact_mean = (exact_integral(to) - exact_integral(from)) / window;
        difference += (computed_mean - exact_mean) * (computed_mean - exact_mean);
        reference += exact_mean * exact_mean;
    }
    if (!(reference > 0)) throw std::invalid_argument("the exact answer is 0 throughout: no relative error");
    return std::sqrt(difference / reference);
}

double history_error(std::span<const double> time, std::span<const double> values,
                     std::span<const double> reference_time, std::span<const double> reference, double window,
                     double duration) {
    return force_error(time, values, force_between_midpoints(reference_time, reference), window, duration);
}

double first_sample(std::span<const double> force, const TimePoints& exact) {
    double plateau = 0;
    for (const auto& [time, value] : exact) {
        if (std::abs(value) > std::abs(plateau)) plateau = value;
    }
    const auto first = std::find_if(force.begin(), force.end(), [](double f) { return f != 0; });
    return first == force.end() || plateau == 0 ? 0 : *first / plateau;
}

}  // namespace percuss
