#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace percuss::app {

struct MinMax {
    double low = 0, high = 0;
};

/// A growing row of numbers that tells the least and greatest of any part of it in time of its logarithm, so
/// that a plot of millions of steps keeps every spike and costs only what is seen.
class MinMaxPyramid {
  public:
    void append(std::span<const double> values);
    [[nodiscard]] std::size_t size() const { return values_.size(); }
    [[nodiscard]] double operator[](std::size_t index) const { return values_[index]; }
    /// Of [begin, end), which must not be empty. Numbers that are not finite are passed over: low > high when
    /// all are.
    [[nodiscard]] MinMax range(std::size_t begin, std::size_t end) const;

  private:
    static constexpr std::size_t factor = 16;  // numbers of one level that one of the next stands for
    std::vector<double> values_;
    std::vector<std::vector<MinMax>> levels_;  // of whole groups only
};

}  // namespace percuss::app
