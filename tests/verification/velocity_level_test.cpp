// The velocity level: what it leaves open, and when it takes hold.
#include <algorithm>
#include <cmath>

#include "verification/schemes.hpp"

namespace percuss::testing {
namespace {

/// A bar of 20 elements that flies at a floor from a gap above it.
Scene bar(double gap, const char* level, double duration = 0.06) {
    return scene_of(scene_head("plane stress", duration, 0) +
                    box_body("bar", {0, gap, 2, 100 + gap}, {1, 20}, "velocity = [0, -10]") +
                    "[[wall]]\nname = \"floor\"\npoint = [0, 0]\nnormal = [0, 1]\n" + joint_problem +
                    contact_pair("hit", "bar.bottom", "floor") + fmt::format("level = \"{}\"\n", level));
}

/// Lowest place of the bar, once it has stopped.
double lowest(RecordedRun& run) {
    double low = 1e9;
    for (const Node& node : run.solver.nodes().first(2)) low = std::min(low, node.x[1]);
    return low;
}

TEST(VelocityLevel, StopsAStepBeforeTheGapIsClosedAndLosesAsMuch) {
    Solver probe(bar(0, "velocity"));
    const double travel = 0.9 * probe.critical_step() * 10;
    for (const double part : {0.1, 0.37, 0.5, 0.9}) {
        const double gap = (3 + part) * travel;
        RecordedRun run(bar(gap, "velocity"));
        double low = gap;
        for (int n = 0; n < 60; ++n) {
            run.step();
            low = lowest(run);
        }
        // Three or four steps of flight; the rest of the gap stays, for the row persists.
        EXPECT_GE(low, -1e-12) << part;
        EXPECT_NEAR(low, part * travel, 0.01 * travel) << part;
        run.to_end();
        const RunStatistics s = run.solver.statistics();
        EXPECT_NEAR(s.maximum_loss, 0.5 / 20, 1e-3 * 0.5 / 20) << "half an element of twenty, at any phase";
        EXPECT_EQ(s.pairs[0].events, 2) << part;
        EXPECT_LT(momentum_error(s), 1e-12);
        EXPECT_LT(run.unexplained_energy(), 1e-12 * s.initial_energy);
    }
}

TEST(VelocityLevel, PositionLevelClosesTheGap) {
    Solver probe(bar(0, "position"));
    const double travel = 0.9 * probe.critical_step() * 10;
    RecordedRun run(bar(3.5 * travel, "position"));
    for (int n = 0; n < 60; ++n) run.step();
    EXPECT_NEAR(lowest(run), 0, 1e-6 * travel);
}

// A block that lands on its corner and rocks: what is not linear within a step adds energy of second order in
// the step, as at the position level. (With rates held instead of gaps, it was of first order.)
TEST(VelocityLevel, AddsEnergyOfSecondOrderInTheStep) {
    const auto growth = [](double courant) {
        RecordedRun run(scene_of(scene_head("plane strain", 0.02, 0.3, fmt::format("courant = {}", courant)) +
                                 box_body("flyer", {1, 10.003, 7, 16}, {5, 6}, "velocity = [15, -30]") +
                                 box_body("target", {0, 0, 12, 10}, {7, 8}) + joint_problem +
                                 bodies_pair("hit", "flyer", "target", "symmetric") + "level = \"velocity\"\n"));
        run.to_end();
        return run.solver.statistics().maximum_growth;
    };
    const double coarse = growth(0.9), fine = growth(0.3);
    EXPECT_LT(coarse, 6e-5) << "of the initial energy";
    EXPECT_LT(fine, 1.5 * coarse / 9);
}

}  // namespace
}  // namespace percuss::testing
