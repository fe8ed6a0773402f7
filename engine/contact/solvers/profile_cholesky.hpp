#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace percuss {

/// Symmetric matrix stored by rows from each row's first nonzero column to the diagonal (profile, or
/// skyline). Rows of master nodes in chain order couple with near rows only, so the profile is the paper's
/// narrow band; a closed chain adds one long row instead of a full matrix.
class ProfileMatrix {
  public:
    /// Empties the matrix and keeps its memory.
    void clear();
    /// Room for so many rows and entries; a chain of master nodes makes a band of 4 entries a row.
    void reserve(std::size_t rows, std::size_t entries) {
        rows_.reserve(rows);
        values_.reserve(entries);
    }
    /// Appends row k = rows() with zeros from column `first` <= k to the diagonal.
    void append_row(std::int32_t first) {
        const std::int32_t begin = static_cast<std::int32_t>(values_.size());
        values_.resize(static_cast<std::size_t>(begin + rows() - first + 1), 0.0);
        rows_.push_back({first, begin - first});
    }
    [[nodiscard]] std::int32_t rows() const { return static_cast<std::int32_t>(rows_.size()); }
    [[nodiscard]] std::int32_t first(std::int32_t row) const {
        return rows_[static_cast<std::size_t>(row)].first;
    }
    /// Row k so that row(k)[column] is its entry, first(k) <= column <= k.
    [[nodiscard]] double* row(std::int32_t k) {
        return values_.data() + rows_[static_cast<std::size_t>(k)].origin;
    }
    [[nodiscard]] const double* row(std::int32_t k) const {
        return values_.data() + rows_[static_cast<std::size_t>(k)].origin;
    }
    /// Entry of the lower triangle, first(row) <= column <= row.
    [[nodiscard]] double& at(std::int32_t row_index, std::int32_t column) { return row(row_index)[column]; }
    [[nodiscard]] double at(std::int32_t row_index, std::int32_t column) const {
        return row(row_index)[column];
    }
    /// y = A x.
    void multiply(std::span<const double> x, std::span<double> y) const { multiply(x, y, 0, rows()); }
    /// The same for the diagonal block of rows begin to end, which no other row couples with; other y stay.
    void multiply(std::span<const double> x, std::span<double> y, std::int32_t begin, std::int32_t end) const;
    /// Where an entry of the lower triangle stands among values().
    [[nodiscard]] std::int32_t index(std::int32_t row_index, std::int32_t column) const {
        return rows_[static_cast<std::size_t>(row_index)].origin + column;
    }
    [[nodiscard]] std::span<double> values() { return values_; }
    [[nodiscard]] std::span<const double> values() const { return values_; }

  private:
    struct Row {
        std::int32_t first;
        std::int32_t origin;  ///< index in values_ of column 0, which need not be stored: may be negative
    };
    std::vector<Row> rows_;
    std::vector<double> values_;
};

/// Factors A = L D L^T, D positive but for rows with a negative diagonal, of the rows whose `active` is 1;
/// the others are left out as if they were not in the matrix. A row that depends on the rows before it (pivot
/// at most 1e-12 of its diagonal) is left out too and gets the answer 0.
class ProfileCholesky {
  public:
    /// Room for so many rows and entries of a matrix.
    void reserve(std::size_t rows, std::size_t entries) {
        factor_.reserve(entries);
        inverse_pivot_.reserve(rows);
    }
    /// @param matrix must stay as it is until the last solve.
    /// @returns number of dependent rows, not counting those whose diagonal is zero.
    int factorise(const ProfileMatrix& matrix, std::span<const char> active) {
        return factorise(matrix, active, 0, matrix.rows());
    }
    /// The same for the diagonal block of rows begin to end, which no other row couples with.
    int factorise(const ProfileMatrix& matrix, std::span<const char> active, std::int32_t begin,
                  std::int32_t end);
    /// Solves the block that was factorised in place; answers of its rows left out are 0.
    void solve(std::span<double> right_hand_side) const;
    /// Whether a row was active and independent.
    [[nodiscard]] bool used(std::int32_t row) const {
        return inverse_pivot_[static_cast<std::size_t>(row)] != 0;
    }

  private:
    [[nodiscard]] double* row(std::int32_t k) { return factor_.data() + shape_->index(k, 0); }
    [[nodiscard]] const double* row(std::int32_t k) const { return factor_.data() + shape_->index(k, 0); }

    const ProfileMatrix* shape_ = nullptr;
    std::int32_t begin_ = 0, end_ = 0;
    std::vector<double> factor_;         ///< in the places of the matrix
    std::vector<double> inverse_pivot_;  ///< 0 where the row is left out
};

}  // namespace percuss
