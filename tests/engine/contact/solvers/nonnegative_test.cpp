// Solvers of the nonnegative problem side by side: the conditions hold, and the forces are those of the
// active set.
#include <memory>

#include <gtest/gtest.h>

#include "contact/solvers/bounded.hpp"
#include "contact/solvers/complementarity.hpp"
#include "contact/solvers/conjugate_gradient.hpp"
#include "contact/solvers/gauss_seidel.hpp"
#include "engine/contact/solvers/random_system.hpp"

namespace percuss {
namespace {

using testing::Dense;
using testing::Rng;

std::unique_ptr<NonnegativeSolver> gauss_seidel() { return std::make_unique<ProjectedGaussSeidel>(); }
std::unique_ptr<NonnegativeSolver> conjugate_gradient() {
    return std::make_unique<ProjectedConjugateGradient>();
}

class NonnegativeSolvers : public ::testing::TestWithParam<std::unique_ptr<NonnegativeSolver> (*)()> {
  protected:
    std::vector<double> solve(const ProfileMatrix& a, const std::vector<double>& p, std::int32_t begin,
                              std::int32_t end) {
        std::vector<double> c(p.size(), -7);  // what a force was before does not matter
        std::vector<char> standing(p.size(), BoundedSolver::between);
        EXPECT_GE(solver->solve(a, p, standing, c, begin, end), 1);
        EXPECT_FALSE(solver->relaxed());
        return c;
    }
    static double error(const ProfileMatrix& a, const std::vector<double>& p, const std::vector<double>& c) {
        std::vector<double> product(p.size());
        a.multiply(c, product);
        return gap_error(a, p, c, product, 0, a.rows()) / largest(p, 0, a.rows());
    }
    std::unique_ptr<NonnegativeSolver> solver = GetParam()();
};

TEST_P(NonnegativeSolvers, MeetTheConditionsWithTheForcesOfTheActiveSet) {
    Rng random(41);
    int pressed = 0, open = 0;
    for (int round = 0; round < 60; ++round) {
        const int n = 1 + random.index(40);
        const ProfileMatrix a = testing::random_profile(random, n, 1 + random.index(3));
        const std::vector<double> p = random.vector(n, -1, 1);
        const std::vector<double> c = solve(a, p, 0, n);
        EXPECT_LE(error(a, p, c), 1.01e-11);
        std::vector<double> exact(p.size());
        std::vector<char> standing(p.size(), BoundedSolver::between);
        BoundedSolver().solve(a, p, standing, exact);
        // A gap that is off by 1e-11 shifts a force by that over the smallest eigenvalue.
        const double softest = Eigen::SelfAdjointEigenSolver<Dense>(testing::dense(a)).eigenvalues()(0);
        for (std::size_t k = 0; k < p.size(); ++k) {
            ASSERT_GE(c[k], 0);
            ASSERT_NEAR(c[k], exact[k], 1e-10 / softest);
            ++(exact[k] > 0 ? pressed : open);
        }
    }
    EXPECT_GT(pressed, 300);
    EXPECT_GT(open, 300);
}

TEST_P(NonnegativeSolvers, SolveABlockAndLeaveTheOthersAlone) {
    Rng random(42);
    const Dense first = testing::dense(testing::random_profile(random, 6, 2)),
                second = testing::dense(testing::random_profile(random, 9, 2));
    Dense both = Dense::Zero(15, 15);
    both.topLeftCorner(6, 6) = first;
    both.bottomRightCorner(9, 9) = second;
    const std::vector<double> p = random.vector(15, -1, 1), q(p.begin() + 6, p.end());
    const auto whole = solve(testing::profile(both), p, 6, 15),
               alone = solve(testing::profile(second), q, 0, 9);
    for (std::size_t k = 0; k < 6; ++k) EXPECT_EQ(whole[k], -7);
    for (std::size_t k = 0; k < 9; ++k) EXPECT_EQ(whole[6 + k], alone[k]);
}

// As at the rim of a hole: the third row is the difference of the first two, and nothing moves the last one.
TEST_P(NonnegativeSolvers, BearRowsThatDependOnEachOther) {
    Dense g = Dense::Zero(4, 3);
    g.row(0) << 1, 0, 0.5;
    g.row(1) << 0.2, 1, 0;
    g.row(2) = g.row(0) - g.row(1);
    const ProfileMatrix a = testing::profile(Dense(g * g.transpose()));
    for (const std::vector<double>& p :
         {std::vector<double>{1, 0.5, 0.4, -1}, {0.3, 1, 0.2, 0}, {-1, -2, -0.5, -1}, {1, 1, 2e-3, 0}}) {
        const std::vector<double> c = solve(a, p, 0, 4);
        EXPECT_LE(error(a, p, c), 1.01e-11);
        EXPECT_EQ(c[3], 0);
    }
}

// Every second row is pressed apart by its neighbours, each at another length of the first step. A projection
// takes them out together, not one in each step as a step to the nearest bound would.
TEST(ProjectedConjugateGradients, OpenManyRowsInOneStep) {
    constexpr int n = 400;
    Dense chain = Dense::Identity(n, n);
    std::vector<double> p(n);
    for (int k = 0; k < n; ++k) {
        if (k > 0) chain(k, k - 1) = chain(k - 1, k) = 0.4;
        p[static_cast<std::size_t>(k)] = k % 2 == 0 ? 1 : 0.001 * (k + 1);
    }
    std::vector<double> c(n);
    std::vector<char> standing(n, BoundedSolver::between);
    ProjectedConjugateGradient solver;
    EXPECT_LT(solver.solve(testing::profile(chain), p, standing, c, 0, n), 60);
    for (std::size_t k = 0; k < n; ++k) ASSERT_NEAR(c[k], k % 2 == 0 ? 1 : 0, 1e-9) << k;
}

INSTANTIATE_TEST_SUITE_P(Kinds, NonnegativeSolvers, ::testing::Values(&gauss_seidel, &conjugate_gradient),
                         [](const auto& kind) {
                             return kind.param == &gauss_seidel ? "gauss_seidel" : "conjugate_gradient";
                         });

}  // namespace
}  // namespace percuss
