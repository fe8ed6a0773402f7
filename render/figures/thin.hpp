#pragma once

#include <span>
#include <vector>

namespace percuss::render {

/// A curve as it will be drawn.
struct Polyline2 {
    std::vector<double> x, y;
};

/// Thins a curve with ascending x to at most four points in each of `columns` equal parts of [low, high]:
/// first, least, greatest and last, in their order, so that spikes and chatter keep their full height. Curves
/// that are short enough, or whose x falls somewhere, stay as they are. Points that are not finite are left
/// out.
[[nodiscard]] Polyline2 thin(std::span<const double> x, std::span<const double> y, double low, double high,
                             int columns);

}  // namespace percuss::render
