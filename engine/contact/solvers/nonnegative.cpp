#include "contact/solvers/nonnegative.hpp"

#include <algorithm>
#include <cmath>

namespace percuss {
namespace {

constexpr double gap_tolerance = 1e-11;  // of the largest penetration
constexpr int relaxation_sweeps =
    500;  // from zero forces: cut short, they are too small rather than too large

}  // namespace

void NonnegativeSolver::reserve(std::size_t rows, std::size_t entries) {
    gap_.reserve(rows);
    cholesky_.reserve(rows, entries);
}

int NonnegativeSolver::solve(const ProfileMatrix& a, std::span<const double> p, std::span<char> active,
                             std::span<double> c, std::int32_t begin, std::int32_t end) {
    relaxed_ = false;
    gap_.resize(p.size());
    const auto first = static_cast<std::size_t>(begin), last = static_cast<std::size_t>(end);
    double deepest = 0;
    for (std::size_t k = first; k < last; ++k) deepest = std::max(deepest, std::abs(p[k]));

    std::size_t fewest_wrong = p.size() + 1;
    int block_moves_left = 3;
    // Murty's rule visits no set twice; the bound only guards against rounding.
    const int limit = 50 + 10 * static_cast<int>(last - first);
    for (int round = 1;; ++round) {
        std::copy(p.begin() + begin, p.begin() + end, c.begin() + begin);
        const int dependent = cholesky_.factorise(a, active, begin, end);
        cholesky_.solve(c);
        // The usual end of a warm start: all rows are active, solved and push.
        const auto pushes = [&](std::size_t k) {
            return cholesky_.used(static_cast<std::int32_t>(k)) && c[k] >= 0;
        };
        std::size_t pushing = first;
        while (pushing < last && pushes(pushing)) ++pushing;
        if (dependent == 0 && pushing == last) return round;
        a.multiply(c, gap_, begin, end);
        const auto open = [&](std::size_t k) { return gap_[k] - p[k] >= -gap_tolerance * deepest; };
        const auto wrong = [&](std::size_t k) { return active[k] ? c[k] < 0 : !open(k); };
        std::size_t wrong_count = 0, last_wrong = 0;
        bool conflict = false;
        for (std::size_t k = first; k < last; ++k) {
            if (wrong(k)) {
                ++wrong_count;
                last_wrong = k;
            }
            const auto row = static_cast<std::int32_t>(k);
            conflict = conflict || (active[k] && !cholesky_.used(row) && a.at(row, row) > 0 && !open(k));
        }
        if (wrong_count == 0 && !conflict) return round;
        if (wrong_count == 0 || round >= limit) {
            relax(a, p, c, begin, end);
            return round;
        }
        if (wrong_count < fewest_wrong) {
            fewest_wrong = wrong_count;
            block_moves_left = 3;
        } else if (block_moves_left > 0) {
            --block_moves_left;
        }
        if (block_moves_left == 0) {
            active[last_wrong] = !active[last_wrong];
        } else {
            for (std::size_t k = first; k < last; ++k)
                if (wrong(k)) active[k] = !active[k];
        }
    }
}

void NonnegativeSolver::relax(const ProfileMatrix& a, std::span<const double> p, std::span<double> c,
                              std::int32_t begin, std::int32_t end) {
    relaxed_ = true;
    std::fill(c.begin() + begin, c.begin() + end, 0.0);
    for (int sweep = 0; sweep < relaxation_sweeps; ++sweep) {
        double largest_change = 0, largest = 0;
        a.multiply(c, gap_, begin, end);
        for (std::int32_t k = begin; k < end; ++k)
            gap_[static_cast<std::size_t>(k)] -= p[static_cast<std::size_t>(k)];
        for (std::int32_t i = begin; i < end; ++i) {
            const auto k = static_cast<std::size_t>(i);
            if (a.at(i, i) <= 0) continue;
            const double force = std::max(0.0, c[k] - gap_[k] / a.at(i, i)), change = force - c[k];
            if (change == 0) continue;
            c[k] = force;
            for (std::int32_t j = i + 1; j < end; ++j)
                if (a.first(j) <= i) gap_[static_cast<std::size_t>(j)] += a.at(j, i) * change;
            largest_change = std::max(largest_change, std::abs(change));
            largest = std::max(largest, force);
        }
        if (largest_change <= 1e-13 * largest) return;
    }
}

}  // namespace percuss
