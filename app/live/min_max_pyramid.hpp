#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace percuss::app {

struct MinMax {
    double low = 0, high = 0;
};

/// A growing row of numbers that tells the least and greatest of any part of it in time of its logarithm, so
/// that a plot of millions of steps keeps every spike and costs only what is seen.
///
/// Within a bound, the oldest numbers are dropped when the least and greatest of their group are known, and
/// those of groups likewise: what is old is known less finely, but no spike is lost.
class MinMaxPyramid {
  public:
    /// @param bound numbers kept at least, and as many groups of each size; at most twice as many are.
    explicit MinMaxPyramid(std::size_t bound = std::size_t{1} << 17) : bound_(std::max(bound, factor)) {}
    void append(std::span<const double> values);
    [[nodiscard]] std::size_t size() const { return lost_ + values_.size(); }
    /// Numbers before this one are known as parts of groups only.
    [[nodiscard]] std::size_t thinned() const { return lost_; }
    /// In a group its least to greatest, evenly: right for what ascends.
    [[nodiscard]] double operator[](std::size_t index) const {
        return index < lost_ ? within_group(index) : values_[index - lost_];
    }
    /// Of [begin, end), which must not be empty; of whole groups where only those are known. Numbers that are
    /// not finite are passed over: low > high when all are.
    [[nodiscard]] MinMax range(std::size_t begin, std::size_t end) const;

  private:
    static constexpr std::size_t factor = 16;  // numbers of one level that one of the next stands for
    struct Level {                             // of whole groups only
        std::vector<MinMax> groups;
        std::size_t lost = 0;  // dropped from the front
        [[nodiscard]] std::size_t size() const { return lost + groups.size(); }
    };
    /// On level 0 the numbers themselves, on level k groups of factor^k, counted in those.
    [[nodiscard]] MinMax range_on(std::size_t level, std::size_t begin, std::size_t end) const;
    [[nodiscard]] MinMax kept_on(std::size_t level, std::size_t begin, std::size_t end) const;
    [[nodiscard]] double within_group(std::size_t index) const;

    std::size_t bound_;
    std::vector<double> values_;
    std::size_t lost_ = 0;
    std::vector<Level> levels_;  // levels_[k - 1] is level k
};

}  // namespace percuss::app
