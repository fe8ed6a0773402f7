#pragma once

#include <map>
#include <string>

#include "scene/scene.hpp"

namespace percuss {

/// What a scene gives by expressions of its parameters: keys as in --set, "body.nail.velocity.1" or
/// "parameters.tip_z", and the expressions as written, "= -piston_speed". Elements of arrays of tables have
/// their names, others their indices. @pre the scene was parsed.
[[nodiscard]] std::map<std::string, std::string> expressions_in(const Scene& scene);

}  // namespace percuss
