#include "figures/thin.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace percuss::render {

Polyline2 thin(std::span<const double> x, std::span<const double> y, double low, double high, int columns) {
    Polyline2 result;
    const std::size_t count = std::min(x.size(), y.size());
    const auto add = [&](std::size_t i) {
        if (!std::isfinite(x[i]) || !std::isfinite(y[i])) return;
        result.x.push_back(x[i]);
        result.y.push_back(y[i]);
    };
    const bool thinnable = columns > 0 && high > low && std::is_sorted(x.begin(), x.end());
    if (!thinnable || count <= 4 * static_cast<std::size_t>(columns)) {
        for (std::size_t i = 0; i < count; ++i) add(i);
        return result;
    }
    const auto column = [&](std::size_t i) { return std::floor((x[i] - low) / (high - low) * columns); };
    for (std::size_t begin = 0; begin < count;) {
        std::size_t least = begin, greatest = begin, end = begin + 1;
        for (const double here = column(begin); end < count && column(end) == here; ++end) {
            if (y[end] < y[least]) least = end;
            if (y[end] > y[greatest]) greatest = end;
        }
        std::array<std::size_t, 4> kept{begin, least, greatest, end - 1};
        std::sort(kept.begin(), kept.end());
        for (std::size_t k = 0; k < kept.size(); ++k)
            if (k == 0 || kept[k] != kept[k - 1]) add(kept[k]);
        begin = end;
    }
    return result;
}

}  // namespace percuss::render
