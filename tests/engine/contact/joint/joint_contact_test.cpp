#include "contact/joint/joint_contact.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "engine/allocations.hpp"
#include "engine/contact/joint/random_step.hpp"

namespace percuss {
namespace {

using testing::Rng;

using testing::stack;
using RandomStep = testing::RandomStep<JointContact>;

// At the start of the step all faces touch: every row's condition can be read off the corrected motion.
TEST(JointContact, ForcesPushOnlyWhereGapsCloseAndNoGapOpensInwards) {
    Rng random(31);
    int with_force = 0, without = 0;
    for (int round = 0; round < 20; ++round) {
        RandomStep step(stack(), random);
        step.resolve();
        double deepest = 0, total = 0;
        for (std::size_t pair = 0; pair < 5; ++pair)
            for (const ContactRow& row : step.contact.rows(pair))
                deepest = std::max(deepest, row.penetration);
        for (std::size_t pair = 0; pair < 5; ++pair) {
            for (const ContactRow& row : step.contact.rows(pair)) {
                const double closing = -step.gap_rate(step.contact.rows(pair).terms(row));
                ASSERT_GE(row.force, 0);
                EXPECT_LT(step.dt * closing, 2e-8 * deepest) << "within the regularisation";
                if (row.force > 0) {
                    EXPECT_GT(step.dt * closing, -1e-9 * deepest) << "no force across an opening gap";
                }
                with_force += row.force > 0;
                without += row.force == 0;
                total += row.force;
            }
        }
        ASSERT_GT(total, 0);
    }
    EXPECT_GT(with_force, 200);
    EXPECT_GT(without, 50);
}

TEST(JointContact, ActionIsReaction) {
    Rng random(32);
    RandomStep step(stack(), random);
    step.resolve();
    double sum[2] = {0, 0}, moment = 0, gross = 0;
    for (std::size_t n = 0; n < step.nodes.size(); ++n) {
        for (int d = 0; d < 2; ++d) {
            sum[d] += step.impulse[2 * n + static_cast<std::size_t>(d)];
            gross += std::abs(step.impulse[2 * n + static_cast<std::size_t>(d)]);
            const double change =
                step.inverse_mass[2 * n] * step.impulse[2 * n + static_cast<std::size_t>(d)];
            EXPECT_NEAR(step.nodes[n].v[d], step.predicted[n].v[d] + change, 1e-15);
            EXPECT_NEAR(step.nodes[n].x[d], step.predicted[n].x[d] + step.dt * change, 1e-15);
        }
        // Forces act at the positions where the gaps were measured: their moment vanishes there.
        moment += (step.predicted[n].x[0] - step.dt * step.predicted[n].v[0]) * step.impulse[2 * n + 1] -
                  (step.predicted[n].x[1] - step.dt * step.predicted[n].v[1]) * step.impulse[2 * n];
    }
    EXPECT_GT(gross, 0.01);
    EXPECT_NEAR(sum[0], 0, 1e-14 * gross);
    EXPECT_NEAR(sum[1], 0, 1e-14 * gross);
    EXPECT_NEAR(moment, 0, 1e-13 * gross);
}

TEST(JointContact, KineticEnergyOfAStepNeverRises) {
    Rng random(33);
    for (int round = 0; round < 20; ++round) {
        RandomStep step(stack(), random);
        step.resolve();
        double before = 0, after = 0;
        for (std::size_t n = 0; n < step.nodes.size(); ++n)
            for (int d = 0; d < 2; ++d) {
                const double m = 1 / step.inverse_mass[2 * n];
                before += 0.5 * m * step.predicted[n].v[d] * step.predicted[n].v[d];
                after += 0.5 * m * step.nodes[n].v[d] * step.nodes[n].v[d];
            }
        EXPECT_LT(after, before);
    }
}

TEST(JointContact, OrderOfPairsDoesNotMatter) {
    for (const auto& order : {std::vector<int>{4, 3, 2, 1, 0}, std::vector<int>{2, 0, 4, 1, 3}}) {
        Rng random(34), same(34);
        RandomStep one(stack(), random), other(stack(order), same);
        one.resolve();
        other.resolve();
        for (std::size_t n = 0; n < one.nodes.size(); ++n)
            for (int d = 0; d < 2; ++d) EXPECT_NEAR(one.nodes[n].v[d], other.nodes[n].v[d], 1e-12);
    }
}

// A wedge rises and pushes a block aside into one that nothing moved yet: no prediction closes that gap, the
// wedge's force does.
TEST(JointContact, ForcesOfOnePairCallForThoseOfAnother) {
    using namespace testing;
    const auto block = [](const std::string& name, const std::string& corners) {
        return "[[body]]\nname = \"" + name +
               "\"\nmaterial = \"steel\"\n[[body.block]]\ncorners = " + corners + "\ndivisions = [4, 3]\n";
    };
    const Scene scene = scene_of(
        scene_head("plane strain", 1, 0.3) + block("wedge", "[[0, 0], [4, 0], [4, 1], [0, 3]]") +
        block("block", "[[0, 3], [4, 1], [4, 4], [0, 4]]") +
        block("wall", "[[4, 0], [5, 0], [5, 4], [4, 4]]") + "[contact_solver]\nscheme = \"joint\"\n" +
        contact_pair("below", "block.bottom", "wedge.top") +
        contact_pair("beside", "block.right", "wall.left"));
    Rng random(36);
    RandomStep step(scene, random);
    for (std::size_t n = 0; n < step.nodes.size(); ++n) {
        const bool wedge = static_cast<std::int32_t>(n) < step.mesh.bodies[0].node_end;
        const Vec2& x = step.mesh.nodes[n];
        step.nodes[n] = {{x.x(), x.y() + (wedge ? step.dt : 0)}, {0, wedge ? 1.0 : 0.0}};
    }
    step.resolve();
    double push = 0;
    for (const ContactRow& row : step.contact.rows(1)) {
        push += row.force;
        EXPECT_GT(step.gap_rate(step.contact.rows(1).terms(row)), -1e-7);
    }
    EXPECT_GT(push, 0);
}

// The last step's active set is only where the search for this one's begins.
TEST(JointContact, AnswerDoesNotDependOnWhereTheSolverStarts) {
    Rng random(35), same(35);
    RandomStep cold(stack(), random), warm(stack(), same);
    std::vector<std::vector<std::int32_t>> everything;
    for (const std::size_t count : {8U, 6U, 3U, 3U, 3U}) {
        everything.emplace_back(count);
        for (std::size_t k = 0; k < count; ++k) everything.back()[k] = static_cast<std::int32_t>(k);
    }
    warm.contact.restart(everything);
    cold.resolve();
    warm.resolve();
    for (std::size_t n = 0; n < cold.nodes.size(); ++n)
        for (int d = 0; d < 2; ++d) EXPECT_NEAR(cold.nodes[n].v[d], warm.nodes[n].v[d], 1e-12);
    EXPECT_EQ(cold.statistics.contact_solver.fallbacks, 0);
    EXPECT_GE(cold.statistics.contact_solver.problems, 1);
}

TEST(JointContact, StepsWithoutAllocation) {
    for (const std::string scheme : {"node-to-side", "symmetric", "segment-to-segment"}) {
        std::vector<std::string> overrides{"body.c.velocity=[3, -20]", "body.d.velocity=[-10, 0]"};
        for (const char* pair : {"low", "high", "side-a", "side-b", "side-c"})
            overrides.push_back(fmt::format("contact.{}.scheme={}", pair, scheme));
        Solver solver(stack({0, 1, 2, 3, 4}, overrides));
        for (int k = 0; k < 5; ++k) ASSERT_FALSE(solver.step());
        const std::size_t before = testing::allocations();
        for (int k = 0; k < 300; ++k) static_cast<void>(solver.step());
        EXPECT_EQ(testing::allocations() - before, 0U) << scheme;
        EXPECT_GT(solver.statistics().contact_solver.most_rows, 15);
    }
}

}  // namespace
}  // namespace percuss
