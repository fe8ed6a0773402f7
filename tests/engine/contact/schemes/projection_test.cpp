#include "contact/schemes/projection.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "engine/contact/chain.hpp"

namespace percuss {
namespace {

using testing::append_chain;
using testing::append_points;

/// Predicts from the nodes' velocities, then lets a projection correct.
struct Corrected {
    std::vector<Node> nodes;
    std::vector<double> inverse_mass;  // 2 per node
    double dt = 0.1, kick = 0.1;
    std::vector<double> impulse = std::vector<double>(inverse_mass.size(), 0.0);
    std::vector<std::int32_t> touched = {};

    void step(PairScheme& scheme) {
        for (Node& node : nodes)
            for (int d = 0; d < 2; ++d) node.x[d] += dt * node.v[d];
        std::fill(impulse.begin(), impulse.end(), 0.0);
        touched.clear();
        PredictedMotion motion{dt, kick, nodes.data(), inverse_mass.data(), impulse.data(), &touched};
        scheme.find(motion);
        scheme.resolve(motion);
    }
    [[nodiscard]] double momentum(std::size_t d) const {
        double sum = 0;
        for (std::size_t n = 0; n < nodes.size(); ++n) sum += nodes[n].v[d] / inverse_mass[2 * n + d];
        return sum;
    }
};

std::vector<double> both_directions(const std::vector<double>& inverse_masses) {
    std::vector<double> both;
    for (const double m : inverse_masses) both.insert(both.end(), {m, m});
    return both;
}

Projection projection(const Surface& master, const Surface& slave, ContactSign sign, std::size_t nodes) {
    return {PenetrationSearch(master, slave), sign, static_cast<std::int32_t>(nodes)};
}

// One master node k of mass 2 in a side i-j of masses 3 and 5, a quarter of the way, the side at 30 degrees.
// By hand: dt^2 (1/2 + (3/4)^2 / 3 + (1/4)^2 / 5) C = P.
TEST(Projection, SolvesEquationSixByHand) {
    const double phi = 3.14159265358979 / 6, dt = 0.1, depth = 0.02;
    const double tangent[2] = {std::cos(phi), std::sin(phi)}, normal[2] = {std::sin(phi), -std::cos(phi)};
    std::vector<Node> nodes;
    const Surface slave = append_chain(nodes, {{0, 0}, {2 * tangent[0], 2 * tangent[1]}}, false);
    const Surface master = append_points(nodes, {{0.5 * tangent[0], 0.5 * tangent[1]}});
    Node& k = nodes[2];
    for (int d = 0; d < 2; ++d) {
        k.x[d] += 0.01 * normal[d];
        k.v[d] = -(depth + 0.01) / dt * normal[d];
    }
    Corrected bodies{nodes, both_directions({1.0 / 3, 1.0 / 5, 1.0 / 2})};
    const double before[2] = {bodies.momentum(0), bodies.momentum(1)};
    Projection scheme = projection(master, slave, ContactSign::restricted, 3);
    bodies.step(scheme);

    const double force = depth / (dt * dt * (0.5 + 0.5625 / 3 + 0.0625 / 5));
    ASSERT_EQ(scheme.rows().size(), 1U);
    EXPECT_NEAR(scheme.rows()[0].force, force, 1e-12 * force);
    const double share[3] = {-0.75, -0.25, 1};  // nodes i, j, k
    for (std::size_t n = 0; n < 3; ++n)
        for (std::size_t d = 0; d < 2; ++d)
            EXPECT_NEAR(bodies.impulse[2 * n + d], dt * share[n] * force * normal[d], 1e-14);
    const SideView after =
        view_from_side(bodies.nodes.data(), slave.sides[0], bodies.nodes[2].x[0], bodies.nodes[2].x[1]);
    EXPECT_NEAR(after.gap, 0, 1e-4 * depth) << "zero but for the small rotation of the side";
    EXPECT_NEAR(after.gap, -scheme.penetration_left(bodies.nodes.data()), 1e-15);
    for (std::size_t d = 0; d < 2; ++d) EXPECT_NEAR(bodies.momentum(d), before[d], 1e-15);
}

/// A straight chain of five slave nodes, master nodes over the middles of its four sides at the given depths.
class MidSides : public ::testing::Test {
  protected:
    Corrected bodies(const std::vector<double>& depths) {
        std::vector<Node> nodes;
        slave_ = append_chain(nodes, {{4, 0}, {3, 0}, {2, 0}, {1, 0}, {0, 0}}, false);
        master_ = append_points(nodes, {{3.5, 0.01}, {2.5, 0.01}, {1.5, 0.01}, {0.5, 0.01}});
        for (std::size_t k = 0; k < 4; ++k) nodes[5 + k].v[1] = -(0.01 + depths[k]) / 0.1;
        return {nodes, both_directions({1, 1, 1, 1, 1, 0.1, 0.1, 0.1, 0.1})};
    }
    [[nodiscard]] double gap(const Corrected& bodies, std::size_t k) const {
        const auto n = static_cast<std::size_t>(master_.nodes[k]);
        return view_from_side(bodies.nodes.data(), slave_.sides[k], bodies.nodes[n].x[0],
                              bodies.nodes[n].x[1])
            .gap;
    }
    Surface slave_, master_;
};

// Heavy master nodes: the deep one drives its side so far that its neighbours would have to pull.
TEST_F(MidSides, NegativeForcesAreLeftOutUnlessAskedFor) {
    const std::vector<double> depths{1e-6, 1e-3, 1e-6, -1e-6};
    Corrected free = bodies(depths), held = bodies(depths);
    Projection restricted = projection(master_, slave_, ContactSign::restricted, 9);
    Projection unrestricted = projection(master_, slave_, ContactSign::unrestricted, 9);
    free.step(restricted);
    held.step(unrestricted);
    ASSERT_EQ(restricted.rows().size(), 3U);
    EXPECT_EQ(restricted.negative_forces(), 2);
    EXPECT_EQ(unrestricted.negative_forces(), 2);

    EXPECT_LT(unrestricted.rows()[0].force, 0);
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(gap(held, k), 0, 1e-9) << "glued";

    EXPECT_EQ(restricted.rows()[0].force, 0);
    EXPECT_NEAR(restricted.rows()[1].force, 1e-3 / (0.01 * (0.1 + 0.5)), 1e-12);
    EXPECT_EQ(restricted.rows()[2].force, 0);
    EXPECT_GT(gap(free, 0), 1e-5) << "open";
    EXPECT_NEAR(gap(free, 1), 0, 1e-9);
    EXPECT_GT(gap(free, 2), 1e-5);
}

TEST_F(MidSides, PositiveForcesAreTheSameEitherWay) {
    const std::vector<double> depths{1e-3, 1e-3, 1e-3, 1e-3};
    Corrected one = bodies(depths), other = bodies(depths);
    Projection restricted = projection(master_, slave_, ContactSign::restricted, 9);
    Projection unrestricted = projection(master_, slave_, ContactSign::unrestricted, 9);
    one.step(restricted);
    other.step(unrestricted);
    EXPECT_EQ(restricted.negative_forces() + unrestricted.negative_forces(), 0);
    for (std::size_t n = 0; n < one.nodes.size(); ++n) EXPECT_EQ(one.nodes[n].x[1], other.nodes[n].x[1]);
}

TEST_F(MidSides, HeldNodesDoNotMoveAndOthersTakeAll) {
    Corrected b = bodies({1e-3, 1e-3, -1, -1});
    for (const std::size_t held : {std::size_t{5}, std::size_t{6}})
        b.inverse_mass[2 * held] = b.inverse_mass[2 * held + 1] = 0;
    b.nodes[5].v[1] = b.nodes[6].v[1] = -0.11;
    Projection scheme = projection(master_, slave_, ContactSign::restricted, 9);
    b.step(scheme);
    ASSERT_EQ(scheme.rows().size(), 2U);
    EXPECT_EQ(b.nodes[5].v[1], -0.11);
    EXPECT_LT(scheme.penetration_left(b.nodes.data()), 1e-9);
}

// Held against held: no force can help, none may be invented, and what is left is reported.
TEST_F(MidSides, NoForceBetweenHeldNodes) {
    Corrected b = bodies({1e-3, -1, -1, -1});
    b.inverse_mass.assign(18, 0.0);
    Projection scheme = projection(master_, slave_, ContactSign::restricted, 9);
    b.step(scheme);
    ASSERT_EQ(scheme.rows().size(), 1U);
    EXPECT_EQ(scheme.rows()[0].force, 0);
    EXPECT_NEAR(scheme.penetration_left(b.nodes.data()), 1e-3, 1e-12);
}

// A rigid wall of many master nodes on one side: more rows than the side can move, but they agree.
TEST_F(MidSides, AHeldWallFinerThanTheSlaveSurface) {
    std::vector<Node> nodes;
    const Surface slave = append_chain(nodes, {{1, 0}, {0, 0}}, false);
    std::vector<std::array<double, 2>> wall;
    for (int k = 0; k < 7; ++k) wall.push_back({0.1 + 0.13 * k, 0.01});
    const Surface master = append_points(nodes, wall);
    for (std::size_t n = 2; n < nodes.size(); ++n) nodes[n].v[1] = -0.11;
    Corrected b{nodes, both_directions({1, 1, 0, 0, 0, 0, 0, 0, 0})};
    Projection scheme = projection(master, slave, ContactSign::restricted, nodes.size());
    b.step(scheme);
    EXPECT_EQ(scheme.rows().size(), 7U);
    EXPECT_LT(scheme.penetration_left(b.nodes.data()), 1e-9 * 1e-3);
    for (const ContactRow& row : scheme.rows()) EXPECT_GE(row.force, 0);
}

}  // namespace
}  // namespace percuss
