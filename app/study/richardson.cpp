#include "study/richardson.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace percuss::app {
namespace {

constexpr double highest_order = 20, formal_order = 2, least_order = 0.5;

/// (h3^p - h1^p)/(h2^p - h1^p), which rises with p; a, b = h2/h1, h3/h1.
double ratio(double a, double b, double p) {
    return std::expm1(p * std::log(b)) / std::expm1(p * std::log(a));
}

}  // namespace

std::optional<double> observed_order(std::span<const Level> levels) {
    if (levels.size() < 3) return std::nullopt;
    const double d2 = levels[1].value - levels[0].value, d3 = levels[2].value - levels[0].value;
    if (d2 == 0 || !std::isfinite(d3 / d2)) return std::nullopt;
    const double a = levels[1].h / levels[0].h, b = levels[2].h / levels[0].h, wanted = d3 / d2;
    double low = 1e-6, high = highest_order;
    if (!(a > 1 && b > a) || wanted <= ratio(a, b, low) || wanted >= ratio(a, b, high)) return std::nullopt;
    for (int i = 0; i < 100; ++i) {
        const double middle = 0.5 * (low + high);
        (ratio(a, b, middle) < wanted ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

Limit extrapolate(std::span<const Level> levels) {
    Limit limit;
    limit.value = levels[0].value;
    if (levels.size() == 1) {
        limit.uncertainty = std::numeric_limits<double>::infinity();
        limit.how = "the only case; its own error is not known";
        return limit;
    }
    limit.order = observed_order(levels);
    const double change = levels[0].value - levels[1].value;
    if (limit.order && *limit.order >= least_order) {
        const double p = std::min(*limit.order, formal_order);
        const double rest = change / std::expm1(p * std::log(levels[1].h / levels[0].h));
        limit.value += rest;
        limit.uncertainty = 1.25 * std::abs(rest);
        limit.extrapolated = true;
        limit.how = fmt::format("Richardson from three levels, order {:.2g}{}", *limit.order,
                                *limit.order > formal_order ? " (2 used)" : "");
        return limit;
    }
    if (levels.size() == 2) {
        limit.uncertainty = 3 * std::abs(change) / (levels[1].h / levels[0].h - 1);
        limit.how = "the finest of two levels";
        return limit;
    }
    const auto [least, most] = std::minmax({levels[0].value, levels[1].value, levels[2].value});
    limit.uncertainty = 3 * (most - least) / 2;
    limit.how = limit.order ? fmt::format("the finest; order {:.2g} is too low to extrapolate", *limit.order)
                            : "the finest; the levels do not converge monotonously";
    return limit;
}

}  // namespace percuss::app
