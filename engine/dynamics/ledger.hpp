#pragma once

#include <array>
#include <vector>

#include "run/snapshot.hpp"

namespace percuss {

/// What the node loop of a step adds up over a chunk of nodes of one body, per radian or unit thickness. "Before" and "after"
/// are the powers with the velocities that led to and lead away from the positions where the forces act.
struct alignas(64) NodeSums {
    double kinetic = 0;  ///< 1/2 m v_before . v_after: what a central-difference step conserves exactly
    double internal_before = 0, internal_after = 0;
    double external_before = 0, external_after = 0;
    std::array<double, 2> momentum{0, 0};  ///< after; summed by body, not here

    NodeSums& operator+=(const NodeSums& other) {
        kinetic += other.kinetic;
        internal_before += other.internal_before;
        internal_after += other.internal_after;
        external_before += other.external_before;
        external_after += other.external_after;
        return *this;
    }
};

/// Works and momenta of a run. Each force works half with the velocity before its instant and half with the one after it:
/// with kinetic energy 1/2 v_before M v_after the balance then closes to rounding at every step size (numerics: the
/// leapfrog's own energy), so whatever is missing was taken by the contact. Numbers are per radian or unit thickness.
struct Ledger {
    double initial_kinetic = 0;
    double internal = 0, hourglass = 0, viscous = 0, plastic = 0, contact = 0, friction = 0, loads = 0;  ///< works, up to and with the last "after"
    double growth = 0, loss = 0;    ///< largest rise above an earlier minimum, largest fall below the start
    double lowest = 0;              ///< smallest K + I - W so far
    double largest_kinetic = 0, largest_load = 0;
    Energies present;               ///< of the last closed instant
    std::vector<std::array<double, 2>> body_momentum;  ///< after the last instant
    std::vector<std::array<double, 2>> body_velocity;  ///< mass-averaged, at the last closed instant
    std::vector<double> pair_work;           ///< of contact forces
    std::vector<double> pair_friction_work;  ///< empty in scenes without friction
    struct Works {
        double hourglass = 0, viscous = 0, plastic = 0;
        Works& operator+=(const Works& other) {
            hourglass += other.hourglass;
            viscous += other.viscous;
            plastic += other.plastic;
            return *this;
        }
    };
    std::vector<Works> body_works;
};

}  // namespace percuss
