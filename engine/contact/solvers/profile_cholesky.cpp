#include "contact/solvers/profile_cholesky.hpp"

#include <algorithm>

namespace percuss {

void ProfileMatrix::clear() {
    rows_.clear();
    values_.clear();
}

void ProfileMatrix::multiply(std::span<const double> x, std::span<double> y, std::int32_t begin,
                             std::int32_t end) const {
    for (std::int32_t k = begin; k < end; ++k) {
        const double* entry = row(k);
        const double xk = x[static_cast<std::size_t>(k)];
        double sum = entry[k] * xk;
        for (std::int32_t column = first(k); column < k; ++column) {
            sum += entry[column] * x[static_cast<std::size_t>(column)];
            y[static_cast<std::size_t>(column)] += entry[column] * xk;
        }
        y[static_cast<std::size_t>(k)] = sum;
    }
}

int ProfileCholesky::factorise(const ProfileMatrix& matrix, std::span<const char> active, std::int32_t begin,
                               std::int32_t end) {
    shape_ = &matrix;
    begin_ = begin;
    end_ = end;
    const std::span<const double> entries = matrix.values();
    factor_.resize(entries.size());
    inverse_pivot_.resize(active.size());
    if (begin == end) return 0;
    const std::ptrdiff_t from = matrix.index(begin, matrix.first(begin)),
                         to = matrix.index(end - 1, end - 1) + 1;
    std::copy(entries.begin() + from, entries.begin() + to, factor_.begin() + from);
    std::fill(inverse_pivot_.begin() + begin, inverse_pivot_.begin() + end, 0.0);
    const double* inverse_pivot = inverse_pivot_.data();
    int dependent = 0;
    for (std::int32_t i = begin; i < end; ++i) {
        if (active[static_cast<std::size_t>(i)] != 1) continue;
        double* entry = row(i);
        const std::int32_t first = matrix.first(i);
        for (std::int32_t j = first; j < i;
             ++j) {  // row becomes L D; what stands in columns left out is lost below
            const double* above = row(j);
            double value = entry[j];
            for (std::int32_t k = std::max(first, matrix.first(j)); k < j; ++k) value -= entry[k] * above[k];
            entry[j] = value;
        }
        const double diagonal = entry[i];
        double pivot = diagonal;
        for (std::int32_t j = first; j < i; ++j) {  // row becomes L
            const double value = entry[j] * inverse_pivot[j];
            pivot -= value * entry[j];
            entry[j] = value;
        }
        if (pivot > 1e-12 * diagonal || diagonal < 0) {
            inverse_pivot_[static_cast<std::size_t>(i)] = 1 / pivot;
        } else if (diagonal > 0) {
            ++dependent;
        }
    }
    return dependent;
}

void ProfileCholesky::solve(std::span<double> x) const {
    for (std::int32_t i = begin_; i < end_; ++i) {
        double& xi = x[static_cast<std::size_t>(i)];
        if (!used(i)) {
            xi = 0;
            continue;
        }
        const double* entry = row(i);
        for (std::int32_t j = shape_->first(i); j < i; ++j) xi -= entry[j] * x[static_cast<std::size_t>(j)];
    }
    for (std::int32_t i = begin_; i < end_; ++i)
        x[static_cast<std::size_t>(i)] *= inverse_pivot_[static_cast<std::size_t>(i)];
    for (std::int32_t i = end_ - 1; i >= begin_; --i) {
        if (!used(i)) continue;
        const double* entry = row(i);
        const double xi = x[static_cast<std::size_t>(i)];
        for (std::int32_t j = shape_->first(i); j < i; ++j) x[static_cast<std::size_t>(j)] -= entry[j] * xi;
    }
}

}  // namespace percuss
