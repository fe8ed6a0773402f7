#pragma once

#include <span>
#include <vector>

namespace percuss {

/// Means of a history over centred windows of `window`, cut at the ends of the history; one a sample. Each
/// value counts for the time from half way to its left neighbour to half way to its right one, so that
/// impulses are kept.
/// @param times ascending, as many as values. @param window 0: the values as they are [as times]
[[nodiscard]] std::vector<double> moving_average(std::span<const double> times,
                                                 std::span<const double> values, double window);

/// Mean over the samples of [from, to], weighted by their times as above; 0 when there is none.
[[nodiscard]] double mean_between(std::span<const double> times, std::span<const double> values, double from,
                                  double to);

/// Index of the value of largest magnitude, the first of equals; 0 when there is none.
[[nodiscard]] std::size_t largest_magnitude(std::span<const double> values);

}  // namespace percuss
