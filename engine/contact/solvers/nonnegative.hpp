#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "contact/solvers/profile_cholesky.hpp"

namespace percuss {

/// Solves for forces C >= 0 with A C - P >= 0 and C . (A C - P) = 0, A symmetric positive semidefinite. All
/// kinds come to the same tolerance: no gap A C - P is off by more than 1e-11 of the largest P.
class NonnegativeSolver {
  public:
    static constexpr double gap_tolerance = 1e-11;

    virtual ~NonnegativeSolver() = default;
    /// The diagonal block of rows begin to end, which no other row couples with.
    /// @param standing a start for kinds that know which forces act (BoundedSolver); they change it
    /// @param c the forces
    /// @returns how many iterations it took.
    virtual int solve(const ProfileMatrix& a, std::span<const double> p, std::span<char> standing,
                      std::span<double> c, std::int32_t begin, std::int32_t end) = 0;
    /// Whether the last solve fell back to relaxation or was cut short of the tolerance.
    [[nodiscard]] virtual bool relaxed() const = 0;
    /// Room for so many rows and entries.
    virtual void reserve(std::size_t rows, std::size_t entries) = 0;
    [[nodiscard]] virtual std::unique_ptr<NonnegativeSolver> copy() const = 0;
};

/// Owns a solver and is copied with it.
class AnyNonnegativeSolver {
  public:
    explicit AnyNonnegativeSolver(std::unique_ptr<NonnegativeSolver> solver) : solver_(std::move(solver)) {}
    AnyNonnegativeSolver(const AnyNonnegativeSolver& other) : solver_(other.solver_->copy()) {}
    AnyNonnegativeSolver(AnyNonnegativeSolver&&) noexcept = default;
    AnyNonnegativeSolver& operator=(const AnyNonnegativeSolver& other) {
        solver_ = other.solver_->copy();
        return *this;
    }
    AnyNonnegativeSolver& operator=(AnyNonnegativeSolver&&) noexcept = default;
    ~AnyNonnegativeSolver() = default;
    NonnegativeSolver* operator->() { return solver_.get(); }
    const NonnegativeSolver* operator->() const { return solver_.get(); }

  private:
    std::unique_ptr<NonnegativeSolver> solver_;
};

}  // namespace percuss
