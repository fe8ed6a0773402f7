#pragma once

#include <span>
#include <string>
#include <vector>

#include "aligned.hpp"
#include "contact/predicted_motion.hpp"
#include "contact/row.hpp"
#include "engine/contact/solvers/random_system.hpp"
#include "mesh/build.hpp"
#include "verification/run.hpp"

namespace percuss::testing {

/// Three blocks on top of each other, with meshes that do not match, and a fourth that leans on all of them:
/// nodes at the seams belong to three pairs.
inline Scene stack(const std::vector<int>& order = {0, 1, 2, 3, 4},
                   const std::vector<std::string>& overrides = {}) {
    const std::vector<std::string> pairs{
        contact_pair("low", "a.top", "b.bottom"), contact_pair("high", "b.top", "c.bottom"),
        contact_pair("side-a", "a.right", "d.left"), contact_pair("side-b", "b.right", "d.left"),
        contact_pair("side-c", "c.right", "d.left")};
    std::string text = scene_head("plane strain", 1, 0.3) + box_body("a", {0, 0, 4, 1}, {7, 2}) +
                       box_body("b", {0, 1, 4, 2}, {5, 2}) + box_body("c", {0, 2, 4, 3}, {6, 2}) +
                       box_body("d", {4, 0, 5, 3}, {2, 8}) + "[contact_solver]\nscheme = \"joint\"\n";
    for (const int k : order) text += pairs[static_cast<std::size_t>(k)];
    return scene_of(text, overrides);
}

/// A step of contact alone, from random velocities that press the blocks together.
template <class Contact>
struct RandomStep {
    Scene scene;
    Mesh mesh;
    AlignedVector<Node> nodes;
    std::vector<double> inverse_mass, impulse;
    std::vector<std::int32_t> touched;
    RunStatistics statistics;
    double dt = 1e-3, kick = 0.9e-3;
    Contact contact;
    std::vector<Node> predicted;

    RandomStep(Scene s, Rng& random) : scene(std::move(s)), mesh(build_mesh(scene)), contact(scene, mesh) {
        for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
            const double x = mesh.nodes[n].x(), y = mesh.nodes[n].y();
            const double vx = -0.3 * (x - 2) + random.uniform(-0.3, 0.3),
                         vy = -0.3 * (y - 1.5) + random.uniform(-0.3, 0.3);
            nodes.push_back({{x + dt * vx, y + dt * vy}, {vx, vy}});
            const double inverse = random.uniform(0.5, 2);
            inverse_mass.insert(inverse_mass.end(), {inverse, inverse});
        }
        predicted.assign(nodes.begin(), nodes.end());
        impulse.assign(inverse_mass.size(), 0);
    }
    void resolve() {
        PredictedMotion motion{dt, kick, nodes.data(), inverse_mass.data(), impulse.data(), &touched};
        contact.resolve(motion, statistics);
    }
    [[nodiscard]] double gap_rate(std::span<const RowTerm> terms) const {
        return along(terms, [&](std::int32_t node) { return nodes[static_cast<std::size_t>(node)].v; });
    }
};

}  // namespace percuss::testing
