#pragma once

#include <array>
#include <string>

#include <nlohmann/json.hpp>

#include "run/history.hpp"

namespace percuss {

/// What the histories of a contact pair tell: peak.DIRECTION {value, time}, the force on the master body of
/// largest magnitude in one row and its time; first_touch and last_touch, times of the first and last row
/// with force. What the histories do not hold is left out.
[[nodiscard]] nlohmann::ordered_json contact_history(const History& history, const std::string& pair,
                                                     const std::array<std::string, 2>& directions);

/// What the velocities of a body tell: velocity_min, velocity_max by direction, and stops.DIRECTION, the time
/// at which the mean velocity that the body began with is first used up.
[[nodiscard]] nlohmann::ordered_json body_history(const History& history, const std::string& body,
                                                  const std::array<std::string, 2>& directions);

}  // namespace percuss
