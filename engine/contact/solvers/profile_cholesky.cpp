#include "contact/solvers/profile_cholesky.hpp"

#include <algorithm>

namespace percuss {

void ProfileMatrix::clear() {
    rows_.clear();
    values_.clear();
}

void ProfileMatrix::multiply(std::span<const double> x, std::span<double> y) const {
    std::fill(y.begin(), y.end(), 0.0);
    for (std::int32_t k = 0; k < rows(); ++k) {
        const double* entry = row(k);
        const double xk = x[static_cast<std::size_t>(k)];
        double sum = entry[k] * xk;
        for (std::int32_t column = first(k); column < k; ++column) {
            sum += entry[column] * x[static_cast<std::size_t>(column)];
            y[static_cast<std::size_t>(column)] += entry[column] * xk;
        }
        y[static_cast<std::size_t>(k)] += sum;
    }
}

int ProfileCholesky::factorise(const ProfileMatrix& matrix, std::span<const char> active) {
    factor_ = matrix;
    inverse_pivot_.assign(active.size(), 0);
    const double* inverse_pivot = inverse_pivot_.data();
    int dependent = 0;
    for (std::int32_t i = 0; i < factor_.rows(); ++i) {
        if (!active[static_cast<std::size_t>(i)]) continue;
        double* row = factor_.row(i);
        const std::int32_t first = factor_.first(i);
        for (std::int32_t j = first; j < i;
             ++j) {  // row becomes L D; what stands in columns left out is lost below
            const double* above = factor_.row(j);
            double value = row[j];
            for (std::int32_t k = std::max(first, factor_.first(j)); k < j; ++k) value -= row[k] * above[k];
            row[j] = value;
        }
        const double diagonal = row[i];
        double pivot = diagonal;
        for (std::int32_t j = first; j < i; ++j) {  // row becomes L
            const double value = row[j] * inverse_pivot[j];
            pivot -= value * row[j];
            row[j] = value;
        }
        if (pivot > 1e-12 * diagonal) {
            inverse_pivot_[static_cast<std::size_t>(i)] = 1 / pivot;
        } else if (diagonal > 0) {
            ++dependent;
        }
    }
    return dependent;
}

void ProfileCholesky::solve(std::span<double> x) const {
    const std::int32_t n = factor_.rows();
    for (std::int32_t i = 0; i < n; ++i) {
        double& xi = x[static_cast<std::size_t>(i)];
        if (!used(i)) {
            xi = 0;
            continue;
        }
        const double* row = factor_.row(i);
        for (std::int32_t j = factor_.first(i); j < i; ++j) xi -= row[j] * x[static_cast<std::size_t>(j)];
    }
    for (std::int32_t i = 0; i < n; ++i)
        x[static_cast<std::size_t>(i)] *= inverse_pivot_[static_cast<std::size_t>(i)];
    for (std::int32_t i = n - 1; i >= 0; --i) {
        if (!used(i)) continue;
        const double* row = factor_.row(i);
        const double xi = x[static_cast<std::size_t>(i)];
        for (std::int32_t j = factor_.first(i); j < i; ++j) x[static_cast<std::size_t>(j)] -= row[j] * xi;
    }
}

}  // namespace percuss
