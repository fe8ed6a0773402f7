#pragma once

#include <algorithm>
#include <cstdint>
#include <random>
#include <vector>

#include <Eigen/Dense>

#include "contact/solvers/profile_cholesky.hpp"

namespace percuss::testing {

using Dense = Eigen::MatrixXd;

class Rng {
  public:
    explicit Rng(unsigned seed) : engine_(seed) {}
    double uniform(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(engine_);
    }
    int index(int below) { return std::uniform_int_distribution<int>(0, below - 1)(engine_); }
    std::vector<double> vector(int n, double low, double high) {
        std::vector<double> values(static_cast<std::size_t>(n));
        for (double& value : values) value = uniform(low, high);
        return values;
    }

  private:
    std::mt19937_64 engine_;
};

inline Dense dense(const ProfileMatrix& matrix) {
    Dense a = Dense::Zero(matrix.rows(), matrix.rows());
    for (std::int32_t row = 0; row < matrix.rows(); ++row)
        for (std::int32_t column = matrix.first(row); column <= row; ++column)
            a(row, column) = a(column, row) = matrix.at(row, column);
    return a;
}

/// Lower triangle of a dense matrix; each row from its first nonzero.
inline ProfileMatrix profile(const Dense& a) {
    ProfileMatrix matrix;
    for (std::int32_t row = 0; row < a.rows(); ++row) {
        std::int32_t first = 0;
        while (first < row && a(row, first) == 0) ++first;
        matrix.append_row(first);
        for (std::int32_t column = first; column <= row; ++column) matrix.at(row, column) = a(row, column);
    }
    return matrix;
}

/// G G^T with rows of G that overlap over `band`, some further back: positive definite with an uneven
/// profile.
inline ProfileMatrix random_profile(Rng& random, int n, int band) {
    Dense g = Dense::Zero(n, n + band);
    for (int row = 0; row < n; ++row) {
        for (int k = 0; k <= band; ++k) g(row, row + k) = random.uniform(-1, 1);
        g(row, row) += 2;
        if (random.uniform(0, 1) < 0.2) g(row, random.index(n)) += 0.5;
    }
    return profile(Dense(g * g.transpose()));
}

}  // namespace percuss::testing
