#include "contact/joint/frictional_contact.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "engine/allocations.hpp"
#include "engine/contact/joint/random_step.hpp"

namespace percuss {
namespace {

using testing::Rng;
using testing::stack;
using RandomStep = testing::RandomStep<FrictionalContact<JointContact>>;

Scene rough_stack(double friction, const std::vector<std::string>& overrides = {}) {
    std::vector<std::string> all = overrides;
    for (const char* pair : {"low", "high", "side-a", "side-b", "side-c"})
        all.push_back(fmt::format("contact.{}.friction={}", pair, friction));
    return stack({0, 1, 2, 3, 4}, all);
}

// At the start of the step all faces touch: every row's condition can be read off the corrected motion. Nodes
// at the seams belong to three pairs, and the tangent of one is the normal of another.
TEST(FrictionalContact, NodesStickWithinTheLimitAndSlideAgainstTheForceAtIt) {
    Rng random(41);
    int stick = 0, slide = 0;
    for (int round = 0; round < 20; ++round) {
        RandomStep step(rough_stack(0.3), random);
        step.resolve();
        ASSERT_EQ(step.statistics.contact_solver.unsettled, 0);
        double fastest = 0;
        for (const Node& node : step.predicted) fastest = std::max(fastest, std::hypot(node.v[0], node.v[1]));
        // Contact forces have settled to 1e-6 of the deepest penetration, and so has what limits the
        // friction.
        const double resting = 1e-7 * fastest, gap = 1e-5 * fastest;
        for (std::size_t pair = 0; pair < 5; ++pair) {
            const auto rows = step.contact.rows(pair), tangents = step.contact.friction_rows(pair);
            int sticking = 0;
            for (const ContactRow& row : rows) {
                ASSERT_GE(row.force, 0);
                EXPECT_GT(step.gap_rate(rows.terms(row)), -gap);
                if (row.force > 0) {
                    EXPECT_LT(step.gap_rate(rows.terms(row)), gap);
                }
            }
            for (const ContactRow& tangent : tangents) {
                const auto row = std::find_if(rows.begin(), rows.end(), [&](const ContactRow& r) {
                    return r.owner == tangent.owner && r.side == tangent.side;
                });
                ASSERT_NE(row, rows.end());
                const auto along_normal = rows.terms(*row), along_face = tangents.terms(tangent);
                for (std::size_t k = 0; k < along_face.size(); ++k) {
                    EXPECT_EQ(along_normal[k].node, along_face[k].node);
                    EXPECT_EQ(
                        along_normal[k].g[0] * along_face[k].g[0] + along_normal[k].g[1] * along_face[k].g[1],
                        0);
                }
                const double limit = 0.3 * row->force, slip = step.gap_rate(along_face);
                ASSERT_LE(std::abs(tangent.force), limit * (1 + 1e-12));
                if (std::abs(tangent.force) < limit * (1 - 1e-9)) {
                    EXPECT_LT(std::abs(slip), resting);
                    ++stick;
                } else if (limit > 0) {
                    EXPECT_LT(tangent.force * slip, 1e-9 * limit * fastest) << "friction never drives";
                    ++slide;
                }
                sticking += limit > 0 && std::abs(tangent.force) < limit;
            }
            EXPECT_EQ(step.contact.sticking(pair), sticking);
        }
    }
    EXPECT_GT(stick, 30);
    EXPECT_GT(slide, 50);
}

TEST(FrictionalContact, ActionIsReactionAndEnergyFalls) {
    Rng random(42);
    for (const double friction : {0.1, 0.3, 1.0}) {
        for (int round = 0; round < 10; ++round) {
            RandomStep step(rough_stack(friction), random);
            step.resolve();
            double sum[2] = {0, 0}, moment = 0, gross = 0, before = 0, after = 0;
            for (std::size_t n = 0; n < step.nodes.size(); ++n) {
                for (std::size_t d = 0; d < 2; ++d) {
                    const double mass = 1 / step.inverse_mass[2 * n];
                    const auto &old = step.predicted[n].v, &now = step.nodes[n].v;
                    sum[d] += step.impulse[2 * n + d];
                    gross += std::abs(step.impulse[2 * n + d]);
                    before += 0.5 * mass * old[d] * old[d];
                    after += 0.5 * mass * now[d] * now[d];
                }
                moment +=
                    (step.predicted[n].x[0] - step.dt * step.predicted[n].v[0]) * step.impulse[2 * n + 1] -
                    (step.predicted[n].x[1] - step.dt * step.predicted[n].v[1]) * step.impulse[2 * n];
            }
            EXPECT_NEAR(sum[0], 0, 1e-14 * gross);
            EXPECT_NEAR(sum[1], 0, 1e-14 * gross);
            EXPECT_NEAR(moment, 0, 1e-13 * gross) << "forces act where the master node touches";
            EXPECT_LT(after, before);
        }
    }
}

TEST(FrictionalContact, OnlyPairsThatCallForItHaveFriction) {
    Rng random(43), same(43);
    RandomStep step(stack({0, 1, 2, 3, 4}, {"contact.high.friction=0.3"}), random);
    testing::RandomStep<JointContact> free(stack(), same);
    step.resolve();
    free.resolve();
    for (const std::size_t pair : {0U, 2U, 3U, 4U}) EXPECT_TRUE(step.contact.friction_rows(pair).empty());
    EXPECT_FALSE(step.contact.friction_rows(1).empty());
    double difference = 0;
    for (std::size_t n = 0; n < step.nodes.size(); ++n)
        difference = std::max(difference, std::abs(step.nodes[n].v[0] - free.nodes[n].v[0]));
    EXPECT_GT(difference, 1e-3);
}

TEST(FrictionalContact, IsChosenOnlyWhereAPairCallsForIt) {
    const auto kind = [](const Scene& scene) {
        const auto method = make_contact_method(scene, build_mesh(scene), scene.contact_solver.scheme);
        return dynamic_cast<FrictionalContact<JointContact>*>(method.get()) != nullptr;
    };
    EXPECT_TRUE(kind(rough_stack(0.2)));
    EXPECT_FALSE(kind(rough_stack(0)));
    EXPECT_FALSE(kind(stack()));
}

// Positions were changed from outside: rows of the last step would be of other positions.
TEST(FrictionalContact, ForgetsItsRowsAtARestart) {
    Rng random(44);
    RandomStep step(rough_stack(0.3), random);
    step.resolve();
    ASSERT_FALSE(step.contact.rows(0).empty());
    ASSERT_FALSE(step.contact.friction_rows(0).empty());
    step.contact.restart(std::vector<std::vector<std::int32_t>>(5));
    for (std::size_t pair = 0; pair < 5; ++pair) {
        EXPECT_TRUE(step.contact.rows(pair).empty());
        EXPECT_TRUE(step.contact.friction_rows(pair).empty());
        EXPECT_EQ(step.contact.sticking(pair), 0);
    }
}

TEST(FrictionalContact, StepsWithoutAllocation) {
    Solver solver(rough_stack(0.3, {"body.c.velocity=[3, -20]", "body.d.velocity=[-10, 0]"}));
    for (int k = 0; k < 5; ++k) ASSERT_FALSE(solver.step());
    const std::size_t before = testing::allocations();
    for (int k = 0; k < 300; ++k) static_cast<void>(solver.step());
    EXPECT_EQ(testing::allocations() - before, 0U);
    EXPECT_GT(solver.statistics().contact_solver.friction_solutions, 10);
}

}  // namespace
}  // namespace percuss
