#pragma once

#include <algorithm>

#include "contact/row.hpp"
#include "scene/scene.hpp"

namespace percuss {

/// Gives a row its penetration P, what its force has to prevent within the step, and its margin.
/// @param gap at x_n, negative inside [length] @param motion dt * gap rate of the predicted motion [length]
/// @param recovery a penetration is taken back by no more than this in the step [length]
using ConditionOf = void (*)(ContactRow& row, double gap, double motion, double recovery);

/// The gap does not close further than to zero:
///     P = -(max(gap, -recovery) + dt gap rate),
/// how deep the predicted motion would go, counted from a gap that the step may make good. Nothing stays
/// open: what closes in the step has come together at its end.
inline void position_level(ContactRow& row, double gap, double motion, double recovery) {
    row.penetration = -(std::max(gap, -recovery) + motion);
}

/// Plastic impact, e = 0 (Moreau 1988, doi:10.1007/978-3-7091-2624-0_1): the gap of a row that is closed at
/// x_n, or that the prediction would close (look-ahead), closes no further:
///     P = -dt gap rate, where gap <= 0 or gap + dt gap rate < 0.
/// That leaves open what was open at x_n, less than the motion of a step; the row then persists (pressed in
/// the last step, it stays in the problem) until its gap is wider than that by a step's motion. Sliding on
/// curved faces goes in by a second-order bit a step, which is taken back as at the position level. Momenta
/// and the sign of the work as there; the loss of an impact is the same, only a fraction of a step earlier.
inline void velocity_level(ContactRow& row, double gap, double motion, double recovery) {
    row.penetration = -(std::clamp(gap, -recovery, 0.0) + motion);
    row.margin = std::max(gap, 0.0);
}

/// For springs: how deep the row is at x_n, P = -gap.
inline void depth_level(ContactRow& row, double gap, double, double) { row.penetration = -gap; }

[[nodiscard]] inline ConditionOf condition_of(ContactLevel level) {
    return level == ContactLevel::velocity ? &velocity_level : &position_level;
}

}  // namespace percuss
