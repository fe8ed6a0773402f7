#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "run/snapshot.hpp"
#include "run/statistics.hpp"

namespace percuss::app {

/// A few lines on stdout: how the run ended, its speed, energies and contacts, in units that read well.
void print_results(const Snapshot& last, const RunStatistics& statistics);

/// A table on stdout: the first column to the left, the others to the right. @pre rows of one length, not
/// none.
void print_aligned(const std::vector<std::vector<std::string>>& rows);

/// One line per promise of the scene. @returns whether all were kept.
bool print_promises(const Scene& scene, const nlohmann::ordered_json& summary);

/// "12.3 kN": three or four significant digits in the prefix that reads best.
[[nodiscard]] std::string with_unit(const Units& units, Quantity quantity, double value);

}  // namespace percuss::app
