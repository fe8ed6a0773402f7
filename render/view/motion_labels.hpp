#pragma once

#include <vector>

#include "canvas.hpp"
#include "run/snapshot.hpp"
#include "view/layout.hpp"
#include "view/plane.hpp"

namespace percuss::render {

/// An arrow of the mean velocity at each body's centre and its label, "striker 10.0 m/s", outside the mesh.
/// @param fastest speed of the run so far: gets `longest` pixels. @param taken what labels keep away from.
/// @param words likewise, and a label that finds no place beside them is left out. Labels are placed clear of
/// all bodies where there is room, with a leader to the centre.
void paint_motion(Canvas& canvas, const Snapshot& snapshot, const Plane& plane, const Fit& fit,
                  const Rect& area, double scale, double fastest, double longest, std::vector<Rect> taken,
                  std::vector<Rect> words = {});

}  // namespace percuss::render
