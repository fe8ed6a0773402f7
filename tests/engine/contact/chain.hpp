#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "contact/surface.hpp"
#include "dynamics/node.hpp"

namespace percuss::testing {

/// Appends a chain of nodes at rest, walked with its body on the left, and links its sides.
inline Surface append_chain(std::vector<Node>& nodes, const std::vector<std::array<double, 2>>& points,
                            bool closed) {
    Surface surface;
    const auto first = static_cast<std::int32_t>(nodes.size()),
               count = static_cast<std::int32_t>(points.size());
    for (const auto& point : points) {
        surface.nodes.push_back(static_cast<std::int32_t>(nodes.size()));
        nodes.push_back({{point[0], point[1]}, {0, 0}});
    }
    const std::int32_t sides = closed ? count : count - 1;
    for (std::int32_t k = 0; k < sides; ++k) {
        const std::int32_t before = k > 0 ? k - 1 : (closed ? sides - 1 : -1);
        const std::int32_t after = k + 1 < sides ? k + 1 : (closed ? 0 : -1);
        surface.sides.push_back({first + k, first + (k + 1) % count, before, after});
    }
    return surface;
}

/// Single master nodes, without sides.
inline Surface append_points(std::vector<Node>& nodes, const std::vector<std::array<double, 2>>& points) {
    Surface surface = append_chain(nodes, points, false);
    surface.sides.clear();
    return surface;
}

/// Distance of a point from a segment, written out from the definition.
inline double distance_to_segment(const double* a, const double* b, double x, double y) {
    const double length = std::hypot(b[0] - a[0], b[1] - a[1]);
    const double tx = (b[0] - a[0]) / length, ty = (b[1] - a[1]) / length;
    const double along = (x - a[0]) * tx + (y - a[1]) * ty;
    if (along <= 0) return std::hypot(x - a[0], y - a[1]);
    if (along >= length) return std::hypot(x - b[0], y - b[1]);
    return std::abs((x - a[0]) * ty - (y - a[1]) * tx);
}

}  // namespace percuss::testing
