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
///
/// Within a bound of memory the oldest rows are thinned: of each 16 rows, later 128, then 1024, the least and
/// the greatest number of each column stay, so that chatter keeps its height. Rows keep their numbers: those
/// of such a group read as the least in its first half and the greatest in its second, those of the first
/// column, which must ascend, as evenly spaced between its ends.
class History {
  public:
    /// @param memory of the rows, about [bytes]; 0: all are kept as they are. What was thinned to the utmost
    /// still grows, by a 512th of the whole.
    explicit History(std::vector<HistoryColumn> columns, std::size_t memory = 0);

    [[nodiscard]] const std::vector<HistoryColumn>& columns() const { return columns_; }
    /// Index of a column. @throws std::invalid_argument naming the nearest valid name.
    [[nodiscard]] std::size_t column(std::string_view name) const;
    [[nodiscard]] std::size_t rows() const { return rows_.load(std::memory_order_acquire); }

    /// The rows before this one are thinned.
    [[nodiscard]] std::size_t thinned_rows() const;
    /// How many rows, together with this one, are kept as their least and greatest; 1: it is as it was.
    [[nodiscard]] std::size_t grain(std::size_t row) const;

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
    static constexpr std::array<std::size_t, 4> grains{1, 16, 128, block_rows};
    struct Block {
        std::shared_ptr<double[]> numbers;  // shared only when full: its rows never change again
        std::size_t grain = 1;              // more: two rows for each so many, the least and the greatest
    };
    [[nodiscard]] Block block_of(std::size_t row) const;
    [[nodiscard]] double number(const Block& block, std::size_t row, std::size_t column) const;
    [[nodiscard]] Block thinned(const Block& block, std::size_t grain) const;
    void thin();

    std::vector<HistoryColumn> columns_;
    std::size_t memory_;
    std::atomic<std::size_t> rows_{0};
    mutable std::mutex blocks_mutex_;  // guards the list, not the numbers
    std::vector<Block> blocks_;
    std::size_t thinned_rows_ = 0;  // under the same mutex
};

}  // namespace percuss
