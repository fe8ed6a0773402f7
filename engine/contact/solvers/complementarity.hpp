#pragma once

#include <algorithm>
#include <cmath>
#include <span>

#include "contact/solvers/profile_cholesky.hpp"

namespace percuss {

/// The largest |P| of rows begin to end.
[[nodiscard]] inline double largest(std::span<const double> p, std::int32_t begin, std::int32_t end) {
    double most = 0;
    for (auto k = static_cast<std::size_t>(begin); k < static_cast<std::size_t>(end); ++k)
        most = std::max(most, std::abs(p[k]));
    return most;
}

/// How far forces C >= 0 miss the conditions of NonnegativeSolver: a gap that is not closed under a force, or
/// is closed too far without. Rows that nothing can move are none. @param product A C
[[nodiscard]] inline double gap_error(const ProfileMatrix& a, std::span<const double> p,
                                      std::span<const double> c, std::span<const double> product,
                                      std::int32_t begin, std::int32_t end) {
    double most = 0;
    for (std::int32_t i = begin; i < end; ++i) {
        if (a.at(i, i) <= 0) continue;
        const auto k = static_cast<std::size_t>(i);
        const double gap = product[k] - p[k];
        most = std::max(most, c[k] > 0 ? std::abs(gap) : -gap);
    }
    return most;
}

}  // namespace percuss
