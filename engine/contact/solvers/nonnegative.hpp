#pragma once

#include <span>
#include <vector>

#include "contact/solvers/profile_cholesky.hpp"

namespace percuss {

/// Forces C >= 0 that minimise 1/2 C A C - P C, A symmetric positive semidefinite: where a force is zero the
/// gap A C - P is open or just closed. Block principal pivoting (Judice & Pires 1994,
/// doi:10.1016/0305-0548(94)90106-6): all wrong signs change sides at once, and when their number stops
/// falling, one at a time (Murty's rule), which always ends. Where rows depend on each other (held master
/// nodes) and exclude each other as equations, projected Gauss-Seidel takes over.
class NonnegativeSolver {
  public:
    /// @param active which rows to start from, one char each; changed. @param c the forces.
    /// @returns number of factorisations.
    int solve(const ProfileMatrix& a, std::span<const double> p, std::span<char> active,
              std::span<double> c) {
        return solve(a, p, active, c, 0, a.rows());
    }
    /// The same for the diagonal block of rows begin to end, which no other row couples with.
    int solve(const ProfileMatrix& a, std::span<const double> p, std::span<char> active, std::span<double> c,
              std::int32_t begin, std::int32_t end);
    /// Whether the last solve ended in projected Gauss-Seidel.
    [[nodiscard]] bool relaxed() const { return relaxed_; }
    void reserve(std::size_t rows, std::size_t entries);

  private:
    void relax(const ProfileMatrix& a, std::span<const double> p, std::span<double> c, std::int32_t begin,
               std::int32_t end);

    ProfileCholesky cholesky_;
    std::vector<double> gap_;
    bool relaxed_ = false;
};

}  // namespace percuss
