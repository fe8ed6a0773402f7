#pragma once

#include <vector>

#include "canvas.hpp"
#include "run/snapshot.hpp"
#include "view/force_scale.hpp"
#include "view/layout.hpp"
#include "view/plane.hpp"

namespace percuss::render {

/// Contact forces as arrows from their nodes, those on master nodes on top.
/// @param area tails outside it are left out. @param cell_size of a mean cell [pixels]: neighbours stay
/// apart.
/// @returns what the arrows cover.
std::vector<Rect> paint_force_arrows(Canvas& canvas, const Snapshot& snapshot, const Plane& plane,
                                     const Fit& fit, const Rect& area, const ForceScaling& forces,
                                     double cell_size, double scale);

}  // namespace percuss::render
