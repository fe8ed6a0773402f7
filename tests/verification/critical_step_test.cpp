// The solver's element estimate of the critical step against its own power iteration.
#include "verification/run.hpp"

namespace percuss::testing {
namespace {

TEST(CriticalStep, EstimateIsBelowPowerIteration) {
    for (const char* geometry : {"axisymmetric", "plane strain", "plane stress"}) {
        for (const char* element :
             {"one-point quad", "mean-dilatation quad", "triangle", "averaged triangle"}) {
            for (const double nu : {0.0, 0.3, 0.48}) {
                const Solver solver(scene_of(
                    scene_head(geometry, 1, nu) +
                    box_body("a", {0, 0, 6, 9}, {6, 7}, fmt::format("element = \"{}\"", element)) +
                    box_body("b", {0, 9, 12, 12}, {5, 3}, fmt::format("element = \"{}\"", element),
                             "[[body.constraint]]\nedge = \"top\"\nfixed = [\"" +
                                 std::string(geometry == std::string("axisymmetric") ? "axial" : "y") +
                                 "\"]")));
                // Power iteration comes from above and stops within its convergence: 1e-9 a turn, 1e-6 in
                // all.
                const double power = solver.critical_step_by_power_iteration(20000);
                EXPECT_LE(solver.critical_step(), power * (1 + 1e-6))
                    << geometry << ", " << element << ", nu " << nu;
                // Averaging softens volumes, which the bound of single elements does not see.
                EXPECT_GT(solver.critical_step(),
                          (element == std::string("averaged triangle") ? 0.4 : 0.6) * power)
                    << geometry << ", " << element << ", nu " << nu;
            }
        }
    }
}

TEST(CriticalStep, OfTheRodsIsNearlyTheChainOfMasses) {
    const Solver solver(rods());
    const double chain = 2 / std::sqrt(young / density);
    EXPECT_NEAR(solver.critical_step_by_power_iteration(), chain, 1e-3 * chain);
    EXPECT_GT(solver.critical_step(), 0.98 * chain);
}

TEST(CriticalStep, FollowsTheDeformation) {
    // A block squeezed by a fifth between a wall and a drive: elements get lower, the step shorter.
    RecordedRun run(
        scene_of(scene_head("plane strain", 0.2, 0.0) +
                 box_body("block", {0, 0, 10, 10}, {5, 5}, "",
                          "[[body.constraint]]\nedge = \"bottom\"\nfixed = [\"y\"]\n"
                          "[[body.prescribed]]\nedge = \"top\"\ndirection = \"y\"\nvelocity = -10\n")));
    run.to_end();
    const RunStatistics s = run.solver.statistics();
    EXPECT_LT(s.critical_step_min, 0.9 * s.critical_step_initial);
    EXPECT_GT(s.critical_step_min, 0.5 * s.critical_step_initial);
}

TEST(CriticalStep, IsEvaluatedInTimeInABodyThatWasAtRest) {
    // A driven press runs into a block at rest: nothing moved in the block when its step was last evaluated.
    RecordedRun run(
        scene_of(scene_head("plane strain", 1.0, 0.3) +
                 box_body("block", {0, 0, 10, 10}, {10, 10}, "",
                          "[[body.constraint]]\nfixed = [\"x\"]\n[[body.constraint]]\nedge = "
                          "\"bottom\"\nfixed = [\"y\"]\n") +
                 box_body("press", {-2, 10.5, 12, 12}, {3, 1}, "",
                          "[[body.prescribed]]\ndirection = \"y\"\nvelocity = -200\n"
                          "[[body.prescribed]]\ndirection = \"x\"\nvelocity = 0\n") +
                 "[[contact]]\nname = \"hit\"\nmaster = \"block.top\"\nslave = \"press.bottom\"\n"));
    double lowest = 1;
    while (!run.solver.finished() && run.solver.time() < 0.02) {
        ASSERT_FALSE(run.solver.step());
        double highest = 0;
        for (const Batch& batch : run.solver.batches())
            highest = std::max(highest,
                               batch.kernel.frequency(batch, run.solver.nodes().data(), 0, batch.blocks()));
        // A strain of 5 % raises a frequency by 10 % (modulus and size), and so may the step in which it
        // comes.
        ASSERT_LT(run.solver.critical_step() * std::sqrt(highest) / 2, 1.25) << run.solver.time();
        lowest =
            std::min(lowest, 2 / std::sqrt(highest) / run.solver.statistics(false).critical_step_initial);
    }
    EXPECT_LT(lowest, 0.75) << "the press has hardly squeezed the block";
}

TEST(CriticalStep, AboveItAFixedStepIsRefused) {
    EXPECT_THROW(Solver(rods({"model.step.fixed=0.0004"})), SceneError);
}

}  // namespace
}  // namespace percuss::testing
