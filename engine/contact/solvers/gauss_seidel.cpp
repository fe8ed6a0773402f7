#include "contact/solvers/gauss_seidel.hpp"

#include <algorithm>
#include <cmath>

#include "contact/solvers/complementarity.hpp"

namespace percuss {

int ProjectedGaussSeidel::solve(const ProfileMatrix& a, std::span<const double> p, std::span<char>,
                                std::span<double> c, std::int32_t begin, std::int32_t end) {
    cut_short_ = false;
    later_.resize(p.size());
    std::fill(c.begin() + begin, c.begin() + end, 0.0);
    const double tolerance = gap_tolerance * largest(p, begin, end);
    for (int sweep = 1;; ++sweep) {
        std::fill(later_.begin() + begin, later_.begin() + end, 0.0);
        for (std::int32_t k = begin; k < end; ++k) {
            const double* entry = a.row(k);
            const double force = c[static_cast<std::size_t>(k)];
            if (force == 0) continue;
            for (std::int32_t j = a.first(k); j < k; ++j)
                later_[static_cast<std::size_t>(j)] += entry[j] * force;
        }
        double most = 0;
        for (std::int32_t i = begin; i < end; ++i) {
            const auto k = static_cast<std::size_t>(i);
            const double* entry = a.row(i);
            if (entry[i] <= 0) continue;
            double gap = later_[k] - p[k];
            for (std::int32_t j = a.first(i); j < i; ++j) gap += entry[j] * c[static_cast<std::size_t>(j)];
            const double force = std::max(0.0, -gap / entry[i]);
            most = std::max(most, entry[i] * std::abs(force - c[k]));
            c[k] = force;
        }
        if (most <= tolerance) {
            a.multiply(c, later_, begin, end);
            if (gap_error(a, p, c, later_, begin, end) <= tolerance) return sweep;
        }
        if (sweep == most_sweeps) {
            cut_short_ = true;
            return sweep;
        }
    }
}

}  // namespace percuss
