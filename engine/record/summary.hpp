#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "run/history.hpp"
#include "run/snapshot.hpp"
#include "run/statistics.hpp"

namespace percuss {

/// summary.json: parameters.NAME, status and message, steps, elements, wall_seconds by phase, contact_share,
/// element_steps_per_second, dt_min, dt_max, critical_step, energy {initial, final, maximum_growth,
/// maximum_loss, ...}, momentum, contact.NAME {peak_force, impulse, open_close_events, max_penetration, ...},
/// body.NAME.velocity.{axial,radial|x,y}, exact.COLUMN {error, error_averaged, first_sample}, state_hash,
/// units. README.md lists every key with its unit.
[[nodiscard]] nlohmann::ordered_json make_summary(const RunSetup& setup, const RunStatistics& statistics,
                                                  const History& history, const Snapshot& last);

/// The number at a dotted path, e.g. "contact.impact.peak_force"; names in the path may hold dots themselves.
/// Absent where there is none or it is no number.
[[nodiscard]] std::optional<double> summary_value(const nlohmann::ordered_json& summary,
                                                  std::string_view path);

/// What became of one promise of scene.expect.
struct ExpectationResult {
    bool kept = false;
    std::string text;  ///< "contact.impact.peak_force is 70.1, promised 63.8 +- 2 (why)"
};
[[nodiscard]] std::vector<ExpectationResult> check_expectations(const Scene& scene,
                                                                const nlohmann::ordered_json& summary);

/// One line per broken promise of scene.expect, empty when all hold. A path that summary lacks is a broken
/// promise.
[[nodiscard]] std::vector<std::string> broken_expectations(const Scene& scene,
                                                           const nlohmann::ordered_json& summary);

}  // namespace percuss
