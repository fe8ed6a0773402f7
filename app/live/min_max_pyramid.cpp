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

/// Appends the groups of `below`, whose first is number `lost`, that have become whole.
template <class Items>
bool grow(const Items& below, std::size_t lost, std::vector<MinMax>& groups, std::size_t known,
          std::size_t factor) {
    const std::size_t before = known;
    for (; (known + 1) * factor <= lost + below.size(); ++known)
        groups.push_back(over(below, known * factor - lost, (known + 1) * factor - lost));
    return known > before;
}

/// Drops half of what has become twice the bound; whole groups only, which the level above knows.
template <class Items>
void drop(Items& items, std::size_t& lost, std::size_t bound, std::size_t factor, std::size_t known_above) {
    if (items.size() < 2 * bound) return;
    const std::size_t until = std::min((lost + items.size() - bound) / factor * factor, known_above * factor);
    if (until <= lost) return;
    items.erase(items.begin(), items.begin() + static_cast<std::ptrdiff_t>(until - lost));
    lost = until;
}

}  // namespace

void MinMaxPyramid::append(std::span<const double> values) {
    values_.insert(values_.end(), values.begin(), values.end());
    if (levels_.empty()) levels_.emplace_back();
    bool grown = grow(values_, lost_, levels_[0].groups, levels_[0].size(), factor);
    for (std::size_t k = 1; grown; ++k) {
        if (levels_[k - 1].size() < factor) break;
        if (levels_.size() == k) levels_.emplace_back();
        const Level& below = levels_[k - 1];
        grown = grow(below.groups, below.lost, levels_[k].groups, levels_[k].size(), factor);
    }
    drop(values_, lost_, bound_, factor, levels_[0].size());
    for (std::size_t k = 1; k < levels_.size(); ++k)
        drop(levels_[k - 1].groups, levels_[k - 1].lost, bound_, factor, levels_[k].size());
}

MinMax MinMaxPyramid::range(std::size_t begin, std::size_t end) const { return range_on(0, begin, end); }

MinMax MinMaxPyramid::kept_on(std::size_t level, std::size_t begin, std::size_t end) const {
    if (level == 0) return over(values_, begin - lost_, end - lost_);
    const Level& of = levels_[level - 1];
    return over(of.groups, begin - of.lost, end - of.lost);
}

MinMax MinMaxPyramid::range_on(std::size_t level, std::size_t begin, std::size_t end) const {
    const std::size_t lost = level == 0 ? lost_ : levels_[level - 1].lost;
    const std::size_t above = level < levels_.size() ? levels_[level].size() : 0;
    // What does not fill a group is looked at on its own level, unless only the group is known.
    const std::size_t low = begin < lost ? begin / factor : (begin + factor - 1) / factor;
    const std::size_t high = end < lost ? (end + factor - 1) / factor : end / factor;
    if (low >= high || high > above) return kept_on(level, begin, end);
    MinMax all = range_on(level + 1, low, high);
    if (begin < low * factor) include(all, kept_on(level, begin, low * factor));
    if (high * factor < end) include(all, kept_on(level, high * factor, end));
    return all;
}

double MinMaxPyramid::within_group(std::size_t index) const {
    std::size_t level = 1, size = factor;
    while (index / size < levels_[level - 1].lost) ++level, size *= factor;
    const MinMax& group = levels_[level - 1].groups[index / size - levels_[level - 1].lost];
    return group.low +
           (group.high - group.low) * static_cast<double>(index % size) / static_cast<double>(size - 1);
}

}  // namespace percuss::app
