#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "contact/search.hpp"
#include "engine/contact/chain.hpp"
#include "engine/contact/node_row.hpp"
#include "engine/contact/solvers/random_system.hpp"

namespace percuss {
namespace {

using testing::Rng;
using Points = std::vector<std::array<double, 2>>;

bool inside(const std::vector<Node>& nodes, const Surface& outline, const double* x) {
    bool odd = false;
    for (const Side& side : outline.sides) {
        const double *a = nodes[static_cast<std::size_t>(side.i)].x,
                     *b = nodes[static_cast<std::size_t>(side.j)].x;
        if ((a[1] > x[1]) == (b[1] > x[1])) continue;
        if (x[0] < a[0] + (b[0] - a[0]) * (x[1] - a[1]) / (b[1] - a[1])) odd = !odd;
    }
    return odd;
}

double distance(const std::vector<Node>& nodes, const Surface& outline, const double* x) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Side& side : outline.sides)
        nearest = std::min(
            nearest, testing::distance_to_segment(nodes[static_cast<std::size_t>(side.i)].x,
                                                  nodes[static_cast<std::size_t>(side.j)].x, x[0], x[1]));
    return nearest;
}

/// A wavy round outline with hollows, all corners flatter than 45 degrees.
Points wavy(Rng& random, int count) {
    Points points;
    const double waves = 2 + random.index(3), depth = random.uniform(0, 0.1);
    for (int k = 0; k < count; ++k) {
        const double angle = 2 * 3.14159265358979 * k / count, r = 1 + depth * std::cos(waves * angle);
        points.push_back({r * std::cos(angle), r * std::sin(angle)});
    }
    return points;
}

/// Two bodies in free flight with changing velocities and spins, nodes put back on the surface when found
/// inside.
class Flight {
  public:
    explicit Flight(unsigned seed) : random_(seed) {
        const int count = 24 + random_.index(40);
        slave_ = testing::append_chain(nodes_, wavy(random_, count), true);
        Points cloud;
        for (int k = 0; k < 30; ++k) {
            const double angle = random_.uniform(0, 6.28), r = random_.uniform(1.15, 1.6);
            cloud.push_back({r * std::cos(angle), r * std::sin(angle)});
        }
        master_ = testing::append_points(nodes_, cloud);
        steer();
    }

    void steer() {
        common_ = {random_.uniform(-50, 50), random_.uniform(-50, 50)};  // both together, far and fast
        relative_ = {random_.uniform(-1, 1), random_.uniform(-1, 1)};
        spin_ = {random_.uniform(-1, 1), random_.uniform(-1, 1)};
    }

    /// Predicts: every velocity is the displacement of the step over dt.
    void step() {
        const double* c = nodes_[static_cast<std::size_t>(slave_.nodes[0])].x;
        const std::array<double, 2> centre{c[0], c[1]};
        move(slave_, common_, spin_[0], centre, 0.2);
        move(master_, {common_[0] + relative_[0], common_[1] + relative_[1]}, spin_[1], centre, 1);
    }

    /// Puts the row's master node on the surface, moves the slave side a little, and nudges others: what
    /// contact does.
    void correct(const ContactRows& rows) {
        for (const testing::NodeRow& row : testing::node_rows(rows.all())) {
            Node& node = nodes_[static_cast<std::size_t>(row.node[0])];
            for (std::size_t d = 0; d < 2; ++d) {
                node.x[d] += 0.99 * row.penetration * row.normal[d];
                for (std::size_t k = 1; k < 3; ++k)
                    nodes_[static_cast<std::size_t>(row.node[k])].x[d] +=
                        0.01 * row.penetration * row.share[k] * row.normal[d];
            }
        }
    }

    static constexpr double dt = 0.01;
    std::vector<Node> nodes_;
    Surface master_, slave_;

  private:
    void move(const Surface& surface, std::array<double, 2> velocity, double spin,
              std::array<double, 2> centre, double jitter) {
        for (const std::int32_t n : surface.nodes) {
            Node& node = nodes_[static_cast<std::size_t>(n)];
            const double r[2] = {node.x[0] - centre[0], node.x[1] - centre[1]};
            node.v[0] = velocity[0] - spin * r[1] + random_.uniform(-0.05, 0.05) * jitter;
            node.v[1] = velocity[1] + spin * r[0] + random_.uniform(-0.05, 0.05) * jitter;
            for (int d = 0; d < 2; ++d) node.x[d] += dt * node.v[d];
        }
    }

    Rng random_;
    std::array<double, 2> common_{}, relative_{}, spin_{};
};

