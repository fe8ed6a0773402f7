#include "contact/solvers/bounded.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace percuss {
namespace {

constexpr int relaxation_sweeps =
    500;  // from zero forces: cut short, they are too small rather than too large

bool unbounded(const ProfileMatrix& a, std::size_t k) {
    const auto row = static_cast<std::int32_t>(k);
    return a.at(row, row) < 0;
}

struct NoTension {
    static constexpr bool zero = true;  // every finite bound is
    [[nodiscard]] static double lower(std::size_t) { return 0; }
    [[nodiscard]] static double upper(std::size_t) { return std::numeric_limits<double>::infinity(); }
};

struct Within {
    static constexpr bool zero = false;
    std::span<const double> limit;
    [[nodiscard]] double lower(std::size_t k) const { return -limit[k]; }
    [[nodiscard]] double upper(std::size_t k) const { return limit[k]; }
};

}  // namespace

void BoundedSolver::reserve(std::size_t rows, std::size_t entries) {
    gap_.reserve(rows);
    cholesky_.reserve(rows, entries);
}

int BoundedSolver::solve(const ProfileMatrix& a, std::span<const double> p, std::span<char> standing,
                         std::span<double> c, std::int32_t begin, std::int32_t end) {
    return pivot(NoTension{}, a, p, standing, c, begin, end);
}

int BoundedSolver::solve_within(std::span<const double> limit, const ProfileMatrix& a,
                                std::span<const double> p, std::span<char> standing, std::span<double> c,
                                std::int32_t begin, std::int32_t end) {
    return pivot(Within{limit}, a, p, standing, c, begin, end);
}

template <class Bounds>
int BoundedSolver::pivot(const Bounds& bounds, const ProfileMatrix& a, std::span<const double> p,
                         std::span<char> standing, std::span<double> c, std::int32_t begin,
                         std::int32_t end) {
    relaxed_ = false;
    gap_.resize(p.size());
    const auto first = static_cast<std::size_t>(begin), last = static_cast<std::size_t>(end);
    double deepest = 0;
    for (std::size_t k = first; k < last; ++k) deepest = std::max(deepest, std::abs(p[k]));
    const double tolerance = gap_tolerance * deepest;

    std::size_t fewest_wrong = p.size() + 1;
    int block_moves_left = 3;
    // Murty's rule visits no set twice; the bound only guards against rounding.
    const int limit = 50 + 10 * static_cast<int>(last - first);
    for (int round = 1;; ++round) {
        solve_between(bounds, a, p, standing, c, begin, end);
        // The usual end of a warm start: all rows are solved for and within their bounds.
        const auto fits = [&](std::size_t k) {
            return cholesky_.used(static_cast<std::int32_t>(k)) &&
                   ((c[k] >= bounds.lower(k) && c[k] <= bounds.upper(k)) || unbounded(a, k));
        };
        std::size_t fitting = first;
        while (fitting < last && fits(fitting)) ++fitting;
        if (dependent_ == 0 && fitting == last) return round;
        a.multiply(c, gap_, begin, end);
        const auto wants_more = [&](std::size_t k) { return gap_[k] - p[k] < -tolerance; };
        const auto wants_less = [&](std::size_t k) { return gap_[k] - p[k] > tolerance; };
        /// Where a force should stand, if not where it does.
        const auto better = [&](std::size_t k) {
            if (standing[k] == between)
                return unbounded(a, k)          ? between
                       : c[k] < bounds.lower(k) ? at_lower
                       : c[k] > bounds.upper(k) ? at_upper
                                                : between;
            if (bounds.lower(k) == bounds.upper(k)) return standing[k];
            return (standing[k] == at_lower ? wants_more(k) : wants_less(k)) ? between : standing[k];
        };
        std::size_t wrong_count = 0, last_wrong = 0;
        bool conflict = false;
        for (std::size_t k = first; k < last; ++k) {
            if (better(k) != standing[k]) {
                ++wrong_count;
                last_wrong = k;
            }
            const auto row = static_cast<std::int32_t>(k);
            // A row left out for its dependence on others, which do not close it.
            conflict =
                conflict ||
                (standing[k] == between && !cholesky_.used(row) && a.at(row, row) > 0 &&
                 ((wants_more(k) && c[k] < bounds.upper(k)) || (wants_less(k) && c[k] > bounds.lower(k))));
        }
        if (wrong_count == 0 && !conflict) return round;
        if (wrong_count == 0 || round >= limit) {
            relax(bounds, a, p, c, begin, end);
            return round;
        }
        if (wrong_count < fewest_wrong) {
            fewest_wrong = wrong_count;
            block_moves_left = 3;
        } else if (block_moves_left > 0) {
            --block_moves_left;
        }
        if (block_moves_left == 0) {
            standing[last_wrong] = better(last_wrong);
        } else {
            for (std::size_t k = first; k < last; ++k) standing[k] = better(k);
        }
    }
}

