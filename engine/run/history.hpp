#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "units.hpp"

namespace percuss {

struct HistoryColumn {
    std::string name;  ///< "time", "contact.PAIR.axial", "body.NAME.velocity.axial", "energy.kinetic", ...
    Quantity quantity = Quantity::dimensionless;
};

/// Full-rate histories: one row of numbers a step. One thread appends, any number of threads read the rows
/// that were complete when they asked; nobody waits for long (a lock is held only while a list of blocks is
/// touched).
class History {
  public:
    explicit History(std::vector<HistoryColumn> columns);

    [[nodiscard]] const std::vector<HistoryColumn>& columns() const { return columns_; }
    /// Index of a column. @throws std::invalid_argument naming the nearest valid name.
    [[nodiscard]] std::size_t column(std::string_view name) const;
    [[nodiscard]] std::size_t rows() const { return rows_.load(std::memory_order_acquire); }

    /// Appends one row; `values` has one number per column. Only the owner thread calls this.
    void append(std::span<const double> values);
    /// The first `rows` rows as a history of their own, to which other rows can be appended: full blocks are
    /// shared with this one, so it costs little. Only the owner thread calls this; readers of this one are
    /// not disturbed. rows <= this->rows().
    [[nodiscard]] std::shared_ptr<History> first(std::size_t rows) const;
    /// Rows [begin, end) of one column. end <= rows().
    [[nodiscard]] std::vector<double> values(std::size_t column, std::size_t begin, std::size_t end) const;
    [[nodiscard]] std::vector<double> values(std::string_view name) const;
    /// Rows [begin, end), row-major, columns().size() numbers each.
    [[nodiscard]] std::vector<double> table(std::size_t begin, std::size_t end) const;

  private:
    static constexpr std::size_t block_rows = 1024;
    using Block = std::shared_ptr<double[]>;  // shared only when full: its rows never change again
    [[nodiscard]] const double* row(std::size_t index) const;

    std::vector<HistoryColumn> columns_;
    std::atomic<std::size_t> rows_{0};
    mutable std::mutex blocks_mutex_;  // guards the list, not the numbers
    std::vector<Block> blocks_;
};

}  // namespace percuss
