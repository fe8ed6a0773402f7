#include "contact/solvers/conjugate_gradient.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/solvers/complementarity.hpp"

namespace percuss {

void ProjectedConjugateGradient::multiply(const ProfileMatrix& a, const std::vector<double>& x,
                                          std::vector<double>& y, std::int32_t begin, std::int32_t end) {
    const auto first = static_cast<std::size_t>(begin), last = static_cast<std::size_t>(end);
    for (std::size_t k = first; k < last; ++k) work_[k] = scale_[k] * x[k];
    a.multiply(work_, y, begin, end);
    for (std::size_t k = first; k < last; ++k) y[k] *= scale_[k];
}

int ProjectedConjugateGradient::solve(const ProfileMatrix& a, std::span<const double> p, std::span<char>,
                                      std::span<double> c, std::int32_t begin, std::int32_t end) {
    cut_short_ = false;
    const auto first = static_cast<std::size_t>(begin), last = static_cast<std::size_t>(end);
    for (std::vector<double>* v :
         {&scale_, &x_, &gradient_, &free_, &chopped_, &direction_, &product_, &work_})
        v->resize(p.size());
    const double tolerance = gap_tolerance * largest(p, begin, end);

    // Rows sums bound the largest eigenvalue of the scaled matrix, whose diagonal is 1.
    for (std::int32_t i = begin; i < end; ++i) {
        const double diagonal = a.at(i, i);
        scale_[static_cast<std::size_t>(i)] = diagonal > 0 ? 1 / std::sqrt(diagonal) : 0;
        work_[static_cast<std::size_t>(i)] = 0;
    }
    for (std::int32_t i = begin; i < end; ++i) {
        const auto k = static_cast<std::size_t>(i);
        for (std::int32_t j = a.first(i); j < i; ++j) {
            const auto l = static_cast<std::size_t>(j);
            const double entry = std::abs(a.at(i, j)) * scale_[k] * scale_[l];
            work_[k] += entry;
            work_[l] += entry;
        }
        work_[k] += 1;
    }
    const double length = 1.9 / *std::max_element(work_.begin() + begin, work_.begin() + end);

    for (std::size_t k = first; k < last; ++k) {
        x_[k] = 0;
        gradient_[k] = -scale_[k] * p[k];
    }
    const auto split = [&] {
        for (std::size_t k = first; k < last; ++k) {
            free_[k] = x_[k] > 0 ? gradient_[k] : 0;
            chopped_[k] = x_[k] > 0 ? 0 : std::min(gradient_[k], 0.0);
        }
    };
    const auto begin_anew = [&] {
        split();
        std::copy(free_.begin() + begin, free_.begin() + end, direction_.begin() + begin);
    };
    const auto dot = [&](const std::vector<double>& u, const std::vector<double>& v) {
        double sum = 0;
        for (std::size_t k = first; k < last; ++k) sum += u[k] * v[k];
        return sum;
    };
    const auto refresh_gradient = [&] {
        multiply(a, x_, gradient_, begin, end);
        for (std::size_t k = first; k < last; ++k) gradient_[k] -= scale_[k] * p[k];
    };
    const auto missed = [&] {
        double most = 0;
        for (std::size_t k = first; k < last; ++k)
            if (scale_[k] > 0) most = std::max(most, std::abs(free_[k] + chopped_[k]) / scale_[k]);
        return most;
    };
    const auto move = [&](double step, const std::vector<double>& along) {
        for (std::size_t k = first; k < last; ++k) {
            x_[k] -= step * along[k];
            gradient_[k] -= step * product_[k];
        }
    };

    begin_anew();
    int iteration = 0;
    for (;; ++iteration) {
        if (missed() <= tolerance) {
            refresh_gradient();  // updates of it gather rounding
            begin_anew();
            if (missed() <= tolerance) break;
        }
        if (iteration == most_iterations) {
            cut_short_ = true;
            break;
        }
        double reduced = 0;
        for (std::size_t k = first; k < last; ++k) reduced += std::min(x_[k] / length, free_[k]) * free_[k];
        if (dot(chopped_, chopped_) > reduced) {
            multiply(a, chopped_, product_, begin, end);
            const double curvature = dot(chopped_, product_);
            if (curvature <= 0) {
                cut_short_ = true;
                break;
            }
            move(dot(gradient_, chopped_) / curvature, chopped_);
            begin_anew();
            continue;
        }
        multiply(a, direction_, product_, begin, end);
        const double curvature = dot(direction_, product_);
        if (curvature <= 0) {
            refresh_gradient();
            begin_anew();
            if (dot(free_, free_) == 0) continue;
            cut_short_ = true;
            break;
        }
        const double step = dot(gradient_, direction_) / curvature;
        double farthest = std::numeric_limits<double>::infinity();
        for (std::size_t k = first; k < last; ++k)
            if (direction_[k] > 0) farthest = std::min(farthest, x_[k] / direction_[k]);
        if (step <= farthest) {
            move(step, direction_);
            for (std::size_t k = first; k < last; ++k) x_[k] = std::max(x_[k], 0.0);  // of rounding
            split();
            const double share = dot(free_, product_) / curvature;
            for (std::size_t k = first; k < last; ++k) direction_[k] = free_[k] - share * direction_[k];
            continue;
        }
        move(farthest, direction_);
        for (std::size_t k = first; k < last; ++k)
            x_[k] = x_[k] > 0 ? std::max(x_[k] - length * gradient_[k], 0.0) : 0;
        refresh_gradient();
        begin_anew();
    }
    for (std::size_t k = first; k < last; ++k) c[k] = scale_[k] * x_[k];
    return std::max(1, iteration);
}

}  // namespace percuss
