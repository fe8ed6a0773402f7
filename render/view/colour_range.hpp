#pragma once

#include <array>
#include <vector>

#include "run/fields.hpp"

namespace percuss::render {

/// What the colours of one picture span, in scene units. low == high: the field is constant.
using ColourRange = std::array<double, 2>;

/// The asked range, else the least and greatest value of the frame; symmetric about zero when `diverging`.
/// Values that are rounding noise beside `natural_size` count as a constant field, which would else show as a
/// rainbow.
[[nodiscard]] ColourRange colour_range(const std::vector<double>& values, const ViewOptions& options,
                                       bool diverging, double natural_size);

/// A size that the field has in any run of this scene: stiffness, speed, length. 0 when unknown.
[[nodiscard]] double natural_size(const RunSetup& setup, const FieldInfo& field);

}  // namespace percuss::render
