#include "run/history.hpp"

#include <algorithm>
#include <cassert>
#include <stdexcept>

#include "nearest_name.hpp"

namespace percuss {

History::History(std::vector<HistoryColumn> columns) : columns_(std::move(columns)) {
    if (columns_.empty()) throw std::invalid_argument("a history needs at least one column");
}

std::size_t History::column(std::string_view name) const {
    const auto found = std::find_if(columns_.begin(), columns_.end(),
                                    [&](const HistoryColumn& column) { return column.name == name; });
    if (found != columns_.end()) return static_cast<std::size_t>(found - columns_.begin());
    std::vector<std::string> names;
    for (const HistoryColumn& column : columns_) names.push_back(column.name);
    throw std::invalid_argument("no history column '" + std::string(name) + "'" + suggest_name(name, names));
}

void History::append(std::span<const double> values) {
    assert(values.size() == columns_.size());
    const std::size_t index = rows_.load(std::memory_order_relaxed);
    if (index % block_rows == 0) {
        Block block(new double[block_rows * columns_.size()]);
        const std::lock_guard lock(blocks_mutex_);
        blocks_.push_back(std::move(block));
    }
    // Only this thread changes the list, so it may read the list without the lock.
    double* place = blocks_.back().get() + (index % block_rows) * columns_.size();
    std::copy(values.begin(), values.end(), place);
    rows_.store(index + 1, std::memory_order_release);  // now readers may touch the row
}

std::shared_ptr<History> History::first(std::size_t rows) const {
    assert(rows <= this->rows());
    auto history = std::make_shared<History>(columns_);
    const std::size_t full = rows / block_rows, left = rows % block_rows * columns_.size();
    // Only this thread changes the lists, so it may read this one without the lock.
    history->blocks_.assign(blocks_.begin(), blocks_.begin() + static_cast<std::ptrdiff_t>(full));
    if (left > 0) {
        Block block(new double[block_rows * columns_.size()]);
        std::copy_n(blocks_[full].get(), left, block.get());
        history->blocks_.push_back(std::move(block));
    }
    history->rows_.store(rows, std::memory_order_release);
    return history;
}

const double* History::row(std::size_t index) const {
    const std::lock_guard lock(blocks_mutex_);
    return blocks_[index / block_rows].get() + (index % block_rows) * columns_.size();
}

std::vector<double> History::values(std::size_t column, std::size_t begin, std::size_t end) const {
    assert(column < columns_.size() && begin <= end && end <= rows());
    std::vector<double> result;
    result.reserve(end - begin);
    while (begin < end) {
        const std::size_t block_end = std::min(end, (begin / block_rows + 1) * block_rows);
        const double* number = row(begin) + column;
        for (; begin < block_end; ++begin, number += columns_.size()) result.push_back(*number);
    }
    return result;
}

std::vector<double> History::values(std::string_view name) const {
    const std::size_t index = column(name);
    return values(index, 0, rows());
}

std::vector<double> History::table(std::size_t begin, std::size_t end) const {
    assert(begin <= end && end <= rows());
    std::vector<double> result;
    result.reserve((end - begin) * columns_.size());
    while (begin < end) {
        const std::size_t block_end = std::min(end, (begin / block_rows + 1) * block_rows);
        const double* first = row(begin);
        result.insert(result.end(), first, first + (block_end - begin) * columns_.size());
        begin = block_end;
    }
    return result;
}

}  // namespace percuss
