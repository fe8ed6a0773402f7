#include "contact/solvers/bounded.hpp"

#include <limits>

#include <gtest/gtest.h>

#include "engine/contact/solvers/random_system.hpp"

namespace percuss {
namespace {

using testing::Dense;
using testing::dense;
using testing::Rng;

/// Largest violation of C >= 0, A C - P >= 0 and their product = 0.
double violation(const Dense& a, const Eigen::VectorXd& p, const Eigen::VectorXd& c) {
    const Eigen::VectorXd gap = a * c - p;
    double worst = 0;
    for (Eigen::Index k = 0; k < p.size(); ++k)
        worst = std::max({worst, -c(k), -gap(k), std::abs(c(k) * gap(k))});
    return worst;
}

/// The answer by trying all active sets; empty when none satisfies the conditions.
Eigen::VectorXd by_brute_force(const Dense& a, const Eigen::VectorXd& p) {
    const auto n = static_cast<int>(p.size());
    Eigen::VectorXd best;
    double least = 1e-9;
    for (unsigned set = 0; set < 1U << n; ++set) {
        std::vector<Eigen::Index> rows;
        for (int k = 0; k < n; ++k)
            if (set >> k & 1U) rows.push_back(k);
        Eigen::VectorXd c = Eigen::VectorXd::Zero(n);
        if (!rows.empty()) {
            const Dense part = a(rows, rows);
            if (part.fullPivLu().rank() < part.rows()) continue;
            c(rows) = Eigen::VectorXd(part.ldlt().solve(Eigen::VectorXd(p(rows))));
        }
        if (violation(a, p, c) < least) {
            least = violation(a, p, c);
            best = c;
        }
    }
    return best;
}

Eigen::VectorXd solved(const Dense& a, const Eigen::VectorXd& p, Rng& random) {
    const auto n = static_cast<std::size_t>(p.size());
    std::vector<char> active(n);
    for (char& flag : active) flag = random.uniform(0, 1) < 0.5;  // the answer does not depend on the start
    std::vector<double> c(n);
    BoundedSolver solver;
    solver.solve(testing::profile(a), std::span(p.data(), n), active, c);
    return Eigen::Map<Eigen::VectorXd>(c.data(), p.size());
}

TEST(BoundedSolver, FindsTheOnlyActiveSet) {
    Rng random(3);
    for (int round = 0; round < 150; ++round) {
        const int n = 1 + round % 8;
        const Dense a = dense(testing::random_profile(random, n, 1 + round % 3));
        const std::vector<double> values = random.vector(n, -0.5, 1);
        const Eigen::VectorXd p = Eigen::Map<const Eigen::VectorXd>(values.data(), n);
        const Eigen::VectorXd expected = by_brute_force(a, p);
        ASSERT_EQ(expected.size(), n);
        EXPECT_LT((solved(a, p, random) - expected).lpNorm<Eigen::Infinity>(), 1e-9) << round;
    }
}

// Held master nodes leave no mass of their own in a row: rows that depend on each other and exclude each
// other as equations, but not as inequalities.
TEST(BoundedSolver, SolvesDependentRowsThatExcludeEachOtherAsEquations) {
    Rng random(4);
    int conflicting = 0;
    for (int round = 0; round < 200; ++round) {
        const int n = 3 + round % 5;
        Dense g = Dense::Zero(n, n);
        for (int row = 0; row < n; ++row)
            for (int column = 0; column < n; ++column) g(row, column) = random.uniform(-1, 1);
        g.row(2) = round % 2 ? Eigen::RowVectorXd(g.row(0) - g.row(1))
                             : Eigen::RowVectorXd(0.5 * (g.row(0) + g.row(1)));
        const Dense a = g * g.transpose();
        const std::vector<double> values = random.vector(n, -0.5, 1);
        const Eigen::VectorXd p = Eigen::Map<const Eigen::VectorXd>(values.data(), n);
        if (by_brute_force(a, p).size() == 0) continue;  // no answer at all
        ++conflicting;
        EXPECT_LT(violation(a, p, solved(a, p, random)), 0.05)
            << round << ": cut short, a few per cent may be left";
    }
    EXPECT_GT(conflicting, 100);
}

// Two rows push one node in opposite directions: no answer exists, forces stay bounded.
TEST(BoundedSolver, KeepsForcesBoundedWhereNoAnswerExists) {
    Dense a(2, 2);
    a << 1, -1, -1, 1;
    std::vector<char> active{1, 1};
    const std::vector<double> p{1, 1};
    std::vector<double> c(2);
    BoundedSolver().solve(testing::profile(a), p, active, c);
    for (const double force : c) {
        EXPECT_GE(force, 0);
        EXPECT_LT(force, 2000);
    }
}

TEST(BoundedSolver, MeetsTheConditionsOnTwoHundredRowsInFewRounds) {
    Rng random(5);
    int most_rounds = 0;
    for (int round = 0; round < 20; ++round) {
        constexpr int n = 200;
        const ProfileMatrix matrix = testing::random_profile(random, n, 3);
        const std::vector<double> p = random.vector(n, -0.5, 1);
        std::vector<char> active(n, 1);
        std::vector<double> c(n);
        BoundedSolver solver;
        most_rounds = std::max(most_rounds, solver.solve(matrix, p, active, c));
        EXPECT_LT(violation(dense(matrix), Eigen::Map<const Eigen::VectorXd>(p.data(), n),
                            Eigen::Map<const Eigen::VectorXd>(c.data(), n)),
                  1e-10);
    }
    EXPECT_LE(most_rounds, 20);
}

/// The answer between -limit and limit by trying all standings; empty when none satisfies the conditions.
Eigen::VectorXd within_by_brute_force(const Dense& a, const Eigen::VectorXd& p,
                                      const std::vector<double>& limit) {
    const auto n = static_cast<std::size_t>(p.size());
    std::size_t count = 1;
    for (std::size_t k = 0; k < n; ++k) count *= 3;
    for (std::size_t code = 0; code < count; ++code) {
        std::vector<Eigen::Index> free;
        Eigen::VectorXd c(p.size());
        std::vector<int> standing(n);
        for (std::size_t k = 0, rest = code; k < n; ++k, rest /= 3) {
            standing[k] = static_cast<int>(rest % 3) - 1;
            c(static_cast<Eigen::Index>(k)) = standing[k] * limit[k];
            if (standing[k] == 0) free.push_back(static_cast<Eigen::Index>(k));
        }
        if (!free.empty()) {
            const Eigen::VectorXd rest = p - a * c;
            c(free) = Eigen::VectorXd(Dense(a(free, free)).ldlt().solve(Eigen::VectorXd(rest(free))));
        }
        const Eigen::VectorXd gap = a * c - p;
        bool right = true;
        for (std::size_t k = 0; k < n; ++k) {
            const auto i = static_cast<Eigen::Index>(k);
            right = right && std::abs(c(i)) <= limit[k] + 1e-12 && standing[k] * gap(i) <= 1e-12;
        }
        if (right) return c;
    }
    return {};
}

TEST(BoundedSolver, FindsForcesWithinTheirLimits) {
    Rng random(6);
    int at_limit = 0, between = 0;
    for (int round = 0; round < 150; ++round) {
        const int n = 1 + round % 7;
        const ProfileMatrix matrix = testing::random_profile(random, n, 1 + round % 3);
        const std::vector<double> p = random.vector(n, -1, 1), start = random.vector(n, 0, 3);
        std::vector<double> limit = random.vector(n, 0, 0.5);
        if (round % 4 == 0) limit[0] = 0;  // nothing presses there
        std::vector<char> standing;
        for (const double s : start) standing.push_back(static_cast<char>(s));
        std::vector<double> c(p.size());
        BoundedSolver solver;
        solver.solve_within(limit, matrix, p, standing, c, 0, n);
        const Eigen::VectorXd expected =
            within_by_brute_force(dense(matrix), Eigen::Map<const Eigen::VectorXd>(p.data(), n), limit);
        ASSERT_EQ(expected.size(), n);
        for (std::size_t k = 0; k < c.size(); ++k) {
            EXPECT_NEAR(c[k], expected(static_cast<Eigen::Index>(k)), 1e-9) << round;
            (std::abs(c[k]) < limit[k] ? between : at_limit) += 1;
        }
    }
    EXPECT_GT(at_limit, 100);
    EXPECT_GT(between, 100);
}

// Two rows that ask for different gaps of one and the same motion, half of it by an unknown without bounds.
TEST(BoundedSolver, RelaxesRowsThatExcludeEachOtherBesideUnboundedUnknowns) {
    ProfileMatrix a;
    for (int k = 0; k < 3; ++k) a.append_row(0);
    const double g = 0.8;
    a.at(0, 0) = a.at(1, 0) = a.at(1, 1) = 1;
    a.at(2, 0) = a.at(2, 1) = g;
    a.at(2, 2) = -1;
    const std::vector<double> p{1, 2, 0};
    std::vector<double> c(3);
    std::vector<char> standing(3, BoundedSolver::between);
    BoundedSolver solver;
    solver.solve(a, p, standing, c);
    EXPECT_NEAR((1 + g * g) * (c[0] + c[1]), 2, 1e-9) << "the deeper one is closed";
    EXPECT_GE(c[0], 0);
    EXPECT_GE(c[1], 0);
    EXPECT_NEAR(c[2], g * (c[0] + c[1]), 1e-9);
}

}  // namespace
}  // namespace percuss
