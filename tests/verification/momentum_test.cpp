// Momenta of an oblique impact of two free bodies with faces that do not match.
#include <cmath>

#include "verification/run.hpp"

namespace percuss::testing {
namespace {

Scene oblique(const std::string& element, const std::string& sign = "restricted", double courant = 0.9) {
    const std::string keys = fmt::format("element = \"{}\"\n", element);
    return scene_of(scene_head("plane strain", 0.02, 0.3, fmt::format("courant = {}", courant)) +
                    box_body("flyer", {1, 10, 7, 16}, {5, 6}, keys + "velocity = [15, -30]") +
                    box_body("target", {0, 0, 12, 10}, {7, 8}, keys) +
                    contact_pair("hit", "flyer.bottom", "target.top") + "sign = \"" + sign + "\"\n");
}

double momentum_error(const RunStatistics& s) {
    return std::hypot(s.momentum_final[0] - s.momentum_initial[0],
                      s.momentum_final[1] - s.momentum_initial[1]) /
           s.momentum_scale;
}

TEST(Momentum, IsConservedToRounding) {
    for (const char* element : {"one-point quad", "mean-dilatation quad", "triangle", "averaged triangle"}) {
        for (const char* sign : {"restricted", "unrestricted"}) {
            RecordedRun run(oblique(element, sign));
            run.to_end();
            EXPECT_GT(run.solver.statistics().pairs[0].impulse[1], 0.01);
            EXPECT_LT(momentum_error(run.solver.statistics()), 1e-12) << element << ", " << sign;
        }
    }
}

TEST(Momentum, OfEachBodyIsWhatTheHistorySays) {
    RecordedRun run(oblique("one-point quad"));
    run.to_end();
    const auto snapshot = run.solver.snapshot();
    const auto& mesh = snapshot->setup->mesh;
    for (std::size_t body = 0; body < 2; ++body) {
        double mass = 0, momentum[2] = {0, 0};
        for (auto n = static_cast<std::size_t>(mesh.bodies[body].node_begin);
             n < static_cast<std::size_t>(mesh.bodies[body].node_end); ++n) {
            mass += run.solver.lumped_mass()[n];
            for (std::size_t d = 0; d < 2; ++d)
                momentum[d] += run.solver.lumped_mass()[n] * run.solver.nodes()[n].v[d];
        }
        for (std::size_t d = 0; d < 2; ++d)
            EXPECT_NEAR(snapshot->bodies[body].velocity[d], momentum[d] / mass, 1e-12 * 30);
    }
}

TEST(AngularMomentum, OfInternalForcesIsConservedToRounding) {
    // One body alone, deformed and turning: sum m x_(n+1) x v_(n+1/2) changes only by the moment of forces at
    // x_n.
    RecordedRun run(
        scene_of(scene_head("plane strain", 0.02, 0.3) + box_body("block", {1, 2, 7, 6}, {6, 4})));
    SolverState state = run.solver.save();
    for (Node& node : state.nodes) {
        node.v[0] = -3 * node.x[1] + 0.2 * node.x[0] * node.x[1];
        node.v[1] = 3 * node.x[0];
    }
    state.ledger.initial_kinetic = state.ledger.lowest = 1;
    run.solver.restore(state);
    const double before = run.solver.angular_momentum();
    run.to_end();
    EXPECT_NEAR(run.solver.angular_momentum(), before, 1e-12 * std::abs(before));
}

TEST(AngularMomentum, OfContactIsConservedUpToTheSlipOfAStep) {
    // Contact forces act along the normal at the end of a step, their moment counts at its beginning: what is
    // lost is the impulse times the slip within a step, first order in dt.
    const auto lost = [](double courant) {
        RecordedRun run(oblique("one-point quad", "restricted", courant));
        run.to_end();
        const RunStatistics s = run.solver.statistics();
        return std::abs(s.angular_momentum_final - s.angular_momentum_initial) /
               std::abs(s.angular_momentum_initial);
    };
    const double coarse = lost(0.9), fine = lost(0.225);
    RecordProperty("at_0.9", fmt::format("{:.3g}", coarse));
    RecordProperty("at_0.225", fmt::format("{:.3g}", fine));
    // Slip 15 m/s in 0.15 us is 2 um on an arm of 10 mm; impulse * arm is of the order of the angular
    // momentum.
    EXPECT_LT(coarse, 1e-3);
    EXPECT_LT(fine, 0.5 * coarse);
}

}  // namespace
}  // namespace percuss::testing
