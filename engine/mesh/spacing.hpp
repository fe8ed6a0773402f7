#pragma once

#include <limits>
#include <optional>
#include <vector>

namespace percuss {

/// How one stretch of a block side is cut into cells of given sizes [length].
struct Spacing {
    std::optional<double> length{};  ///< of the stretch; absent: the rest of the side
    std::vector<double> sizes{};     ///< of all cells; or, when empty:
    double first = 0;                ///< size of the first cell,
    double ratio = 1;                ///< growth from cell to cell,
    double largest = std::numeric_limits<double>::infinity();  ///< and where it ends
    bool from_end = false;  ///< `first` is the last cell, and cells grow backwards
};

/// Sizes of the cells of one stretch, scaled so that they fill `length`. The number of growing cells is the
/// one whose unscaled sum comes nearest. @throws std::invalid_argument for more than a million cells.
[[nodiscard]] std::vector<double> cell_sizes(const Spacing& spacing, double length);

/// Where the cells of all stretches end, as fractions of the side, from 0 to 1.
/// @throws std::invalid_argument when the stretches do not add up to the side.
[[nodiscard]] std::vector<double> spaced_fractions(const std::vector<Spacing>& stretches, double length);

}  // namespace percuss
