#pragma once

#include <string>
#include <vector>

#include "run/snapshot.hpp"

namespace percuss {

/// One place where energy is or went.
struct EnergyShare {
    std::string kind;   ///< "kinetic", "elastic", "plastic", "hourglass", "viscous", "contact", "friction", "unaccounted"
    std::string body;   ///< "" for what belongs to no body
    double energy = 0;  ///< [energy], of the whole ring or thickness
};

/// Where the energy put in (initial kinetic energy and work of loads) is at a snapshot: shares by kind and
/// body, what contact and friction took away, and what is missing from the sum, so that the shares add up to
/// snapshot.energy.external exactly.
///
/// Kinetic energies stand half a step before the snapshot's other numbers: that and the ledger's own error
/// are "unaccounted".
/// @returns nothing when the snapshot has no energies of bodies.
[[nodiscard]] std::vector<EnergyShare> energy_budget(const Snapshot& snapshot);

}  // namespace percuss
