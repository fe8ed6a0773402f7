#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "context/context.hpp"
#include "image.hpp"

namespace percuss::render {

/// One curve of a chart on paper.
struct Curve {
    std::string label;  ///< legend text; "" keeps it out of the legend
    std::vector<double> x, y;
    bool exact = false;  ///< drawn as a reference: dashed, dark grey
    bool dashed = false;
    std::optional<std::size_t> colour{};  ///< index into the palette; absent: its place among those not exact
};

/// One chart: axes with title and unit, curves, legend.
struct Chart {
    std::string title;
    std::string x_title, y_title;  ///< with unit, e.g. "time [µs]"
    std::vector<Curve> curves;
    std::optional<std::array<double, 2>> x_range, y_range;
};

/// A page of charts in one column or a grid, to be printed: white ground, dark ink, lines safe for colour
/// blindness.
struct Figure {
    std::string title;
    std::vector<Chart> charts;
    int columns = 1;
    int width = 1600, height = 1000;  ///< pixels
};

/// Draws with VTK's charts; curves longer than the plot is wide are thinned by minimum and maximum per pixel
/// column.
[[nodiscard]] Image draw_figure(Context& context, const Figure& figure);

}  // namespace percuss::render
