#pragma once

#include <cstdint>
#include <functional>
#include <ostream>

#include "verification/run.hpp"

namespace percuss::testing {

/// Two blocks, one driven into the other for a while, then let go.
inline Scene driven_for_a_while() {
    return scene_of(
        scene_head("plane strain", 0.04, 0.3) +
        box_body("ram", {0, 4, 6, 8}, {6, 4}, "",
                 "[[body.prescribed]]\nedge = \"top\"\ndirection = \"y\"\nvelocity = [[0, 0], [0.004, -20]]\n"
                 "from = 0.002\nuntil = 0.008\n") +
        box_body("block", {1, 0, 7, 4}, {5, 4}) + contact_pair("push", "ram.bottom", "block.top"));
}

/// A corner that slides over a corner: which face holds a node depends on where it came from.
/// @param pair what the [[contact]] says.
inline Scene past_a_corner(const std::string& scheme,
                           const std::string& pair = "master = \"flyer\"\nslave = \"block\"\n") {
    return scene_of(scene_head("plane strain", 0.1, 0.3) + "[contact_solver]\nscheme = \"" + scheme + "\"\n" +
                    box_body("flyer", {-6, 0.01, 0.5, 4}, {13, 8}, "velocity = [30, -20]") +
                    box_body("block", {0, -6, 8, 0}, {8, 6}, "velocity = [-5, 0]") +
                    "[[contact]]\nname = \"hit\"\n" + pair);
}

/// The same, from a start that overlaps a little.
inline Scene past_a_corner_by(const std::string& scheme) {
    Scene scene = past_a_corner("joint", "bodies = [\"flyer\", \"block\"]\nscheme = \"" + scheme + "\"\n");
    for (Vec2& corner : scene.bodies[0].blocks[0].corners) corner.y() -= 0.02;
    return scene;
}

inline Scene nail(const std::string& scheme, const std::string& friction = "0") {
    return load_scene(
        PERCUSS_SOURCE_DIR "/scenes/nail.toml",
        {"parameters.mesh=0.5", "contact_solver.scheme=" + scheme, "parameters.friction=" + friction});
}

/// One of each kind of run: what one may forget to save, another needs.
struct Kind {
    const char* name;
    std::function<Scene()> scene;
    std::int64_t steps = 600;  ///< at most
};

inline void PrintTo(const Kind& kind, std::ostream* to) { *to << kind.name; }

inline const Kind kinds_of_runs[] = {
    {"rods", [] { return rods(); }},
    {"rods_lagged",
     [] {
         return rods({"model.lagged=true", "model.energy_growth_limit=100"});
     }},
    {"rods_of_mean_dilatation", [] { return rods({"body.striker.element=mean-dilatation quad"}); }},
    {"rods_of_averaged_triangles", [] { return rods({"body.striker.element=averaged triangle"}); }},
    {"corner_by_pairs", [] { return past_a_corner("projection"); }},
    {"corner_jointly", [] { return past_a_corner("joint"); }},
    {"corner_symmetrically", [] { return past_a_corner_by("symmetric"); }},
    {"corner_by_segments", [] { return past_a_corner_by("segment-to-segment"); }},
    {"corner_at_velocity_level",
     [] { return past_a_corner("joint", "bodies = [\"flyer\", \"block\"]\nlevel = \"velocity\"\n"); }},
    {"corner_on_springs",
     [] { return past_a_corner("penalty", "bodies = [\"flyer\", \"block\"]\nfriction = 0.2\n"); }},
    {"corner_on_springs_with_inertia",
     [] { return past_a_corner("bipenalty", "bodies = [\"flyer\", \"block\"]\n"); }},
    {"corner_without_mass",
     [] { return past_a_corner("massless", "bodies = [\"flyer\", \"block\"]\n"); }},
    {"corner_with_damped_layers",
     [] {
         return past_a_corner("joint", "bodies = [\"flyer\", \"block\"]\nlayer = { viscosity = 0.06 }\n");
     }},
    {"nail_jointly", [] { return nail("joint"); }, 1500},
    {"nail_with_friction", [] { return nail("joint", "0.1"); }, 1500},
    {"nail_by_pairs", [] { return nail("projection"); }, 1500},
    {"sliding_with_friction", [] { return load_scene(PERCUSS_SOURCE_DIR "/scenes/sliding_block.toml"); }},
    {"taylor", [] { return load_scene(PERCUSS_SOURCE_DIR "/scenes/taylor.toml"); }},
    {"driven", [] { return driven_for_a_while(); }}};

}  // namespace percuss::testing
