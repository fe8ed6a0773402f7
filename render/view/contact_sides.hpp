#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "canvas.hpp"
#include "run/snapshot.hpp"
#include "view/layout.hpp"
#include "view/plane.hpp"

namespace percuss::render {

/// Where a contact pair may touch.
struct ContactSides {
    std::vector<std::int32_t> masters;                     ///< nodes, in chain order
    std::vector<std::array<std::int32_t, 2>> slave_sides;  ///< their end nodes
};

/// Of each pair of the scene.
[[nodiscard]] std::vector<ContactSides> contact_sides(const RunSetup& setup);

/// Master nodes as discs over slave sides as bold lines, mirror images too.
/// @param area what lies beside it is left out [pixels]
void paint_contact_sides(Canvas& canvas, const Snapshot& snapshot, const ContactSides& sides,
                         const Plane& plane, const Fit& fit, const Rect& area, double scale);

}  // namespace percuss::render
