#pragma once

#include <optional>
#include <vector>

#include "run/trace.hpp"

namespace percuss {

/// Contact force per length along an edge, over time.
struct ForceDensity {
    std::vector<double> times;   ///< middles of the intervals [time]
    std::vector<double> edges;   ///< of the bins, ascending, one more than bins [length]
    std::vector<double> values;  ///< times x bins, bins running fastest [force/length]
};

/// Spreads each node's force evenly from half way to its neighbour on one side to half way to that on the
/// other, and sums by bins: the sum over bins times their width is the total force.
/// @param trace a force trace. @param component of the force, 0 or 1. @param along coordinate of the
/// undeformed body in which length is measured; absent: arc length of the edge. @param bins > 0
[[nodiscard]] ForceDensity force_density(const Trace& trace, std::size_t component,
                                         std::optional<std::size_t> along, int bins);

}  // namespace percuss
