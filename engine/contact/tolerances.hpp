#pragma once

namespace percuss {

// What all searches agree on; lengths as parts of a side.

/// A node beyond an open end or a sharp corner by up to this still belongs to the face: flush faces spread
/// sideways.
inline constexpr double end_tolerance = 0.02;
/// A node that appears inside, deeper than this and than it can have moved in a step, did not come through
/// the side: it lies beyond a thin body, or slid under an open end. To throw it out would make energy from
/// nothing.
inline constexpr double entry_tolerance = 1e-3;
/// A node in contact is let go when it is deeper than this: forces could not hold it.
inline constexpr double depth_limit = 0.5;

}  // namespace percuss
