#pragma once

#include <array>
#include <cstdint>

#include "run/snapshot.hpp"
#include "view/plane.hpp"

namespace percuss::render {

/// What lies under a point of the picture; -1 where nothing does.
struct Picked {
    std::int32_t body = -1, cell = -1;
    std::int32_t node = -1;  ///< the cell's corner nearest to the point
};

/// @param point in picture coordinates [length]; in a mirrored picture either half may be pointed at.
[[nodiscard]] Picked pick(const Snapshot& snapshot, const Plane& plane, std::array<double, 2> point);

}  // namespace percuss::render