/// Closes the gaps of the forces between their bounds, with the others at theirs.
template <class Bounds>
void BoundedSolver::solve_between(const Bounds& bounds, const ProfileMatrix& a, std::span<const double> p,
                                  std::span<const char> standing, std::span<double> c, std::int32_t begin,
                                  std::int32_t end) {
    const auto first = static_cast<std::size_t>(begin), last = static_cast<std::size_t>(end);
    const auto at_bound = [&](std::size_t k) {
        return standing[k] == between ? 0 : standing[k] == at_lower ? bounds.lower(k) : bounds.upper(k);
    };
    if constexpr (Bounds::zero) {
        std::copy(p.begin() + begin, p.begin() + end, c.begin() + begin);
    } else {
        for (std::size_t k = first; k < last; ++k) c[k] = at_bound(k);
        a.multiply(c, gap_, begin, end);
        for (std::size_t k = first; k < last; ++k) c[k] = p[k] - gap_[k];
    }
    dependent_ = cholesky_.factorise(a, standing, begin, end);
    cholesky_.solve(c);
    if constexpr (!Bounds::zero)
        for (std::size_t k = first; k < last; ++k)
            if (standing[k] != between) c[k] = at_bound(k);
}

/// Unbounded unknowns follow from the forces at once: l = (row of l) . C, whatever their own diagonal of -1.
template <class Bounds>
void BoundedSolver::relax(const Bounds& bounds, const ProfileMatrix& a, std::span<const double> p,
                          std::span<double> c, std::int32_t begin, std::int32_t end) {
    relaxed_ = true;
    std::fill(c.begin() + begin, c.begin() + end, 0.0);
    unbounded_.clear();
    for (std::int32_t i = begin; i < end; ++i)
        if (a.at(i, i) < 0) unbounded_.push_back({i, 0});
    /// Of a force with an unbounded unknown.
    const auto with = [&](std::int32_t i, std::int32_t l) {
        return l > i ? (a.first(l) <= i ? a.at(l, i) : 0) : (a.first(i) <= l ? a.at(i, l) : 0);
    };
    for (int sweep = 0; sweep < relaxation_sweeps; ++sweep) {
        double largest_change = 0, largest = 0;
        a.multiply(c, gap_, begin, end);
        for (Unbounded& l : unbounded_) l.counted = c[static_cast<std::size_t>(l.row)];
        for (std::int32_t k = begin; k < end; ++k)
            gap_[static_cast<std::size_t>(k)] -= p[static_cast<std::size_t>(k)];
        for (std::int32_t i = begin; i < end; ++i) {
            const auto k = static_cast<std::size_t>(i);
            if (a.at(i, i) <= 0) continue;
            double diagonal = a.at(i, i), gap = gap_[k];
            for (const Unbounded& l : unbounded_) {
                const double share = with(i, l.row);
                diagonal += share * share;
                gap += share * (c[static_cast<std::size_t>(l.row)] - l.counted);
            }
            const double force = std::clamp(c[k] - gap / diagonal, bounds.lower(k), bounds.upper(k)),
                         change = force - c[k];
            if (change == 0) continue;
            c[k] = force;
            for (std::int32_t j = i + 1; j < end; ++j)
                if (a.first(j) <= i) gap_[static_cast<std::size_t>(j)] += a.at(j, i) * change;
            for (const Unbounded& l : unbounded_)
                c[static_cast<std::size_t>(l.row)] += with(i, l.row) * change;
            largest_change = std::max(largest_change, std::abs(change));
            largest = std::max(largest, std::abs(force));
        }
        if (largest_change <= 1e-13 * largest) return;
    }
}

}  // namespace percuss
