// The energy ledger: e = E - I - K closes to rounding with contact work; its strain energy is what the
// elements hold.
#include <cmath>

#include "engine/run/change_values.hpp"
#include "verification/run.hpp"

namespace percuss::testing {
namespace {

std::string impact(const std::string& geometry, const std::string& element,
                   const std::string& material_extra = "") {
    const bool ring = geometry == "axisymmetric";
    const std::string keys = fmt::format("element = \"{}\"\n", element);
    return scene_head(geometry, 0.015, 0.3, "courant = 0.9", material_extra) +
           box_body("flyer", {0, 10, 6, 16}, {5, 6},
                    keys + fmt::format("velocity = [{}, -30]", ring ? 0 : 5)) +
           box_body("target", {0, 0, 12, 10}, {7, 8}, keys) +
           contact_pair("hit", "flyer.bottom", "target.top");
}

TEST(Ledger, ClosesForEveryElementAndGeometry) {
    for (const char* geometry : {"axisymmetric", "plane strain", "plane stress"}) {
        for (const char* element :
             {"one-point quad", "mean-dilatation quad", "triangle", "averaged triangle"}) {
            RecordedRun run(scene_of(impact(geometry, element)));
            run.to_end();
            const RunStatistics s = run.solver.statistics();
            const std::string name = std::string(geometry) + ", " + element;
            EXPECT_LT(run.unexplained_energy(), 1e-12 * s.initial_energy) << name;
            // Second-order mid-step strains and trapezoidal work: squares of a step's strain, 1e-5 of the
            // stored energy.
            EXPECT_LT(s.elastic_energy_error, 1e-4) << name;
            RecordProperty(name, fmt::format("{:.2g}", s.elastic_energy_error));
            EXPECT_LT(s.pairs[0].work, 0) << name;
            EXPECT_LT(s.maximum_growth, 1e-3) << name;
        }
    }
}

TEST(Ledger, ClosesWhileTheStepChanges) {
    RecordedRun run(scene_of(impact("plane strain", "one-point quad")));
    for (int n = 0; !run.solver.finished(); ++n) {
        change_step(run.solver, 0.3 + 0.55 * std::abs(std::sin(0.3 * n)));
        run.step();
    }
    EXPECT_LT(run.solver.statistics().dt_min, 0.5 * run.solver.statistics().dt_max);
    EXPECT_LT(run.unexplained_energy(), 1e-12 * run.solver.statistics().initial_energy);
    // Forces act for the mean of two steps, (dt_before + dt_after) / 2, with each of the two velocities:
    // where steps differ by a tenth, as here, so do the two works that should make up the strain energy; the
    // differences alternate.
    EXPECT_LT(run.solver.statistics().elastic_energy_error, 5e-3);
}

TEST(Ledger, ClosesWithLoadsAndPrescribedMotion) {
    const std::string driven =
        "[[body.prescribed]]\nedge = \"top\"\ndirection = \"y\"\nvelocity = [[0, 0], [0.01, -20], [0.02, "
        "5]]\n"
        "[[body.load]]\nedge = \"right\"\npressure = [[0, 0], [0.01, 0.2]]\ntraction = [0, 0.05]\n";
    RecordedRun run(scene_of(scene_head("plane strain", 0.03, 0.3) +
                             box_body("tool", {0, 10, 6, 16}, {5, 6}, "body_force = [0, -9]", driven) +
                             box_body("work", {0, 0, 12, 10}, {7, 8}, "",
                                      "[[body.constraint]]\nedge = \"bottom\"\nfixed = [\"x\", \"y\"]") +
                             contact_pair("press", "tool.bottom", "work.top")));
    run.to_end();
    const double put_in = run.column("energy.external").back();
    EXPECT_GT(put_in, 0.01);
    EXPECT_GT(run.solver.statistics().pairs[0].closings, 5);
    EXPECT_LT(run.unexplained_energy(), 1e-12 * put_in);
    EXPECT_LT(run.solver.statistics().elastic_energy_error, 1e-4);
}

TEST(Ledger, ClosesWhenADrivenBodyIsHit) {
    // Contact on nodes whose velocity is imposed: the drive takes the impulse.
    const std::string driven =
        "[[body.prescribed]]\ndirection = \"y\"\nvelocity = -20\n[[body.constraint]]\nfixed = [\"x\"]\n";
    RecordedRun run(scene_of(
        scene_head("plane strain", 0.01, 0.3) + box_body("hammer", {-3, 10.05, 15, 13}, {5, 2}, "", driven) +
        box_body("work", {0, 0, 12, 10}, {7, 8}) + contact_pair("press", "work.top", "hammer.bottom")));
    run.to_end();
    const double put_in = run.column("energy.external").back();
    EXPECT_LT(run.unexplained_energy(), 1e-12 * put_in);
    EXPECT_LT(run.solver.snapshot()->bodies[1].velocity[1], -10);
    // The force history is what the free body took.
    const double mass = density * 12 * 10;
    EXPECT_NEAR(run.solver.statistics().pairs[0].impulse[1],
                mass * run.solver.snapshot()->bodies[1].velocity[1], 1e-12);
}

TEST(Ledger, BulkViscosityOnlyTakesEnergy) {
    for (const char* geometry : {"axisymmetric", "plane strain"}) {
        for (const char* element :
             {"one-point quad", "mean-dilatation quad", "triangle", "averaged triangle"}) {
            RecordedRun run(
                scene_of(impact(geometry, element, "viscosity = { linear = 0.06, quadratic = 1.2 }")));
            run.to_end();
            const RunStatistics s = run.solver.statistics();
            const auto viscous = run.column("energy.viscous");
            EXPECT_GT(viscous.back(), 0.01 * s.initial_energy);
            EXPECT_LT(viscous.back(), 0.5 * s.initial_energy);
            // A leapfrog's viscous force also works through the next half step; where an element has turned
            // to expanding by then it gives back a little, never more than it took in the half step before.
            for (std::size_t n = 2; n < viscous.size(); ++n)
                ASSERT_GE(viscous[n], viscous[n - 2] - 1e-3 * viscous.back()) << element << " row " << n;
            EXPECT_LT(run.unexplained_energy(), 1e-12 * s.initial_energy) << geometry << ", " << element;
            EXPECT_LT(s.elastic_energy_error, 1e-4) << geometry << ", " << element;
            RecordProperty(std::string(geometry) + " " + element,
                           fmt::format("{:.2g}", s.elastic_energy_error));
        }
    }
}

TEST(Ledger, HourglassLineIsPartOfTheInternalWork) {
    RecordedRun run(scene_of(impact("plane strain", "one-point quad")));
    run.to_end();
    const auto hourglass = run.column("energy.hourglass");
    EXPECT_GT(*std::max_element(hourglass.begin(), hourglass.end()), 0);
    EXPECT_LT(*std::max_element(hourglass.begin(), hourglass.end()),
              0.1 * run.solver.statistics().initial_energy);
}

}  // namespace
}  // namespace percuss::testing
