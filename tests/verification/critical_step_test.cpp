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

TEST(CriticalStep, AboveItAFixedStepIsRefused) {
    EXPECT_THROW(Solver(rods({"model.step.fixed=0.0004"})), SceneError);
}

}  // namespace
}  // namespace percuss::testing
