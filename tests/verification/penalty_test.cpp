// Springs between surfaces: their frequency and energy against closed forms, and what keeps them stable.
#include <algorithm>
#include <cmath>

#include "verification/schemes.hpp"

namespace percuss::testing {
namespace {

std::string springs(const std::string& scheme, double penalty, const std::string& more = "") {
    return fmt::format("[contact_solver]\nscheme = \"{}\"\npenalty = {:.17g}\n{}", scheme, penalty, more);
}

/// A stiff block of one element, 4 by 4, thrown at the floor: m x'' = k depth with m of half the block at
/// each of two nodes. Soft springs: it bounces as a whole.
Scene thrown(const std::string& solver, const std::string& step = "courant = 0.9") {
    return scene_of(scene_head("plane strain", 0.4, 0.0, step) +
                    box_body("block", {0, 0, 4, 4}, {1, 1}, "velocity = [0, -1]") +
                    "[[wall]]\nname = \"floor\"\npoint = [0, 0]\nnormal = [0, 1]\n" + solver +
                    contact_pair("hit", "block.bottom", "floor"));
}

TEST(Penalty, BounceOfABlockIsThatOfAMassOnItsSprings) {
    constexpr double factor = 1e-4;
    RecordedRun run(thrown(springs("penalty", factor)));
    run.to_end();
    // Both nodes: f K A^2 / V with K = E / 3 for nu = 0, A = 4, V = 16.
    const double stiffness = 2 * factor * young / 3, mass = 16 * density;
    const double contact_time = M_PI * std::sqrt(mass / stiffness), depth = std::sqrt(mass / stiffness);
    const auto time = run.column("time"), force = run.column("contact.hit.y");
    const auto first = std::find_if(force.begin(), force.end(), [](double f) { return f > 0; });
    const auto last = std::find_if(force.rbegin(), force.rend(), [](double f) { return f > 0; });
    const double lasted = time[static_cast<std::size_t>(force.rend() - last) - 1] -
                          time[static_cast<std::size_t>(first - force.begin())];
    EXPECT_NEAR(lasted, contact_time, 0.01 * contact_time);
    const RunStatistics s = run.solver.statistics();
    EXPECT_NEAR(s.pairs[0].max_penetration, depth, 0.01 * depth);
    EXPECT_NEAR(s.pairs[0].impulse[1], 2 * mass, 0.01 * 2 * mass) << "it comes back as fast as it went";
    EXPECT_EQ(s.pairs[0].events, 2);
    EXPECT_LT(s.maximum_growth, 1e-4) << "what the springs hold is counted";
    EXPECT_LT(run.unexplained_energy(), 1e-12 * s.initial_energy);
    EXPECT_LT(momentum_error(s), 1e-12);
}

/// Two blocks that press on each other through faces that do not match.
Scene pressing(const std::string& solver, const std::string& step = "courant = 0.98", double gap = 0) {
    return scene_of(scene_head("plane strain", 0.05, 0.3, step) +
                    box_body("upper", {0, 4 + gap, 6, 8 + gap}, {7, 5}, "velocity = [0, -10]") +
                    box_body("lower", {0, 0, 6, 4}, {5, 4}) + solver +
                    bodies_pair("hit", "upper", "lower", std::string("symmetric")));
}

TEST(Penalty, LowersTheStepAsMuchAsStiffSpringsNeed) {
    for (const double factor : {0.1, 1.0, 10.0, 100.0}) {
        RecordedRun run(pressing(springs("penalty", factor)));
        run.to_end();
        const RunStatistics s = run.solver.statistics();
        EXPECT_LT(s.maximum_growth, 0.02) << factor;
        EXPECT_LT(s.dt_min, factor > 1 ? 0.5 * s.dt_max : s.dt_max) << "in touch";
        EXPECT_LT(run.unexplained_energy(), 1e-10 * s.initial_energy);
        EXPECT_LT(momentum_error(s), 1e-12);
    }
}

TEST(Penalty, StiffSpringsBlowUpAtTheStepOfTheElements) {
    Solver solver(pressing(springs("penalty", 10, "step = \"elements\"\n")));
    while (!solver.finished())
        if (const auto divergence = solver.step()) {
            EXPECT_NE(divergence->message.find("energy grew"), std::string::npos) << divergence->message;
            return;
        }
    EXPECT_GT(solver.statistics().maximum_growth, 0.1);
}

TEST(Penalty, AFixedStepThatItsSpringsCannotTakeIsStopped) {
    Solver probe(pressing(springs("penalty", 10)));
    const auto fixed = fmt::format("fixed = {:.17g}", 0.9 * probe.critical_step());
    try {
        Solver touching(pressing(springs("penalty", 10), fixed));
        FAIL() << "it was taken";
    } catch (const SceneError& error) {
        EXPECT_NE(
            std::string(error.what()).find("is above the critical step with the springs of contact; at most"),
            std::string::npos)
            << error.what();
    }
    // Apart, nothing is known of the springs yet.
    constexpr double gap = 0.05;
    Solver solver(pressing(springs("penalty", 10), fixed, gap));
    while (!solver.finished())
        if (const auto divergence = solver.step()) {
            EXPECT_NE(divergence->message.find("with the springs of contact, below the fixed step"),
                      std::string::npos)
                << divergence->message;
            EXPECT_LT(solver.time(), gap / 10) << "before it gets there";
            return;
        }
    FAIL() << "it went through";
}

// Nodes that come and go take inertia up at one speed and give it back at another: see bipenalty_contact.hpp.
TEST(Bipenalty, TakesTheStepOfTheElementsAndAddsLittleEnergyWithSoftSprings) {
    for (const auto& [factor, growth] : {std::pair{0.1, 5e-3}, {1.0, 0.2}}) {
        RecordedRun run(pressing(springs("bipenalty", factor)));
        run.to_end();
        const RunStatistics s = run.solver.statistics();
        EXPECT_LT(s.maximum_growth, growth) << factor;
        EXPECT_GT(s.dt_min, 0.97 * 0.98 * s.critical_step_initial) << "the elements' own change only";
        EXPECT_LT(run.unexplained_energy(), 1e-10 * s.initial_energy);
        EXPECT_LT(momentum_error(s), 1e-12);
        EXPECT_EQ(s.contact_solver.fallbacks, 0);
    }
}

// A row in touch: C = k depth + m_p d2(depth)/dt2 with the acceleration that came of all forces.
TEST(Bipenalty, ForceIsThatOfSpringAndInertia) {
    constexpr double factor = 0.3;
    RecordedRun run(thrown(springs("bipenalty", factor), "fixed = 1e-4"));
    run.to_end();
    const auto force = run.column("contact.hit.y"), depth = run.column("contact.hit.penetration");
    const double dt = 1e-4, stiffness = factor * young / 3, inertia = stiffness * dt * dt / 4;
    int checked = 0;
    for (std::size_t n = 1; n + 1 < force.size(); ++n) {
        if (force[n - 1] <= 0 || force[n] <= 0 || force[n + 1] <= 0) continue;
        const double acceleration = (depth[n + 1] - 2 * depth[n] + depth[n - 1]) / (dt * dt);
        ASSERT_NEAR(force[n], 2 * (stiffness * depth[n] + inertia * acceleration), 1e-8 * force[n]) << n;
        ++checked;
    }
    EXPECT_GT(checked, 5);
}

}  // namespace
}  // namespace percuss::testing
