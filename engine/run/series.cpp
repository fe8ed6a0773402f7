#include "run/series.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "run/force_error.hpp"

namespace percuss {
std::vector<double> moving_average(std::span<const double> times, std::span<const double> values,
                                   double window) {
    assert(times.size() == values.size());
    if (values.size() < 2 || !(window > 0)) return {values.begin(), values.end()};
    const RunningIntegral integral(force_between_midpoints(times, values));
    std::vector<double> result;
    result.reserve(values.size());
    for (const double time : times) {
        const double from = std::max(time - 0.5 * window, times.front());
        const double to = std::min(time + 0.5 * window, times.back());
        result.push_back(to > from ? (integral(to) - integral(from)) / (to - from) : values[result.size()]);
    }
    return result;
}

double mean_between(std::span<const double> times, std::span<const double> values, double from, double to) {
    assert(times.size() == values.size());
    double sum = 0, weight = 0;
    const std::size_t count = values.size();
    for (std::size_t k = 0; k < count; ++k) {
        if (times[k] < from || times[k] > to) continue;
        const double begin = k > 0 ? 0.5 * (times[k - 1] + times[k]) : times[k];
        const double end = k + 1 < count ? 0.5 * (times[k] + times[k + 1]) : times[k];
        sum += values[k] * (end - begin);
        weight += end - begin;
    }
    return weight > 0 ? sum / weight : 0;
}

std::size_t largest_magnitude(std::span<const double> values) {
    const auto found = std::max_element(values.begin(), values.end(),
                                        [](double a, double b) { return std::abs(a) < std::abs(b); });
    return found == values.end() ? 0 : static_cast<std::size_t>(found - values.begin());
}

}  // namespace percuss
