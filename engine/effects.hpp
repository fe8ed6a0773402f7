#pragma once

#include <string>
#include <vector>

#include "scene/scene.hpp"

namespace percuss {

/// One effect that a scene may call for, and what it costs; `percuss info` lists them.
struct EffectInfo {
    std::string name;  ///< "hourglass stiffness", "bulk viscosity", "contact: projection", ...
    bool on = false;   ///< off: its code is not in the kernel that runs
    std::string cost;  ///< in words, with the unit of the count: "22 flops per element and step"
};

[[nodiscard]] std::vector<EffectInfo> effects_of(const Scene& scene);

}  // namespace percuss
