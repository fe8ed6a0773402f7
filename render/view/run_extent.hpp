#pragma once

#include <array>

#include "run/snapshot.hpp"
#include "view/plane.hpp"

namespace percuss::render {

/// What a run has shown so far; only grows, so that a film or window keeps its scales.
struct RunExtent {
    RunExtent(const RunSetup& setup, const Plane& plane);
    void follow(const Snapshot& snapshot, const Plane& plane);

    double largest_force = 0;     ///< on one node [force]
    double fastest = 0;           ///< mean speed of a body [velocity]
    std::array<double, 4> box{};  ///< {left, low, right, high} of all bodies, in picture coordinates
};

}  // namespace percuss::render
