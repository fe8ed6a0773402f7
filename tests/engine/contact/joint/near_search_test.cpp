#include "contact/joint/near_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "engine/contact/chain.hpp"
#include "engine/contact/node_row.hpp"
#include "engine/contact/solvers/random_system.hpp"

namespace percuss {
namespace {

using testing::append_chain;
using testing::append_points;
using testing::node_rows;
using testing::NodeRow;
using testing::Rng;

/// A floor from x = 0 to 10 in ten sides at height 0, its body below, and master nodes above it.
struct Floor {
    std::vector<Node> nodes;
    Surface slave;

    Floor() {
        std::vector<std::array<double, 2>> points;
        for (int k = 10; k >= 0; --k) points.push_back({static_cast<double>(k), 0.0});
        slave = append_chain(nodes, points, false);
    }
    /// The rows of one master node at (x, y) before the step, moving by (dx, dy) within it.
    std::vector<NodeRow> rows_of(std::array<double, 2> start, std::array<double, 2> motion,
                                 double recovery = 1) {
        std::vector<Node> all = nodes;
        const Surface master = append_points(all, {start});
        all.back() = {{start[0] + motion[0], start[1] + motion[1]}, {motion[0], motion[1]}};
        ContactRows rows;
        NearSearch(master, slave).find({all.data(), 1, std::hypot(motion[0], motion[1]), recovery}, rows);
        return node_rows(rows.all());
    }
};

TEST(NearSearch, MeasuresTheGapAtTheStartOfTheStep) {
    Floor floor;
    const auto rows = floor.rows_of({3.3, 0.01}, {0.02, -0.03});
    ASSERT_EQ(rows.size(), 1U);
    EXPECT_NEAR(rows[0].normal[1], 1, 1e-15);
    EXPECT_NEAR(rows[0].penetration, 0.02, 1e-15) << "predicted 0.02 below the floor";
    EXPECT_NEAR(std::abs(rows[0].share[1]) * 4 + std::abs(rows[0].share[2]) * 3, 3.3, 1e-12)
        << "the foot is where the node was, not where it would go";
}

TEST(NearSearch, LeavesOutWhatCannotTouchWithinTheStep) {
    Floor floor;
    EXPECT_EQ(floor.rows_of({3.3, 0.1}, {0.02, -0.03}).size(), 0U);
    EXPECT_EQ(floor.rows_of({3.3, 0.05}, {0.0, 0.03}).size(), 1U) << "may be pushed back";
    EXPECT_EQ(floor.rows_of({10.1, 0.001}, {0.0, -0.03}).size(), 0U) << "beyond the open end";
    EXPECT_EQ(floor.rows_of({10.01, 0.001}, {0.0, -0.03}).size(), 1U) << "flush, spread by 1 % of a side";
    EXPECT_EQ(floor.rows_of({3.3, -0.3}, {0.0, -0.03}).size(), 0U) << "did not come through the surface";
}

TEST(NearSearch, TakesAPenetrationBackNoFasterThanItMay) {
    Floor floor;
    const auto rows = floor.rows_of({3.3, -0.02}, {0, -0.03}, 0.004);
    ASSERT_EQ(rows.size(), 1U);
    EXPECT_NEAR(rows[0].penetration, 0.03 + 0.004, 1e-15);
}

// The bottom of a valley: forced out by the closer side only, the node would go through the other.
TEST(NearSearch, ValleyHoldsANodeByBothItsSides) {
    std::vector<Node> nodes;
    const Surface slave = append_chain(nodes, {{2, 1}, {0, 0}, {-2, 1}}, false);
    const Surface master = append_points(nodes, {{0.001, 0.002}});
    nodes.back() = {{0.001, -0.018}, {0, -0.02}};
    NearSearch search(master, slave);
    ContactRows found;
    search.find({nodes.data(), 1, 0.02, 1}, found);
    const auto rows = node_rows(found.all());
    ASSERT_EQ(rows.size(), 2U);
    EXPECT_LT(rows[0].normal[0] * rows[1].normal[0], 0);
    EXPECT_GT(rows[0].penetration, 0);
    EXPECT_GT(rows[1].penetration, 0);
}

TEST(NearSearch, RidgeHoldsANodeByOneSide) {
    std::vector<Node> nodes;
    const Surface slave = append_chain(nodes, {{2, -0.2}, {0, 0}, {-2, -0.2}}, false);
    const Surface master = append_points(nodes, {{0.0005, 0.002}});
    nodes.back() = {{0.0005, -0.018}, {0, -0.02}};
    NearSearch search(master, slave);
    ContactRows rows;
    search.find({nodes.data(), 1, 0.02, 1}, rows);
    EXPECT_EQ(rows.size(), 1U);
}

// A node passing the edge of a block above its top face: outside of both faces it belongs to the one that it
// is more outside of.
TEST(NearSearch, SharpCornerIsEnteredThroughTheFaceThatTheNodeIsInFrontOf) {
    std::vector<Node> nodes;
    const Surface slave = append_chain(nodes, {{0, 0}, {1, 0}, {1, 1}, {0, 1}}, true);
    const auto normal_of = [&](std::array<double, 2> start) -> std::array<double, 2> {
        std::vector<Node> all = nodes;
        const Surface master = append_points(all, {start});
        all.back() = {{start[0] - 0.01, start[1] - 0.01}, {-0.01, -0.01}};
        NearSearch search(master, slave);
        ContactRows rows;
        search.find({all.data(), 1, 0.0142, 1}, rows);
        if (rows.size() != 1) return {0, 0};
        return node_rows(rows.all())[0].normal;
    };
    EXPECT_EQ(normal_of({1.001, 1.006}), (std::array<double, 2>{0, 1}));
    EXPECT_EQ(normal_of({1.006, 1.001}), (std::array<double, 2>{1, 0}));
    EXPECT_EQ(normal_of({0.999, 1.001}), (std::array<double, 2>{0, 1}));
}

// A node that begins inside touches where it is, until it has been clear of the surface.
TEST(NearSearch, OverlapAtTheStartIsAllowedUntilTheNodeIsClear) {
    Floor floor;
    std::vector<Node> nodes = floor.nodes;
    const Surface master = append_points(nodes, {{3.3, -0.1}});
    NearRole role;
    role.overlapping = {0};
    NearSearch search(master, floor.slave, role);
    const auto penetration_at = [&](double start, double motion) {
        nodes.back() = {{3.3, start + motion}, {0, motion}};
        ContactRows rows;
        search.find({nodes.data(), 1, 0.05, 1}, rows);
        search.advance(0.05, 0);
        return rows.empty() ? -1 : rows[0].penetration;
    };
    EXPECT_NEAR(penetration_at(-0.1, 0), 0, 1e-15) << "no kick";
    EXPECT_NEAR(penetration_at(-0.1, -0.03), 0.03, 1e-15) << "no deeper";
    EXPECT_NEAR(penetration_at(-0.13, 0), 0.03, 1e-15) << "deeper than it began";
    EXPECT_NEAR(penetration_at(-0.06, 0), -0.04, 1e-15) << "the gap does not close up behind it";
    EXPECT_NEAR(penetration_at(-0.09, 0), -0.01, 1e-15);
    penetration_at(0.09, 0);  // a step could still bring it back
    EXPECT_NEAR(penetration_at(-0.09, 0), -0.01, 1e-15);
    EXPECT_EQ(penetration_at(0.11, 0), -1) << "has left";
    EXPECT_NEAR(penetration_at(-0.02, 0), 0.02, 1e-15);
}

// Flush blocks: the corner node of the upper stands on the lower, though it hangs over by a hair.
TEST(NearSearch, CornersOfFlushBodiesStandOnEachOther) {
    std::vector<Node> nodes;
    const Surface lower = append_chain(nodes, {{0, 0}, {1, 0}, {1, 1}, {0, 1}}, true);
    for (const double hair : {-1e-6, 0.0, 1e-6}) {
        for (const double depth : {-1e-6, 0.0, 1e-5}) {
            std::vector<Node> all = nodes;
            const Surface upper =
                append_chain(all, {{hair, 1 - depth}, {1 + hair, 1 - depth}, {1 + hair, 2}, {hair, 2}}, true);
            NearRole role;
            role.by_facing = true;
            NearSearch search(upper, lower, role);
            ContactRows rows;
            search.find({all.data(), 1, 1e-3, 1}, rows);
            ASSERT_EQ(rows.size(), 2U) << hair << ", " << depth;
            for (const NodeRow& row : node_rows(rows.all())) {
                EXPECT_NEAR(row.normal[1], 1, 1e-15);
                EXPECT_NEAR(row.penetration, depth, 1e-12);
            }
        }
    }
}

/// Least distance of a point from the sides at the start of the step.
double brute_force(const std::vector<Node>& nodes, const Surface& slave, const Node& point, double dt) {
    double least = std::numeric_limits<double>::infinity();
    for (const Side& side : slave.sides) {
        const auto start = [&](std::int32_t n) {
            const Node& node = nodes[static_cast<std::size_t>(n)];
            return std::array<double, 2>{node.x[0] - dt * node.v[0], node.x[1] - dt * node.v[1]};
        };
        const auto a = start(side.i), b = start(side.j);
        least = std::min(least, testing::distance_to_segment(a.data(), b.data(), point.x[0] - dt * point.v[0],
                                                             point.x[1] - dt * point.v[1]));
    }
    return least;
}

// Sleeping nodes must wake in time: a wheel of twelve sides rolls through a cloud of points, and in every
// step all points within reach have their row, at their true distance.
TEST(NearSearch, MissesNoNodeWhileSurfacesMove) {
    Rng random(21);
    std::vector<Node> nodes;
    std::vector<std::array<double, 2>> wheel, cloud;
    for (int k = 0; k < 12; ++k)
        wheel.push_back({std::cos(0.5235987755982988 * k), std::sin(0.5235987755982988 * k)});
    const Surface slave = append_chain(nodes, wheel, true);
    for (int k = 0; k < 150; ++k) cloud.push_back({random.uniform(-4, 4), random.uniform(1.0001, 2)});
    const Surface master = append_points(nodes, cloud);
    NearSearch search(master, slave);
    ContactRows rows;
    const double dt = 0.5;
    int seen = 0;
    for (int step = 0; step < 1500; ++step) {
        const double vx = 0.01 * std::cos(0.005 * step), vy = 0.0006, spin = 0.004;
        std::array<double, 2> centre{0, 0};
        for (const std::int32_t n : slave.nodes)
            for (std::size_t d = 0; d < 2; ++d) centre[d] += nodes[static_cast<std::size_t>(n)].x[d] / 12;
        double fastest = 0;
        for (const std::int32_t n : slave.nodes) {
            Node& node = nodes[static_cast<std::size_t>(n)];
            node.v[0] = vx - spin * (node.x[1] - centre[1]);
            node.v[1] = vy + spin * (node.x[0] - centre[0]);
            for (int d = 0; d < 2; ++d) node.x[d] += dt * node.v[d];
            fastest = std::max(fastest, std::hypot(node.v[0], node.v[1]));
        }
        rows.clear();
        search.find({nodes.data(), dt, dt * fastest, 1}, rows);
        for (std::size_t m = 0; m < master.nodes.size(); ++m) {
            const double distance =
                brute_force(nodes, slave, nodes[static_cast<std::size_t>(master.nodes[m])], dt);
            const auto row = std::find_if(rows.begin(), rows.end(), [&](const ContactRow& r) {
                return r.owner == static_cast<std::int32_t>(m);
            });
            if (distance < dt * fastest && row == rows.end()) {
                // Only a node that is deep inside already may be without a row: nothing holds it here.
                const Node& node = nodes[static_cast<std::size_t>(master.nodes[m])];
                ASSERT_LT(std::hypot(node.x[0] - centre[0], node.x[1] - centre[1]), 1) << step << ", " << m;
            }
            seen += row != rows.end();
        }
        search.advance(dt * fastest, dt * fastest);
    }
    EXPECT_GT(seen, 200);
}

}  // namespace
}  // namespace percuss
