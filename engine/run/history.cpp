#include "run/history.hpp"

#include <algorithm>
#include <cassert>
#include <stdexcept>

#include "nearest_name.hpp"

namespace percuss {

History::History(std::vector<HistoryColumn> columns, std::size_t memory)
    : columns_(std::move(columns)), memory_(memory) {
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
        thin();
        Block block{std::shared_ptr<double[]>(new double[block_rows * columns_.size()])};
        const std::lock_guard lock(blocks_mutex_);
        blocks_.push_back(std::move(block));
    }
    // Only this thread changes the list, so it may read the list without the lock.
    double* place = blocks_.back().numbers.get() + (index % block_rows) * columns_.size();
    std::copy(values.begin(), values.end(), place);
    rows_.store(index + 1, std::memory_order_release);  // now readers may touch the row
}

std::shared_ptr<History> History::first(std::size_t rows) const {
    assert(rows <= this->rows());
    auto history = std::make_shared<History>(columns_, memory_);
    const std::size_t full = rows / block_rows, left = rows % block_rows * columns_.size();
    // Only this thread changes the lists, so it may read this one without the lock.
    history->blocks_.assign(blocks_.begin(), blocks_.begin() + static_cast<std::ptrdiff_t>(full));
    if (left > 0) {
        Block block{std::shared_ptr<double[]>(new double[block_rows * columns_.size()])};
        const std::vector<double> last = table(full * block_rows, rows);
        std::copy(last.begin(), last.end(), block.numbers.get());
        history->blocks_.push_back(std::move(block));
    }
    history->thinned_rows_ = std::min(thinned_rows_, rows);
    history->rows_.store(rows, std::memory_order_release);
    return history;
}

/// Half of the memory is for rows as they were, half of the rest for each coarser kind. The oldest of each
/// kind goes over to the next.
void History::thin() {
    if (memory_ == 0) return;
    for (std::size_t k = 0; k + 1 < grains.size(); ++k) {
        const std::size_t size =
            8 * columns_.size() * (grains[k] == 1 ? block_rows : 2 * block_rows / grains[k]);
        const std::size_t most = std::max<std::size_t>((memory_ >> (k + 1)) / size, 1);
        // Only this thread changes the list, so it may read it without the lock. Coarser blocks come first;
        // the rest of a branch's last one may be finer than those after it.
        const auto of_kind = [&](const Block& block) { return block.grain == grains[k]; };
        auto count = static_cast<std::size_t>(std::count_if(blocks_.begin(), blocks_.end(), of_kind));
        for (; count > most; --count) {
            const auto oldest = std::find_if(blocks_.begin(), blocks_.end(), of_kind);
            Block coarse = thinned(*oldest, grains[k + 1]);
            const std::lock_guard lock(blocks_mutex_);
            *oldest = std::move(coarse);
            thinned_rows_ =
                std::max(thinned_rows_, block_rows * static_cast<std::size_t>(oldest - blocks_.begin() + 1));
        }
    }
}

History::Block History::thinned(const Block& block, std::size_t grain) const {
    const std::size_t width = columns_.size();
    Block coarse{std::shared_ptr<double[]>(new double[2 * block_rows / grain * width]), grain};
    const std::size_t rows = block.grain == 1 ? grain : 2 * grain / block.grain;  // of a group, as stored
    for (std::size_t group = 0; group < block_rows / grain; ++group) {
        const double* from = block.numbers.get() + group * rows * width;
        double* least = coarse.numbers.get() + 2 * group * width;
        double* greatest = least + width;
        std::copy_n(from, width, least);
        std::copy_n(from, width, greatest);
        for (std::size_t row = 1; row < rows; ++row)
            for (std::size_t column = 0; column < width; ++column) {
                const double value = from[row * width + column];
                least[column] = std::min(least[column], value);
                greatest[column] = std::max(greatest[column], value);
            }
    }
    return coarse;
}

History::Block History::block_of(std::size_t row) const {
    const std::lock_guard lock(blocks_mutex_);
    return blocks_[row / block_rows];
}

double History::number(const Block& block, std::size_t row, std::size_t column) const {
    const std::size_t width = columns_.size(), place = row % block_rows;
    if (block.grain == 1) return block.numbers[place * width + column];
    const std::size_t within = place % block.grain;
    const double* least = block.numbers.get() + 2 * (place / block.grain) * width;
    const double low = least[column], high = least[width + column];
    if (column > 0) return within < block.grain / 2 ? low : high;
    return low + (high - low) * static_cast<double>(within) / static_cast<double>(block.grain - 1);
}

std::size_t History::thinned_rows() const {
    const std::lock_guard lock(blocks_mutex_);
    return thinned_rows_;
}

std::size_t History::grain(std::size_t row) const { return block_of(row).grain; }

std::vector<double> History::values(std::size_t column, std::size_t begin, std::size_t end) const {
    assert(column < columns_.size() && begin <= end && end <= rows());
    std::vector<double> result;
    result.reserve(end - begin);
    while (begin < end) {
        const std::size_t block_end = std::min(end, (begin / block_rows + 1) * block_rows);
        for (const Block block = block_of(begin); begin < block_end; ++begin)
            result.push_back(number(block, begin, column));
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
        for (const Block block = block_of(begin); begin < block_end; ++begin)
            for (std::size_t column = 0; column < columns_.size(); ++column)
                result.push_back(number(block, begin, column));
    }
    return result;
}

}  // namespace percuss
