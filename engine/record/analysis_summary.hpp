#pragma once

#include <nlohmann/json.hpp>

#include "run/history.hpp"
#include "run/snapshot.hpp"

namespace percuss {

/// Adds peaks and residual forces to `contacts` (contact.PAIR.peak_averaged, peak_averaged_time, residual by
/// direction) and, of what drives them, to `bodies` (body.NAME.drive.peak_averaged and so on).
/// @returns `analysis`: the window and times they belong to, and the pull-out estimate. Empty without rows, or
/// without contacts and prescribed motions.
[[nodiscard]] nlohmann::ordered_json analyse(const Scene& scene, const History& history,
                                             nlohmann::ordered_json& contacts,
                                             nlohmann::ordered_json& bodies);

/// `energy_budget`: energies by kind, then body; empty when the snapshot has no energies of bodies.
[[nodiscard]] nlohmann::ordered_json budget_summary(const Snapshot& last);

}  // namespace percuss
