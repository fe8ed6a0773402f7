#pragma once

#include <string>
#include <vector>

#include "scene/parse.hpp"

namespace percuss::benchmarks {

/// The rods scene with `radial` elements over the radius: 30 radial^2 elements, so 5 gives 750 and 20 gives
/// 12,000.
[[nodiscard]] inline Scene rods(int radial, std::vector<std::string> overrides = {}) {
    const auto divisions = [&](const char* body, int axial) {
        overrides.push_back(std::string("body.") + body + ".block.0.divisions=[" + std::to_string(radial) +
                            "," + std::to_string(axial) + "]");
    };
    divisions("striker", 10 * radial);
    divisions("rod", 20 * radial);
    return load_scene(PERCUSS_SOURCE_DIR "/scenes/rods.toml", overrides);
}

}  // namespace percuss::benchmarks
