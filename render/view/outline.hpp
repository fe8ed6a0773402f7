#pragma once

#include "canvas.hpp"
#include "run/snapshot.hpp"
#include "view/layout.hpp"
#include "view/plane.hpp"

namespace percuss::render {

/// The boundaries of a snapshot's bodies as lines, their mirror images too: another run over the one that is drawn.
/// @param area what lies wholly to one side of it is left out [pixels]
void paint_outline(Canvas& canvas, const Snapshot& snapshot, const Plane& plane, const Fit& fit, const Rect& area,
                   Colour colour, double width);

}  // namespace percuss::render
