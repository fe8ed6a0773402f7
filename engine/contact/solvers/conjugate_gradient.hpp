#pragma once

#include <memory>
#include <vector>

#include "contact/solvers/nonnegative.hpp"

namespace percuss {

/// Conjugate gradients with projection: MPRGP of Dostal & Schoberl (2005, doi:10.1007/s10589-005-4557-7),
/// preconditioned by the diagonal (forces are scaled by its root, which keeps their signs). While the forces
/// at zero are right, conjugate gradients go on among the others; a step that would make one negative ends
/// at zero, followed by a projected gradient step of fixed length; forces at zero that should act are let go
/// when their share of the gradient outweighs the rest. Starts from zero. An iteration costs one or two
/// products with the matrix; their number grows with the longest chain of rows that bear on each other.
class ProjectedConjugateGradient final : public NonnegativeSolver {
  public:
    static constexpr int most_iterations = 20000;

    int solve(const ProfileMatrix& a, std::span<const double> p, std::span<char> standing,
              std::span<double> c, std::int32_t begin, std::int32_t end) override;
    [[nodiscard]] bool relaxed() const override { return cut_short_; }
    void reserve(std::size_t rows, std::size_t) override {
        for (std::vector<double>* v :
             {&scale_, &x_, &gradient_, &free_, &chopped_, &direction_, &product_, &work_})
            v->reserve(rows);
    }
    [[nodiscard]] std::unique_ptr<NonnegativeSolver> copy() const override {
        return std::make_unique<ProjectedConjugateGradient>(*this);
    }

  private:
    void multiply(const ProfileMatrix& a, const std::vector<double>& x, std::vector<double>& y,
                  std::int32_t begin, std::int32_t end);

    // Per row, all in the scaled problem; forces are scale times its unknowns.
    std::vector<double> scale_;  // 1 / root of the diagonal; 0: nothing moves the row
    std::vector<double> x_, gradient_, free_, chopped_, direction_, product_, work_;
    bool cut_short_ = false;
};

}  // namespace percuss
