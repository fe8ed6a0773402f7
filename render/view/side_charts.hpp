#pragma once

#include <optional>
#include <string>

#include "figures/figure.hpp"
#include "run/history.hpp"
#include "run/snapshot.hpp"

namespace percuss::render {

/// The chart of a name in ViewOptions::charts, with the history up to `time` and axes for the whole run.
/// The name of a history figure of the scene: that figure; "force": resultants of all pairs; "velocity": mean
/// velocities of the bodies; "energy"; else a history column.
/// @param time_unit of the x axis. @throws std::invalid_argument naming the nearest valid name.
[[nodiscard]] Chart make_side_chart(const std::string& name, const Scene& scene, const History& history,
                                    double time, const DisplayUnit& time_unit);

}  // namespace percuss::render
