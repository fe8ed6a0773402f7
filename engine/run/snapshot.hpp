#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "mesh/mesh.hpp"
#include "scene/scene.hpp"

namespace percuss {

/// What does not change during a run, shared by all its snapshots.
struct RunSetup {
    Scene scene;
    Mesh mesh;
};

/// Stress means of one cell, sign: tension positive. Components: rr (or xx), zz (or yy), hoop (or out of
/// plane), shear rz (or xy) [stress].
using StressMean = std::array<double, 4>;

/// The force that a contact puts on one node in one step [force], at the node's position.
struct ContactForce {
    std::int32_t node = 0;
    std::int32_t pair = 0;
    bool master = false;
    std::array<double, 2> force{0, 0};  ///< on the node; per radian times 2 pi when axisymmetric (full ring)
};

/// The energy ledger, [energy], of the whole ring when axisymmetric, of the thickness when plane.
struct Energies {
    double kinetic = 0;
    double internal = 0;   ///< work of all internal nodal forces: strain + hourglass + viscous + plastic
    double hourglass = 0;  ///< part of internal
    double viscous = 0;    ///< part of internal
    double contact = 0;    ///< work done on the bodies by contact forces (negative: energy lost at the
                           ///< contact), without friction
    double external =
        0;  ///< E of the paper: initial kinetic energy + work of loads, body forces, prescribed motion
    double plastic = 0;   ///< part of internal
    double friction = 0;  ///< work done on the bodies by friction forces; not part of contact
    /// e = E - I - K of the paper: what the contact took away.
    [[nodiscard]] double balance() const { return external - internal - kinetic; }
};

struct PairState {
    /// Resultant on the master body; radial = sum of radial components. Of a body with itself: the sum of the
    /// magnitudes of each component, for there the resultant is nothing [force].
    std::array<double, 2> force{0, 0};
    std::int32_t active = 0;               ///< master nodes in contact
    double penetration = 0;                ///< largest penetration left after the correction [length]
    std::array<double, 2> friction{0, 0};  ///< part of force; 0 in runs read from a file [force]
    std::int32_t sticking = 0;             ///< of the active nodes; likewise
};

struct BodyState {
    std::array<double, 2> velocity{0, 0};  ///< mass-averaged [velocity]
};

/// Where a body's energy is or went, [energy] as in Energies.
struct BodyEnergies {
    double kinetic = 0;  ///< at the snapshot's velocities, half a step before its time
    double elastic = 0;  ///< stored by strains
    double plastic = 0, hourglass = 0, viscous = 0;  ///< works since the start
};

enum class RunStatus { paused, running, finished, diverged };

/// One moment of a run: immutable, complete, taken without stopping the engine.
struct Snapshot {
    std::shared_ptr<const RunSetup> setup;
    double time = 0;  ///< [time]
    std::int64_t step = 0;
    double dt = 0;                       ///< [time]
    double critical_step = 0;            ///< [time]
    std::vector<double> position;        ///< 2 per node [length]
    std::vector<double> velocity;        ///< 2 per node, at time - dt/2 [velocity]
    std::vector<StressMean> stress;      ///< one per cell
    std::vector<double> plastic_strain;  ///< equivalent, one per cell, means; empty when no body is plastic
    std::vector<double> yield_stress;    ///< likewise; infinite in elastic bodies [stress]
    std::vector<double> temperature;     ///< one per cell; empty when no material heats [temperature]
    std::vector<ContactForce> contact_forces;
    std::vector<PairState> pairs;             ///< in the order of scene.contacts
    std::vector<BodyState> bodies;            ///< in the order of scene.bodies
    std::vector<BodyEnergies> body_energies;  ///< likewise; empty in runs recorded before they existed
    Energies energy;
    RunStatus status = RunStatus::paused;
    std::string message;            ///< why the run paused, when it diverged
    std::int32_t failed_cell = -1;  ///< the element that the message names, if any
};

/// What a snapshot's own arrays take [bytes]; what it shares with others is not counted.
[[nodiscard]] inline std::size_t memory_of(const Snapshot& s) {
    const auto bytes = [](const auto& array) { return array.capacity() * sizeof(array[0]); };
    return sizeof(Snapshot) + bytes(s.position) + bytes(s.velocity) + bytes(s.stress) +
           bytes(s.plastic_strain) + bytes(s.yield_stress) + bytes(s.temperature) + bytes(s.contact_forces) +
           bytes(s.pairs) + bytes(s.bodies) + bytes(s.body_energies);
}

}  // namespace percuss
