#pragma once

#include <cstdint>
#include <vector>

#include "dynamics/node.hpp"

namespace percuss {

/// The predicted motion that contact corrects.
struct PredictedMotion {
    double dt = 0;          ///< of the step: positions change by dt * change of velocity [time]
    double kick = 0;        ///< velocities change by kick * acceleration (mean of the last two steps) [time]
    Node* nodes = nullptr;  ///< predicted positions and velocities; corrected in place
    const double* inverse_mass = nullptr;  ///< 2 per node, 0 where held, per radian or unit thickness
    double* impulse = nullptr;             ///< 2 per node; a scheme adds the impulses it puts on nodes
    std::vector<std::int32_t>* touched = nullptr;  ///< nodes with an impulse; may hold a node more than once
};

}  // namespace percuss
