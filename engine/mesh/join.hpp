#pragma once

#include <cstdint>
#include <vector>

#include "mesh/mesh.hpp"

namespace percuss {

/// For each point the index of the first point within `tolerance` of it (its own when it is the first).
/// Hashed on a grid: linear in the number of points. |coordinate| / tolerance must stay below 1e18.
[[nodiscard]] std::vector<std::int32_t> coinciding(const std::vector<Vec2>& points, double tolerance);

}  // namespace percuss
