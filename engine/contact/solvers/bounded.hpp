#pragma once

#include <span>
#include <vector>

#include "contact/solvers/nonnegative.hpp"

namespace percuss {

/// Forces C between bounds that minimise 1/2 C A C - P C, A symmetric positive semidefinite: where a force is
/// between its bounds the gap A C - P is closed, at its lower bound it is open or just closed, at its upper
/// one overclosed or just closed. Block principal pivoting (Judice & Pires 1994,
/// doi:10.1016/0305-0548(94)90106-6): all wrong signs change sides at once, and when their number stops
/// falling, one at a time (Murty's rule), which always ends. Where rows depend on each other (held master
/// nodes) and exclude each other as equations, projected Gauss-Seidel takes over.
///
/// A row with a negative diagonal is an unknown without bounds, which stands `between`, and its P is 0: see
/// Coupling. Those couple with other rows only.
class BoundedSolver final : public NonnegativeSolver {
  public:
    /// Where a force stands. The first two are what a flag "is active" says of a force that only has a lower
    /// bound.
    static constexpr char at_lower = 0, between = 1, at_upper = 2;

    /// C >= 0: contact forces.
    /// @param standing where to start from; changed. @param c the forces. @returns number of factorisations.
    int solve(const ProfileMatrix& a, std::span<const double> p, std::span<char> standing,
              std::span<double> c) {
        return solve(a, p, standing, c, 0, a.rows());
    }
    /// The same for the diagonal block of rows begin to end, which no other row couples with.
    int solve(const ProfileMatrix& a, std::span<const double> p, std::span<char> standing,
              std::span<double> c, std::int32_t begin, std::int32_t end) override;
    /// -limit <= C <= limit: friction forces. @param limit >= 0.
    int solve_within(std::span<const double> limit, const ProfileMatrix& a, std::span<const double> p,
                     std::span<char> standing, std::span<double> c, std::int32_t begin, std::int32_t end);
    /// Whether the last solve ended in projected Gauss-Seidel.
    [[nodiscard]] bool relaxed() const override { return relaxed_; }
    void reserve(std::size_t rows, std::size_t entries) override;
    [[nodiscard]] std::unique_ptr<NonnegativeSolver> copy() const override {
        return std::make_unique<BoundedSolver>(*this);
    }

  private:
    template <class Bounds>
    int pivot(const Bounds& bounds, const ProfileMatrix& a, std::span<const double> p,
              std::span<char> standing, std::span<double> c, std::int32_t begin, std::int32_t end);
    template <class Bounds>
    void solve_between(const Bounds& bounds, const ProfileMatrix& a, std::span<const double> p,
                       std::span<const char> standing, std::span<double> c, std::int32_t begin,
                       std::int32_t end);
    template <class Bounds>
    void relax(const Bounds& bounds, const ProfileMatrix& a, std::span<const double> p, std::span<double> c,
               std::int32_t begin, std::int32_t end);

    ProfileCholesky cholesky_;
    struct Unbounded {
        std::int32_t row;
        double counted;  // its value in gap_
    };
    std::vector<double> gap_;
    std::vector<Unbounded> unbounded_;  // used by relax
    int dependent_ = 0;
    bool relaxed_ = false;
};

}  // namespace percuss
