#include "figures/ticks.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace percuss::render {

namespace {

constexpr const char* minus = "\u2212";

std::string with_true_minus(std::string text) {
    for (std::size_t at = text.find('-'); at != std::string::npos; at = text.find('-', at + 3))
        text.replace(at, 1, minus);
    return text;
}

}  // namespace

double round_below(double value) {
    const double power = std::pow(10.0, std::floor(std::log10(value)));
    // 1e-9: a value that is 5 but for rounding is 5
    const double digits = value / power * (1 + 1e-9);
    if (digits >= 10) return 10 * power;
    return (digits >= 5 ? 5 : digits >= 2 ? 2 : 1) * power;
}

Ticks make_ticks(double low, double high, int wanted) {
    Ticks ticks;
    if (!(high > low)) return {{low}, {format_number(low)}};
    const double raw = (high - low) / std::max(wanted, 1);
    double step = round_below(raw);
    if (raw / step > 1.5) step = round_below(step * 2.5);  // the next rounder step: 1 -> 2, 2 -> 5, 5 -> 10
    const double slack = 1e-9 * (high - low);
    const double largest = std::max(std::abs(low), std::abs(high));
    const bool scientific = largest >= 1e6 || largest < 1e-4;
    const int decimals = std::clamp(static_cast<int>(-std::floor(std::log10(step) + 1e-9)), 0, 9);
    for (double n = std::ceil((low - slack) / step); n * step <= high + slack; n += 1) {
        const double value = n * step;
        ticks.values.push_back(value);
        ticks.labels.push_back(scientific
                                   ? format_number(value)
                                   : with_true_minus(fmt::format("{:.{}f}", n == 0 ? 0.0 : value, decimals)));
    }
    return ticks;
}

Ticks make_log_ticks(double low, double high, int wanted) {
    const double decades = std::log10(high / low);
    const int each = std::max(1, static_cast<int>(std::ceil(decades / std::max(wanted, 1))));
    Ticks ticks;
    const bool dense = 3 * decades <= wanted;
    const int first = static_cast<int>(std::floor(std::log10(low))),
              last = static_cast<int>(std::ceil(std::log10(high)));
    for (int power = first; power <= last; power += dense ? 1 : each)
        for (const double digit : {1.0, 2.0, 5.0}) {
            if (digit > 1 && !dense) break;
            const double value = digit * std::pow(10.0, power);
            if (value < low * (1 - 1e-9) || value > high * (1 + 1e-9)) continue;
            ticks.values.push_back(value);
            ticks.labels.push_back(format_number(value));
        }
    return ticks.values.size() < 3 ? make_ticks(low, high, std::min(wanted, 4)) : ticks;
}

std::string format_number(double value, int digits) {
    return with_true_minus(fmt::format("{:.{}g}", value == 0 ? 0.0 : value, digits));
}

}  // namespace percuss::render
