#include "contact/joint/coupling.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

#include <gtest/gtest.h>

#include "contact/solvers/bounded.hpp"
#include "engine/contact/node_row.hpp"
#include "engine/contact/solvers/random_system.hpp"

namespace percuss {
namespace {

using testing::common_form;
using testing::Dense;
using testing::NodeRow;
using testing::Rng;

NodeRow random_row(Rng& random, int nodes) {
    NodeRow row;
    row.node = {random.index(nodes), random.index(nodes), random.index(nodes)};
    while (row.node[1] == row.node[0]) row.node[1] = random.index(nodes);
    while (row.node[2] == row.node[0] || row.node[2] == row.node[1]) row.node[2] = random.index(nodes);
    const double a = random.uniform(0, 1), angle = random.uniform(0, 6.28);
    row.share = {1, a - 1, -a};
    row.normal = {std::cos(angle), std::sin(angle)};
    return row;
}

/// factor G M^-1 G^T by dense algebra, in the given order of rows.
Dense reference(const std::vector<NodeRow>& rows, const std::vector<std::int32_t>& order,
                const std::vector<double>& inverse_mass, double factor) {
    const auto n = static_cast<Eigen::Index>(order.size()),
               m = static_cast<Eigen::Index>(inverse_mass.size());
    Dense g = Dense::Zero(n, m);
    for (Eigen::Index k = 0; k < n; ++k) {
        const NodeRow& row = rows[static_cast<std::size_t>(order[static_cast<std::size_t>(k)])];
        for (std::size_t slot = 0; slot < 3; ++slot)
            for (int d = 0; d < 2; ++d)
                g(k, 2 * row.node[slot] + d) += row.share[slot] * row.normal[static_cast<std::size_t>(d)];
    }
    const Eigen::VectorXd w = Eigen::Map<const Eigen::VectorXd>(inverse_mass.data(), m);
    return factor * g * w.asDiagonal() * g.transpose();
}

std::vector<std::int32_t> rows_in_order(const Coupling& coupling, const std::vector<std::int32_t>& chosen) {
    std::vector<std::int32_t> order;
    for (const std::int32_t k : coupling.order()) order.push_back(chosen[static_cast<std::size_t>(k)]);
    return order;
}

TEST(Coupling, IsTheMatrixOfTheRowsWithALittleMoreOnTheDiagonal) {
    Rng random(11);
    constexpr int nodes = 60;
    Coupling coupling(nodes);
    for (int round = 0; round < 100; ++round) {
        std::vector<NodeRow> rows;
        std::vector<std::int32_t> chosen;
        for (std::int32_t k = 0; k < 1 + round % 30; ++k) {
            rows.push_back(random_row(random, nodes));
            if (random.uniform(0, 1) < 0.7) chosen.push_back(k);
        }
        const std::vector<double> inverse_mass = random.vector(2 * nodes, 0.5, 2);
        // Twice: the second time its structure is known already, and normals have turned.
        for (int turn = 0; turn < 2; ++turn) {
            if (turn == 1)
                for (NodeRow& row : rows) std::swap(row.normal[0], row.normal[1]);
            coupling.assemble(common_form(rows).all(), chosen, inverse_mass.data(), 3);
            Dense expected = reference(rows, rows_in_order(coupling, chosen), inverse_mass, 3);
            expected.diagonal() *= 1 + 1e-8;
            ASSERT_EQ(coupling.matrix().rows(), expected.rows());
            if (chosen.empty()) continue;
            EXPECT_LT((testing::dense(coupling.matrix()) - expected).lpNorm<Eigen::Infinity>(), 1e-12)
                << round;
        }
    }
}

TEST(Coupling, GroupsShareNoNodesAndHoldEveryRowOnce) {
    Rng random(12);
    constexpr int nodes = 60;
    Coupling coupling(nodes);
    std::size_t most_groups = 0;
    for (int round = 0; round < 100; ++round) {
        std::vector<NodeRow> rows;
        std::vector<std::int32_t> chosen;
        for (std::int32_t k = 0; k < 2 + round % 20; ++k) {
            rows.push_back(random_row(random, nodes));
            chosen.push_back(k);
        }
        const std::vector<double> inverse_mass(2 * nodes, 1);
        coupling.assemble(common_form(rows).all(), chosen, inverse_mass.data(), 1);
        std::vector<int> group_of_node(nodes, -1), seen(rows.size(), 0);
        int g = 0;
        std::int32_t at = 0;
        for (const Coupling::Group& group : coupling.groups()) {
            EXPECT_EQ(group.begin, at);
            at = group.end;
            for (std::int32_t place = group.begin; place < group.end; ++place) {
                const auto k = static_cast<std::size_t>(coupling.order()[static_cast<std::size_t>(place)]);
                ++seen[k];
                for (const std::int32_t node : rows[k].node) {
                    int& owner = group_of_node[static_cast<std::size_t>(node)];
                    EXPECT_TRUE(owner == -1 || owner == g);
                    owner = g;
                }
            }
            ++g;
        }
        EXPECT_EQ(at, static_cast<std::int32_t>(rows.size()));
        EXPECT_EQ(std::count(seen.begin(), seen.end(), 1), static_cast<std::ptrdiff_t>(rows.size()));
        most_groups = std::max(most_groups, coupling.groups().size());
    }
    EXPECT_GT(most_groups, 3U);
}

/// Forces of all rows, by row, for what each would have to prevent.
std::vector<double> forces_of(const Coupling& coupling, const std::vector<double>& penetration,
                              std::span<const double> limit = {}) {
    const std::size_t places = coupling.places();
    std::vector<double> p(places, 0), c(places), limits(places, 0), forces(penetration.size());
    std::vector<char> standing(places, BoundedSolver::between);
    for (std::size_t place = 0; place < places; ++place) {
        if (!coupling.has_row(place)) continue;
        const auto row = static_cast<std::size_t>(coupling.order()[place]);
        p[place] = penetration[row];
        if (!limit.empty()) limits[place] = limit[row];
    }
    BoundedSolver solver;
    for (const Coupling::Group& group : coupling.groups()) {
        if (limit.empty())
            solver.solve(coupling.matrix(), p, standing, c, group.begin, group.end);
        else
            solver.solve_within(limits, coupling.matrix(), p, standing, c, group.begin, group.end);
        EXPECT_FALSE(solver.relaxed());
    }
    for (std::size_t place = 0; place < places; ++place)
        if (coupling.has_row(place)) forces[static_cast<std::size_t>(coupling.order()[place])] = c[place];
    return forces;
}

// A fine chain on three sides of a coarse one, and those sides' nodes on the chain.
TEST(Coupling, NodesOfManyRowsAreSplitOffAndTheForcesStay) {
    Rng random(13);
    constexpr std::int32_t coarse = 4, each = 100, fine = each * (coarse - 1);
    std::vector<NodeRow> rows;
    const auto add = [&](std::int32_t node, std::int32_t i, double a) {
        NodeRow& row = rows.emplace_back();
        row.node = {node, i, i + 1};
        row.share = {1, a - 1, -a};
        const double angle = 1.5 + random.uniform(-0.2, 0.2);
        row.normal = {std::cos(angle), std::sin(angle)};
    };
    for (std::int32_t k = 0; k < fine; ++k) add(coarse + k, k / each, (k % each + 0.5) / each);
    for (std::int32_t k = 1; k + 1 < coarse; ++k) add(k, coarse + k * each - 1, 0.5);
    std::vector<std::int32_t> all(rows.size());
    std::iota(all.begin(), all.end(), 0);
    const std::vector<double> inverse_mass = random.vector(2 * (coarse + fine), 0.5, 2);
    const std::vector<double> penetration = random.vector(static_cast<int>(rows.size()), -1, 3),
                              limit = random.vector(static_cast<int>(rows.size()), 0, 0.5);
    Coupling split(coarse + fine), whole(coarse + fine);
    whole.split_off(false);
    for (Coupling* coupling : {&split, &whole})
        coupling->assemble(common_form(rows).all(), all, inverse_mass.data(), 3);
    EXPECT_EQ(whole.places(), rows.size());
    EXPECT_EQ(split.places(), rows.size() + 2 * coarse);
    EXPECT_EQ(split.groups().size(), 1U);
    EXPECT_GT(whole.matrix().values().size(), 50 * rows.size());
    EXPECT_LT(split.matrix().values().size(), 12 * rows.size());
    const auto a = forces_of(split, penetration), b = forces_of(whole, penetration);
    const auto friction_a = forces_of(split, penetration, limit),
               friction_b = forces_of(whole, penetration, limit);
    int pressed = 0, sticking = 0;
    for (std::size_t k = 0; k < rows.size(); ++k) {
        // Some 300 products of numbers up to 1, on a diagonal of at least 1.
        EXPECT_NEAR(a[k], b[k], 1e-11) << k;
        EXPECT_NEAR(friction_a[k], friction_b[k], 1e-11) << k;
        pressed += b[k] > 0;
        sticking += std::abs(friction_b[k]) < limit[k];
    }
    EXPECT_GT(pressed, 30);
    EXPECT_LT(pressed, fine);
    EXPECT_GT(sticking, 10);
}

// Held nodes on a side that is free: without the side nothing would move their rows.
TEST(Coupling, NodesThatAloneMoveARowStayWithIt) {
    constexpr std::int32_t count = 2 * Coupling::most_sharing;
    for (const bool held : {false, true}) {
        std::vector<NodeRow> rows(count);
        std::vector<std::int32_t> all(count);
        std::iota(all.begin(), all.end(), 0);
        std::vector<double> inverse_mass(2 * (count + 2), 1);
        for (std::int32_t k = 0; k < count; ++k) {
            const double a = (k + 0.5) / count;
            rows[static_cast<std::size_t>(k)].node = {2 + k, 0, 1};
            rows[static_cast<std::size_t>(k)].share = {1, a - 1, -a};
            rows[static_cast<std::size_t>(k)].normal = {0, 1};
            if (held) inverse_mass[static_cast<std::size_t>(2 * (2 + k) + 1)] = 0;
        }
        Coupling coupling(count + 2);
        coupling.assemble(common_form(rows).all(), all, inverse_mass.data(), 1);
        EXPECT_EQ(coupling.places(), rows.size() + (held ? 0 : 4));
    }
}

// All rows on one wall share its two nodes.
TEST(Coupling, NodesOfWallsJoinNoGroups) {
    std::vector<NodeRow> rows(2);
    rows[0].node = {0, 8, 9};
    rows[1].node = {1, 8, 9};
    for (NodeRow& row : rows) {
        row.share = {1, -0.5, -0.5};
        row.normal = {0, 1};
    }
    const std::vector<double> inverse_mass(20, 1);
    const std::vector<std::int32_t> both{0, 1}, wall{8, 9};
    Coupling moving(10), fixed(10, wall);
    moving.assemble(common_form(rows).all(), both, inverse_mass.data(), 1);
    EXPECT_EQ(moving.groups().size(), 1U);
    fixed.assemble(common_form(rows).all(), both, inverse_mass.data(), 1);
    EXPECT_EQ(fixed.groups().size(), 2U);
}

// Rows of two pairs that meet along a face come one pair after the other: in that order each row would couple
// across the whole matrix.
TEST(Coupling, OrderOfPairsDoesNotWidenTheProfile) {
    constexpr std::int32_t count = 40;
    std::vector<NodeRow> rows;
    std::vector<std::int32_t> chosen;
    for (std::int32_t pair = 0; pair < 2; ++pair)
        for (std::int32_t k = 0; k < count; ++k) {
            NodeRow row;
            row.node = {k, 100 + 100 * pair + k, 101 + 100 * pair + k};
            row.share = {1, -0.5, -0.5};
            row.normal = {0, 1};
            chosen.push_back(static_cast<std::int32_t>(rows.size()));
            rows.push_back(row);
        }
    const std::vector<double> inverse_mass(2 * 400, 1);
    Coupling coupling(400);
    coupling.assemble(common_form(rows).all(), chosen, inverse_mass.data(), 1);
    EXPECT_EQ(coupling.groups().size(), 1U);
    std::int32_t widest = 0;
    for (std::int32_t k = 0; k < coupling.matrix().rows(); ++k)
        widest = std::max(widest, k - coupling.matrix().first(k));
    EXPECT_LE(widest, 5);
}

// The rim of a hole: node a in a side of b, c in b as well, a in c: three gaps of which the third is the
// first less the second. As equations they conflict; as inequalities they have an answer, and it keeps all
// three.
TEST(Coupling, DependentRowsOfARimAreSolvedWithinTheRegularisation) {
    constexpr std::int32_t a = 0, b = 1, c = 2, fixed = 3;
    const auto row = [](std::int32_t master, std::int32_t slave, double penetration) {
        NodeRow r;
        r.node = {master, slave, fixed};
        r.share = {1, -1, 0};
        r.normal = {0, 1};
        r.penetration = penetration;
        return r;
    };
    Rng random(13);
    for (int round = 0; round < 200; ++round) {
        std::vector<NodeRow> rows{row(a, b, random.uniform(-1, 1)), row(c, b, random.uniform(-1, 1)),
                                  row(a, c, random.uniform(-1, 1))};
        const std::vector<std::int32_t> all{0, 1, 2};
        std::vector<double> inverse_mass(8, 0);
        for (std::size_t k = 0; k < 6; ++k) inverse_mass[k] = random.uniform(0.2, 2);
        Coupling coupling(4);
        coupling.assemble(common_form(rows).all(), all, inverse_mass.data(), 1);
        std::vector<double> p, force(3);
        for (const std::int32_t k : coupling.order())
            p.push_back(rows[static_cast<std::size_t>(k)].penetration);
        std::vector<char> active(3, 1);
        BoundedSolver solver;
        for (const Coupling::Group& group : coupling.groups())
            solver.solve(coupling.matrix(), p, active, force, group.begin, group.end);
        EXPECT_FALSE(solver.relaxed());
        const Dense exact = reference(rows, rows_in_order(coupling, all), inverse_mass, 1);
        const Eigen::VectorXd gap =
            exact * Eigen::Map<Eigen::VectorXd>(force.data(), 3) - Eigen::Map<Eigen::VectorXd>(p.data(), 3);
        for (Eigen::Index k = 0; k < 3; ++k) {
            const double c_k = force[static_cast<std::size_t>(k)];
            EXPECT_GE(c_k, 0);
            EXPECT_GE(gap(k), -1e-8 * exact(k, k) * c_k - 1e-12) << round << ": no row is violated";
            EXPECT_LE(gap(k) * c_k, 1e-10) << round << ": no force across an open gap";
        }
    }
}

}  // namespace
}  // namespace percuss
