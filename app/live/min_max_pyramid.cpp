#include "live/min_max_pyramid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace percuss::app {
namespace {

constexpr MinMax nothing{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};

void include(MinMax& all, double value) {
    if (!std::isfinite(value)) return;
    all.low = std::min(all.low, value);
    all.high = std::max(all.high, value);
}

void include(MinMax& all, const MinMax& part) {
    all.low = std::min(all.low, part.low);
    all.high = std::max(all.high, part.high);
}

template <class Items>
MinMax over(const Items& items, std::size_t begin, std::size_t end) {
    MinMax all = nothing;
    for (std::size_t i = begin; i < end; ++i) include(all, items[i]);
    return all;
}

/// Appends the groups of `below` that have become whole.
template <class Items>
bool grow(const Items& below, std::vector<MinMax>& level, std::size_t factor) {
    const std::size_t before = level.size();
    while ((level.size() + 1) * factor <= below.size())
        level.push_back(over(below, level.size() * factor, (level.size() + 1) * factor));
    return level.size() > before;
}

}  // namespace

void MinMaxPyramid::append(std::span<const double> values) {
    values_.insert(values_.end(), values.begin(), values.end());
    if (levels_.empty()) levels_.emplace_back();
    bool grown = grow(values_, levels_[0], factor);
    for (std::size_t k = 1; grown; ++k) {
        if (levels_[k - 1].size() < factor) return;
        if (levels_.size() == k) levels_.emplace_back();
        grown = grow(levels_[k - 1], levels_[k], factor);
    }
}

MinMax MinMaxPyramid::range(std::size_t begin, std::size_t end) const {
    MinMax all = nothing;
    // Up from the ends: what does not fill a group is looked at on its own level.
    std::size_t level = 0;  // 0: the numbers themselves
    const auto size = [&](std::size_t k) { return k == 0 ? values_.size() : levels_[k - 1].size(); };
    const auto take = [&](std::size_t from, std::size_t to) {
        include(all, level == 0 ? over(values_, from, to) : over(levels_[level - 1], from, to));
    };
    while (begin < end) {
        const std::size_t low = (begin + factor - 1) / factor, high = end / factor;
        const bool higher = level < levels_.size() && low < high && high <= size(level + 1);
        if (!higher) {
            take(begin, end);
            break;
        }
        take(begin, low * factor);
        take(high * factor, end);
        begin = low;
        end = high;
        ++level;
    }
    return all;
}

}  // namespace percuss::app
