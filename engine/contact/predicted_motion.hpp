#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "dynamics/node.hpp"

namespace percuss {

/// What changed the velocities of the nodes in the prediction, 2 numbers a node.
struct ForcesOnNodes {
    const double* inverse_mass = nullptr;
    const double* internal = nullptr;
    const double* external = nullptr;  ///< null: there are none
    const double* imposed = nullptr;   ///< changes of velocity by prescribed motion; null: there are none

    /// Change of velocity. @param kick time for which the forces acted @param impulse 2 a node, that contact
    /// put on top; null: none
    [[nodiscard]] std::array<double, 2> change(std::int32_t node, double kick,
                                               const double* impulse = nullptr) const {
        std::array<double, 2> dv{};
        for (std::size_t d = 0; d < 2; ++d) {
            const std::size_t k = 2 * static_cast<std::size_t>(node) + d;
            const double net = (external ? external[k] : 0) - internal[k];
            dv[d] = kick * inverse_mass[k] * net;
            if (impulse) dv[d] += inverse_mass[k] * impulse[k];
            if (imposed) dv[d] += imposed[k];
        }
        return dv;
    }
};

/// The predicted motion that contact corrects.
struct PredictedMotion {
    double dt = 0;          ///< of the step: positions change by dt * change of velocity [time]
    double kick = 0;        ///< velocities change by kick * acceleration (mean of the last two steps) [time]
    Node* nodes = nullptr;  ///< predicted positions and velocities; corrected in place
    const double* inverse_mass = nullptr;  ///< 2 per node, 0 where held, per radian or unit thickness
    double* impulse = nullptr;             ///< 2 per node; a scheme adds the impulses it puts on nodes
    std::vector<std::int32_t>* touched = nullptr;  ///< nodes with an impulse; may hold a node more than once
    const ForcesOnNodes* forces = nullptr;         ///< what the prediction was made with
    double* moved = nullptr;  ///< 2 per node: changes of velocity that are no impulse, of nodes without mass

    // What contact has to tell.
    double squared_frequency = 0;  ///< bound of what its springs add to that of the elements [1/time^2]
    double stored = 0;             ///< energy of its springs at x_n, per radian or unit thickness
};

}  // namespace percuss
