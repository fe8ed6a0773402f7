#pragma once

#include <vector>

#include "scene/scene.hpp"

namespace percuss {

/// n + 1 fractions from 0 to 1 of which each interval is q times the one before, the last `ratio` times the
/// first.
[[nodiscard]] std::vector<double> graded_fractions(int n, double ratio);

/// Points of a block side from `from` to `to` at the given fractions of its length, of a formula of the range
/// of its variable; both ends are met exactly.
/// @throws std::invalid_argument for an arc whose three points lie on a line, a polyline with a zero-length
/// part; FormulaError where a formula has no value or does not meet the ends.
[[nodiscard]] std::vector<Vec2> points_along(const EdgeShape& shape, const Vec2& from, const Vec2& to,
                                             const std::vector<double>& fractions);

/// Length of a block side; of formulas that of 1000 chords. @throws as points_along
[[nodiscard]] double side_length(const EdgeShape& shape, const Vec2& from, const Vec2& to);

}  // namespace percuss
