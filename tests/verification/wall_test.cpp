// Rigid walls: a bar against one, straight and inclined, and against a held body in its place.
#include <cmath>

#include "verification/run.hpp"

namespace percuss::testing {
namespace {

const double wave_speed = std::sqrt(young / density);

std::string wall(const std::string& point, const std::string& normal) {
    return "[[wall]]\nname = \"anvil\"\npoint = " + point + "\nnormal = " + normal + "\n";
}

TEST(Wall, ABarReboundsAfterTheWaveHasGoneToAndFro) {
    // Stress rho c V for 2 L/c, restitution 1 but for the plastic stop of the face nodes, 1/(2N) of the
    // energy.
    RecordedRun run(scene_of(scene_head("axisymmetric", 0.05, 0) +
                             box_body("bar", {0, 0, 5, 100}, {3, 50}, "velocity = [0, -10]") +
                             wall("[0, 0]", "[0, 1]") + contact_pair("impact", "bar.bottom", "anvil")));
    run.to_end();
    const double impulse = run.solver.statistics().pairs[0].impulse[1];
    const double force = density * wave_speed * 10 * M_PI * 25;
    EXPECT_NEAR(impulse, force * 200 / wave_speed, 0.01 * impulse);
    // Half of one element's momentum goes with the plastic stop and about as much stays as vibration.
    EXPECT_NEAR(run.column("body.bar.velocity.axial").back(), 10, 10 * 1.5 / 50);
    EXPECT_NEAR(run.solver.statistics().maximum_loss, 1 / (2 * 50.0), 1e-3);
    EXPECT_LT(run.unexplained_energy(), 1e-9 * run.solver.statistics().initial_energy);
    EXPECT_LT(run.solver.statistics().pairs[0].max_penetration, 1e-12);
}

TEST(Wall, AnInclinedWallTakesTheNormalMomentumOnly) {
    // A square falls flat on a wall at 30 degrees; its sides stand along and across the wall.
    const double c = std::cos(M_PI / 6), s = std::sin(M_PI / 6);
    const auto corner = [&](double along, double up) {
        return fmt::format("[{:.17g}, {:.17g}]", along * c - up * s, along * s + up * c);
    };
    const std::string square =
        fmt::format(R"([[body]]
name = "square"
material = "steel"
velocity = [0, -10]
[[body.block]]
corners = [{}, {}, {}, {}]
divisions = [6, 6]
)",
                    corner(0, 1e-3), corner(10, 1e-3), corner(10, 10.001), corner(0, 10.001));
    RecordedRun run(scene_of(scene_head("plane strain", 0.02, 0.3) + square +
                             wall("[0, 0]", fmt::format("[{:.17g}, {:.17g}]", -s, c)) +
                             contact_pair("impact", "square", "anvil")));
    run.to_end();
    const double vx = run.column("body.square.velocity.x").back(),
                 vy = run.column("body.square.velocity.y").back();
    EXPECT_NEAR(vx * c + vy * s, -10 * s, 1e-9) << "frictionless";
    EXPECT_GT(-vx * s + vy * c, 0) << "rebounds";
}

TEST(Wall, ActsAsAHeldBodyInItsPlace) {
    const std::string head = scene_head("axisymmetric", 0.02, 0.3);
    const std::string bar = box_body("bar", {0, 0, 5, 20}, {4, 16}, "velocity = [0, -10]");
    RecordedRun on_wall(
        scene_of(head + bar + wall("[0, 0]", "[0, 1]") + contact_pair("impact", "bar.bottom", "anvil"))),
        on_body(scene_of(head + bar +
                         box_body("anvil", {0, -5, 12, 0}, {1, 1}, "",
                                  "[[body.constraint]]\nfixed = [\"radial\", \"axial\"]\n") +
                         contact_pair("impact", "bar.bottom", "anvil.top")));
    on_wall.to_end();
    on_body.to_end();
    const auto a = on_wall.column("contact.impact.axial"), b = on_body.column("contact.impact.axial");
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t n = 0; n < a.size(); ++n) ASSERT_NEAR(a[n], b[n], 1e-9) << "row " << n;
}

}  // namespace
}  // namespace percuss::testing
