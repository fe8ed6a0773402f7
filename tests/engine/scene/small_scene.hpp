#pragma once

#include <stdexcept>
#include <string>

#include "mesh/build.hpp"
#include "scene/parse.hpp"

namespace percuss::testing {

/// Two blocks that touch; tests change one line of it. Line numbers in expected messages refer to it.
inline const std::string small_scene = R"(percuss = 1
[units]
length = "mm"
time = "ms"
mass = "kg"
[model]
geometry = "axisymmetric"
duration = 0.1
[model.step]
courant = 0.5
[[material]]
name = "steel"
density = 7.85e-6
young = 210
poisson = 0.3
[[body]]
name = "hammer"
material = "steel"
velocity = [0, 10]
[[body.block]]
corners = [[0, -2], [4, -2], [4, 0], [0, 0]]
divisions = [4, 2]
[[body]]
name = "rod"
material = "steel"
[[body.block]]
corners = [[0, 0], [4, 0], [4, 8], [0, 8]]
divisions = [4, 8]
names = { bottom = "face" }
[[body.constraint]]
edge = "top"
fixed = ["axial"]
[[contact]]
name = "hit"
master = "rod.face"
slave = "hammer.top"
[[probe]]
name = "p"
body = "rod"
at = [1, 2]
record = ["stress.axial"]
[view]
field = "von_mises"
colour_map = "viridis"
)";

/// `text` with its first occurrence of `old` replaced.
inline std::string changed(std::string text, const std::string& old, const std::string& replacement) {
    const auto at = text.find(old);
    if (at == std::string::npos) throw std::logic_error("the scene has no '" + old + "'");
    return text.replace(at, old.size(), replacement);
}

/// All faults of a scene, one a line, from parsing to the checks of the mesh; "" when it is good.
inline std::string faults_of(const std::string& text, const std::vector<std::string>& overrides = {}) {
    try {
        const auto scene = parse_scene(text, "scene.toml", overrides);
        check_mesh(scene, build_mesh(scene));
    } catch (const SceneError& error) {
        return error.what();
    }
    return "";
}

}  // namespace percuss::testing
