#pragma once

#include <algorithm>

#include "contact/row.hpp"

namespace percuss {

/// Gives a row its penetration P, what its force has to prevent within the step, and its margin.
/// @param gap at x_n, negative inside [length] @param motion dt * gap rate of the predicted motion [length]
/// @param recovery a penetration is taken back by no more than this in the step [length]
using ConditionOf = void (*)(ContactRow& row, double gap, double motion, double recovery);

/// "position": the gap does not close further than to zero,
///     P = -(max(gap, -recovery) + dt gap rate),
/// how deep the predicted motion would go, counted from a gap that the step may make good. Nothing stays
/// open: what closes in the step has come together at its end.
inline void position_level(ContactRow& row, double gap, double motion, double recovery) {
    row.penetration = -(std::max(gap, -recovery) + motion);
}

/// "velocity", plastic impact with e = 0 (Moreau 1988, CISM Courses and Lectures 302, 1-82): the gap of a row
/// that the prediction would close in this step (look-ahead) closes no further,
///     P = -dt gap rate, where gap + dt gap rate < 0.
/// That leaves open what was open at x_n, less than the motion of a step. From then on, as long as the row
/// persists, it is that gap which does not close further, as at the position level. (Asking that the rate be
/// never negative instead, step by step, lets the gaps of faces that turn widen by a bit of second order in
/// every step, under force: rocking blocks gained 200 times the energy.) The loss of an impact is that of the
/// position level, only a fraction of a step earlier; momenta as there.
inline void velocity_level(ContactRow& row, double gap, double motion, double recovery) {
    row.penetration = -(std::clamp(gap, -recovery, 0.0) + motion);
    row.margin = std::max(gap, 0.0);
}

/// For springs: how deep the row is at x_n, P = -gap.
inline void depth_level(ContactRow& row, double gap, double, double) { row.penetration = -gap; }

}  // namespace percuss
