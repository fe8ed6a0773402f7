// Energy lost by the plastic stop of the contact nodes: closed forms, O(h).
#include <cmath>

#include "verification/run.hpp"

namespace percuss::testing {
namespace {

double loss_of_rods(double striker_element, double rod_element) {
    RecordedRun run(
        rods({fmt::format("body.striker.block.0.divisions=[2,{}]", std::lround(100 / striker_element)),
              fmt::format("body.rod.block.0.divisions=[2,{}]", std::lround(200 / rod_element)),
              "model.duration=0.02"}));
    run.to_end();
    return run.solver.statistics().maximum_loss;
}

// The first step takes exactly the closed form; later steps of the same contact move nodes that move alike
// already. What the finite strain of 1e-3 changes of it is below 1e-3.
constexpr double tolerance = 1e-3;

TEST(ImpactLoss, OfRodsIsTheClosedForm) {
    // dE/E0 = h1 h2 / (2 (h1 + h2) L1)
    for (const auto& [h1, h2] : {std::pair{4.0, 4.0}, {2.0, 2.0}, {1.0, 1.0}, {2.0, 4.0}, {4.0, 1.0}}) {
        const double exact = h1 * h2 / (2 * (h1 + h2) * 100);
        EXPECT_NEAR(loss_of_rods(h1, h2), exact, tolerance * exact) << h1 << " against " << h2;
    }
}

// Named by bodies: corners stand on corners, and lateral sides are as near as the faces (node-to-side lost 42
// % where rim nodes took those).
TEST(ImpactLoss, OfWholeOutlinesIsTheSame) {
    for (const char* scheme : {"node-to-side", "symmetric", "segment-to-segment"}) {
        RecordedRun run(load_scene(
            PERCUSS_SOURCE_DIR "/scenes/hard/faces-5v7.toml",
            {"parameters.m=5", "parameters.poisson=0", std::string("contact.impact.scheme=") + scheme}));
        run.to_end();
        EXPECT_NEAR(run.solver.statistics().maximum_loss, 0.005, tolerance * 0.005) << scheme;
        EXPECT_EQ(run.solver.statistics().pairs[0].events, 2) << scheme;
    }
}

TEST(ImpactLoss, HalvesWithTheMesh) {
    EXPECT_NEAR(loss_of_rods(4, 4) / loss_of_rods(2, 2), 2, 0.01);
    EXPECT_NEAR(loss_of_rods(2, 2) / loss_of_rods(1, 1), 2, 0.01);
}

TEST(ImpactLoss, OnARigidWallIsHalfAnElement) {
    // 1 / (2 N) of the energy: half of one element's mass stops.
    for (const int n : {10, 20, 40}) {
        RecordedRun run(scene_of(
            scene_head("plane stress", 0.06, 0) +
            box_body("bar", {0, 0, 2, 100}, {1, n}, "velocity = [0, -10]") +
            box_body("wall", {-5, -5, 7, 0}, {3, 1}, "", "[[body.constraint]]\nfixed = [\"x\", \"y\"]") +
            contact_pair("hit", "bar.bottom", "wall.top")));
        run.to_end();
        EXPECT_NEAR(run.solver.statistics().maximum_loss, 0.5 / n, 0.5 / n * tolerance) << n << " elements";
    }
}

}  // namespace
}  // namespace percuss::testing
