#include "contact/solvers/profile_cholesky.hpp"

#include <gtest/gtest.h>

#include "engine/contact/solvers/random_system.hpp"

namespace percuss {
namespace {

using testing::Dense;
using testing::dense;
using testing::Rng;

// The answer of the active rows alone, zeros elsewhere, by Eigen's dense factors.
Eigen::VectorXd dense_answer(const Dense& a, const std::vector<char>& active, const std::vector<double>& p) {
    std::vector<Eigen::Index> rows;
    for (std::size_t k = 0; k < active.size(); ++k)
        if (active[k]) rows.push_back(static_cast<Eigen::Index>(k));
    const Eigen::Map<const Eigen::VectorXd> right(p.data(), static_cast<Eigen::Index>(p.size()));
    Eigen::VectorXd x = Eigen::VectorXd::Zero(right.size());
    x(rows) = Eigen::VectorXd(Dense(a(rows, rows)).ldlt().solve(Eigen::VectorXd(right(rows))));
    return x;
}

TEST(ProfileCholesky, AgreesWithDenseFactorsForAnyProfileAndActiveRows) {
    Rng random(1);
    for (int round = 0; round < 200; ++round) {
        const int n = 1 + round % 23;
        const ProfileMatrix matrix = testing::random_profile(random, n, 1 + round % 5);
        const Dense a = dense(matrix);
        std::vector<char> active(static_cast<std::size_t>(n));
        for (char& flag : active) flag = random.uniform(0, 1) < 0.7;
        if (round % 3 == 0) std::fill(active.begin(), active.end(), char{1});
        const std::vector<double> p = random.vector(n, -1, 1);
        std::vector<double> x = p;
        ProfileCholesky cholesky;
        EXPECT_EQ(cholesky.factorise(matrix, active), 0);
        cholesky.solve(x);
        const Eigen::VectorXd expected = dense_answer(a, active, p);
        for (int k = 0; k < n; ++k) ASSERT_NEAR(x[static_cast<std::size_t>(k)], expected(k), 1e-11) << round;
    }
}

TEST(ProfileCholesky, LeavesDependentAndImmobileRowsOut) {
    // g3 = g1 - g2, and a fourth row that no force moves.
    ProfileMatrix matrix;
    const double entries[4][4] = {{2, 0, 0, 0}, {0.5, 1, 0, 0}, {1.5, -0.5, 2, 0}, {0, 0, 0, 0}};
    for (int k = 0; k < 4; ++k) {
        matrix.append_row(0);
        for (int j = 0; j <= k; ++j) matrix.at(k, j) = entries[k][j];
    }
    ProfileCholesky cholesky;
    const std::vector<char> active{1, 1, 1, 1};
    EXPECT_EQ(cholesky.factorise(matrix, active), 1) << "the immobile row is not counted";
    EXPECT_TRUE(cholesky.used(0) && cholesky.used(1));
    EXPECT_FALSE(cholesky.used(2) || cholesky.used(3));
    std::vector<double> x{1, 0.25, 7, 7};
    cholesky.solve(x);
    EXPECT_NEAR(x[0], 0.5, 1e-15);
    EXPECT_NEAR(x[1], 0, 1e-15);
    EXPECT_EQ(x[2], 0);
    EXPECT_EQ(x[3], 0);
}

TEST(ProfileMatrix, MultipliesLikeTheDenseMatrix) {
    Rng random(2);
    const ProfileMatrix matrix = testing::random_profile(random, 17, 4);
    const std::vector<double> x = random.vector(17, -1, 1);
    std::vector<double> y(17);
    matrix.multiply(x, y);
    const Eigen::VectorXd expected = dense(matrix) * Eigen::Map<const Eigen::VectorXd>(x.data(), 17);
    for (int k = 0; k < 17; ++k) EXPECT_NEAR(y[static_cast<std::size_t>(k)], expected(k), 1e-14);
}

}  // namespace
}  // namespace percuss
