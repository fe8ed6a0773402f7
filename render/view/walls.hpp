#pragma once

#include <vector>

#include "canvas.hpp"
#include "scene/scene.hpp"
#include "view/layout.hpp"
#include "view/plane.hpp"

namespace percuss::render {

/// The surfaces of rigid walls as thick lines, hatched on the side of the wall, with their mirror images.
/// @param area nothing is painted outside it [pixels]
void paint_walls(Canvas& canvas, const std::vector<Wall>& walls, const Plane& plane, const Fit& fit,
                 const Rect& area, double scale);

}  // namespace percuss::render
