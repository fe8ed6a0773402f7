#pragma once

#include "canvas.hpp"
#include "scene/scene.hpp"
#include "view/layout.hpp"
#include "view/plane.hpp"

namespace percuss::render {

/// What lies under the mesh: walls, and the axis of an axisymmetric scene as a drawing's centre line.
void paint_ground(Canvas& canvas, const Scene& scene, const Plane& plane, const Fit& fit, const Rect& area,
                  double scale);

}  // namespace percuss::render
