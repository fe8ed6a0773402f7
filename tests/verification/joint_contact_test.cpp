// Several pairs that share bodies, solved as one problem.
#include <algorithm>
#include <cmath>

#include "verification/run.hpp"

namespace percuss::testing {
namespace {

constexpr const char* joint = "[contact_solver]\nscheme = \"joint\"\n";

/// @param first 1 for axisymmetric scenes, where radial components carry no momentum of the whole.
double momentum_error(const RunStatistics& s, std::size_t first = 0) {
    double most = 0;
    for (std::size_t d = first; d < 2; ++d)
        most = std::max(most, std::abs(s.momentum_final[d] - s.momentum_initial[d] - s.external_impulse[d]));
    return most / (s.momentum_scale + s.external_impulse_gross);
}

TEST(JointContact, AgreesWithTheProjectionOnTwoRods) {
    RecordedRun pair(rods()), joint_run(rods({"contact_solver.scheme=joint"}));
    pair.to_end();
    joint_run.to_end();
    const RunStatistics a = pair.solver.statistics(), b = joint_run.solver.statistics();
    ASSERT_EQ(a.steps, b.steps);
    EXPECT_EQ(b.pairs[0].events, 2);
    EXPECT_NEAR(b.pairs[0].peak_force, a.pairs[0].peak_force, 0.01 * a.pairs[0].peak_force);
    EXPECT_NEAR(b.pairs[0].impulse[1], a.pairs[0].impulse[1], 1e-3 * a.pairs[0].impulse[1]);
    EXPECT_NEAR(b.maximum_loss, a.maximum_loss, 0.02 * a.maximum_loss);
    EXPECT_LT(b.maximum_growth, 1e-9);
    EXPECT_LT(momentum_error(b, 1), 1e-12);
}

/// A rod hits two that rest against each other; all equal, elastic, one-dimensional: the last leaves with the
/// speed of the first. The middle one is pressed by two pairs at once while the wave passes.
Scene cradle(const std::string& first, const std::string& second) {
    return scene_of(scene_head("plane stress", 0.06, 0) +
                    box_body("a", {-40, 0, 0, 4}, {40, 2}, "velocity = [2, 0]") +
                    box_body("b", {0, 0, 40, 4}, {40, 2}) + box_body("c", {40, 0, 80, 4}, {40, 2}) + joint +
                    first + second);
}

TEST(JointContact, ThreeRodsHandTheMotionOn) {
    const std::string left = contact_pair("left", "b.left", "a.right"),
                      right = contact_pair("right", "b.right", "c.left");
    RecordedRun run(cradle(left, right)), turned(cradle(right, left));
    run.to_end();
    turned.to_end();
    const RunStatistics s = run.solver.statistics();
    const auto bodies = run.solver.snapshot()->bodies;
    EXPECT_NEAR(bodies[0].velocity[0], 0, 0.06);
    EXPECT_GT(bodies[2].velocity[0], 0.93 * 2);
    EXPECT_LT(s.maximum_growth, 1e-9) << "energy only falls";
    EXPECT_LT(momentum_error(s), 1e-12);
    EXPECT_EQ(s.contact_solver.fallbacks, 0);
    ASSERT_EQ(run.solver.nodes().size(), turned.solver.nodes().size());
    for (std::size_t n = 0; n < run.solver.nodes().size(); ++n)
        for (int d = 0; d < 2; ++d)
            ASSERT_NEAR(run.solver.nodes()[n].x[d], turned.solver.nodes()[n].x[d], 1e-9) << "order of pairs";
}

/// A block dropped obliquely into the corner between two others: three pairs meet there.
Scene corner(const std::string& extra = "") {
    return scene_of(scene_head("plane strain", 0.02, 0.3) +
                    box_body("floor", {0, 0, 12, 4}, {9, 4}, "",
                             "[[body.constraint]]\nedge = \"bottom\"\nfixed = [\"x\", \"y\"]\n") +
                    box_body("wall", {0, 4, 4, 10}, {4, 7}) +
                    box_body("block", {4.02, 4.03, 9, 8}, {5, 5}, "velocity = [-20, -30]") + joint +
                    contact_pair("floor-wall", "wall.bottom", "floor.top") +
                    contact_pair("floor-block", "block.bottom", "floor.top") +
                    contact_pair("wall-block", "block.left", "wall.right") + extra);
}

TEST(JointContact, CornerOfThreeBodiesKeepsMomentumAndEnergy) {
    RecordedRun run(corner());
    run.to_end();
    const RunStatistics s = run.solver.statistics();
    for (const PairStatistics& pair : s.pairs) EXPECT_GT(std::hypot(pair.impulse[0], pair.impulse[1]), 1e-3);
    EXPECT_GT(std::abs(s.momentum_final[1] - s.momentum_initial[1]), 0.1 * s.momentum_scale)
        << "the floor is held";
    EXPECT_LT(momentum_error(s), 1e-12) << "the supports' impulse accounts for it";
    EXPECT_LT(s.maximum_growth, 1e-4);
    for (const PairStatistics& pair : s.pairs) EXPECT_LT(pair.max_penetration, 0.01 * 0.57) << "mm";
    EXPECT_LT(run.unexplained_energy() / s.initial_energy, 1e-9);
}

// A block at rest on a held floor under its weight: nothing may creep or shake.
TEST(JointContact, BlockRestsUnderItsWeight) {
    Scene scene = scene_of(scene_head("plane strain", 0.5, 0.3) +
                           box_body("floor", {0, 0, 12, 4}, {9, 4}, "",
                                    "[[body.constraint]]\nedge = \"bottom\"\nfixed = [\"x\", \"y\"]\n") +
                           box_body("block", {3, 4, 9, 8}, {5, 4}, "body_force = [0, -9.81e-3]") + joint +
                           contact_pair("rest", "block.bottom", "floor.top"));
    RecordedRun run(scene);
    run.to_end();
    const RunStatistics s = run.solver.statistics();
    const double weight = 24 * density * 9.81e-3;
    const auto force = run.column("contact.rest.y"), time = run.column("time");
    double mean = 0;
    for (std::size_t n = 1; n < force.size(); ++n) mean += force[n] * (time[n] - time[n - 1]);
    EXPECT_NEAR(mean / time.back(), weight, 0.03 * weight);
    EXPECT_LT(s.pairs[0].max_penetration, 1e-9) << "mm";
    EXPECT_LT(momentum_error(s), 1e-12);
}

}  // namespace
}  // namespace percuss::testing
