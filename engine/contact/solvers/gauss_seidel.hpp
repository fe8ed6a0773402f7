#pragma once

#include <memory>
#include <vector>

#include "contact/solvers/nonnegative.hpp"

namespace percuss {

/// Projected Gauss-Seidel (Cryer 1971, doi:10.1137/0309028): force after force takes the value that closes
/// its own gap, or zero; sweeps until the tolerance. Starts from zero: a warm start that is cut short leaves
/// stale forces. Every sweep costs one product with the matrix; their number grows with the square of the
/// longest chain of rows that bear on each other. Needs no factorisation and no independent rows.
class ProjectedGaussSeidel final : public NonnegativeSolver {
  public:
    static constexpr int most_sweeps = 20000;

    int solve(const ProfileMatrix& a, std::span<const double> p, std::span<char> standing,
              std::span<double> c, std::int32_t begin, std::int32_t end) override;
    [[nodiscard]] bool relaxed() const override { return cut_short_; }
    void reserve(std::size_t rows, std::size_t) override { later_.reserve(rows); }
    [[nodiscard]] std::unique_ptr<NonnegativeSolver> copy() const override {
        return std::make_unique<ProjectedGaussSeidel>(*this);
    }

  private:
    std::vector<double> later_;  // per row: what the forces of later rows do to its gap
    bool cut_short_ = false;
};

}  // namespace percuss
