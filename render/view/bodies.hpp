#pragma once

#include <array>
#include <vector>

#include "run/snapshot.hpp"
#include "view/plane.hpp"

namespace percuss::render {

/// {left, low, right, high} of each body in picture coordinates, mirror images included.
[[nodiscard]] std::vector<std::array<double, 4>> body_boxes(const Snapshot& snapshot, const Plane& plane);

/// The box around all boxes.
[[nodiscard]] std::array<double, 4> box_around(const std::vector<std::array<double, 4>>& boxes);

/// The start box of the bodies and room for their initial velocities to carry them, at most a fifth of their
/// size: what flies further than that is followed by the growing picture.
[[nodiscard]] std::array<double, 4> initial_box(const RunSetup& setup, const Plane& plane);

/// The mean velocity that is drawn: of axisymmetric bodies the axial part only, since the mean radial
/// velocity of a ring moves nothing as a whole. In picture coordinates [velocity].
[[nodiscard]] std::array<double, 2> drawn_velocity(const Snapshot& snapshot, std::size_t body,
                                                   const Plane& plane);

}  // namespace percuss::render