TEST(SearchMotion, FindsExactlyTheNodesInsideAtEveryStep) {
    int found = 0;
    for (unsigned seed = 0; seed < 20; ++seed) {
        Flight flight(seed);
        PenetrationSearch search(flight.master_, flight.slave_);
        ContactRows rows;
        for (int step = 0; step < 400; ++step) {
            if (step % 100 == 99) flight.steer();
            flight.step();
            search.find(flight.nodes_.data(), Flight::dt, rows);
            std::size_t expected = 0;
            for (const std::int32_t master : flight.master_.nodes) {
                const double* x = flight.nodes_[static_cast<std::size_t>(master)].x;
                const auto row = std::find_if(rows.begin(), rows.end(),
                                              [&](const auto& r) { return rows.terms(r)[0].node == master; });
                const double away = distance(flight.nodes_, flight.slave_, x);
                if (!inside(flight.nodes_, flight.slave_, x)) {
                    ASSERT_TRUE(row == rows.end() || away < 1e-12) << "seed " << seed << " step " << step;
                    continue;
                }
                ++expected;
                ASSERT_TRUE(row != rows.end() || away < 1e-12)
                    << "missed: seed " << seed << " step " << step << " " << away;
                if (row != rows.end()) {
                    ASSERT_NEAR(row->penetration, away, 1e-12);
                }
            }
            ASSERT_LE(rows.size(), expected + 1);
            found += static_cast<int>(expected);
            flight.correct(rows);
        }
    }
    EXPECT_GT(found, 5000) << "the bodies must meet for this to mean something";
}

// What is remembered saves work and never changes the answer: nothing else may be found by looking anew. (A
// search that has just forgotten takes held nodes for new ones, which is the same as long as they are not
// deep.)
TEST(SearchMotion, RemembersNothingThatMatters) {
    for (unsigned seed = 100; seed < 110; ++seed) {
        Flight flight(seed);
        PenetrationSearch search(flight.master_, flight.slave_), fresh(flight.master_, flight.slave_);
        ContactRows rows, anew;
        for (int step = 0; step < 300; ++step) {
            if (step % 100 == 99) flight.steer();
            flight.step();
            search.find(flight.nodes_.data(), Flight::dt, rows);
            fresh.forget();
            fresh.find(flight.nodes_.data(), Flight::dt, anew);
            ASSERT_EQ(rows.size(), anew.size()) << "seed " << seed << " step " << step;
            for (std::size_t k = 0; k < rows.size(); ++k) {
                EXPECT_EQ(rows[k].owner, anew[k].owner);  // at a vertex either side will do
                EXPECT_EQ(rows[k].penetration, anew[k].penetration);
            }
            flight.correct(rows);
        }
    }
}

// Nodes moved by somebody else between two searches, as another contact pair does: velocities do not tell.
TEST(SearchMotion, SeesMotionThatNoVelocityTells) {
    std::vector<Node> nodes;
    const Surface slave = testing::append_chain(nodes, {{4, 0}, {3, 0}, {2, 0}, {1, 0}, {0, 0}}, false);
    const Surface master = testing::append_points(nodes, {{1.5, 0.5}});
    PenetrationSearch search(master, slave);
    ContactRows rows;
    search.find(nodes.data(), 0.1, rows);
    EXPECT_TRUE(rows.empty());
    nodes[5].x[1] = 0.1;
    search.find(nodes.data(), 0.1, rows);
    EXPECT_TRUE(rows.empty());
    nodes[5].x[1] = -0.1;
    search.find(nodes.data(), 0.1, rows);
    EXPECT_EQ(rows.size(), 1U);
}

// The end of a face reaches a little past its last node: a node that comes down there must not be slept over.
TEST(SearchMotion, IsAwakeWhenANodePassesTheEnd) {
    std::vector<Node> nodes;
    const Surface slave = testing::append_chain(nodes, {{4, 0}, {3, 0}, {2, 0}, {1, 0}, {0, 0}}, false);
    const Surface master = testing::append_points(nodes, {{4.018, 0.05}});
    PenetrationSearch search(master, slave);
    ContactRows rows;
    for (int step = 0; rows.empty() && step < 100; ++step) {
        nodes[5].v[1] = -0.01;
        nodes[5].x[1] -= 0.001;
        search.find(nodes.data(), 0.1, rows);
        ASSERT_EQ(rows.size(), nodes[5].x[1] < 0 ? 1U : 0U) << nodes[5].x[1];
    }
    EXPECT_EQ(rows.size(), 1U);
}

}  // namespace
}  // namespace percuss
