#pragma once

#include <string>
#include <vector>

namespace percuss::render {

/// Round places of an axis or a colour bar.
struct Ticks {
    std::vector<double> values;       ///< ascending multiples of a step 1, 2 or 5 times a power of ten
    std::vector<std::string> labels;  ///< as many decimals as the step needs; true minus signs
};

/// About `wanted` ticks inside [low, high]; one tick when the range is empty.
[[nodiscard]] Ticks make_ticks(double low, double high, int wanted);

/// Ticks of a logarithmic axis, 0 < low < high: powers of ten, with 2 and 5 times those where they are few;
/// those of make_ticks where these are fewer than three.
[[nodiscard]] Ticks make_log_ticks(double low, double high, int wanted);

/// `value` with `digits` significant digits, without needless zeros: 38.2, 0.5, 1.2e-9.
[[nodiscard]] std::string format_number(double value, int digits = 3);

/// The largest of 1, 2, 5 times a power of ten that is <= `value`; `value` > 0.
[[nodiscard]] double round_below(double value);

}  // namespace percuss::render
