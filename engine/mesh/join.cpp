#include "mesh/join.hpp"

#include <cmath>
#include <unordered_map>

namespace percuss {
namespace {

std::uint64_t key(std::int64_t column, std::int64_t row) {
    // Two odd 64-bit constants (golden ratio, splitmix64); collisions only cost a distance check.
    return static_cast<std::uint64_t>(column) * 0x9E3779B97F4A7C15ULL ^
           (static_cast<std::uint64_t>(row) * 0xBF58476D1CE4E5B9ULL + 0x94D049BB133111EBULL);
}

}  // namespace

std::vector<std::int32_t> coinciding(const std::vector<Vec2>& points, double tolerance) {
    std::unordered_multimap<std::uint64_t, std::int32_t> grid;
    grid.reserve(points.size());
    std::vector<std::int32_t> first(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto column = static_cast<std::int64_t>(std::floor(points[i].x() / tolerance));
        const auto row = static_cast<std::int64_t>(std::floor(points[i].y() / tolerance));
        auto found = static_cast<std::int32_t>(i);
        for (std::int64_t dc = -1; dc <= 1; ++dc) {
            for (std::int64_t dr = -1; dr <= 1; ++dr) {
                const auto [begin, end] = grid.equal_range(key(column + dc, row + dr));
                for (auto it = begin; it != end; ++it) {
                    const auto other = static_cast<std::size_t>(it->second);
                    if (it->second < found && (points[other] - points[i]).norm() <= tolerance)
                        found = it->second;
                }
            }
        }
        first[i] = found;
        if (found == static_cast<std::int32_t>(i)) grid.emplace(key(column, row), found);
    }
    return first;
}

}  // namespace percuss
