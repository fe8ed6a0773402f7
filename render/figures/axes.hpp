#pragma once

#include <array>
#include <string>
#include <vector>

#include "canvas.hpp"

namespace percuss::render {

/// A frame with ticks around an area that is painted by hand.
struct Axes {
    Rect area;  ///< pixels between the axes
    std::array<double, 2> x{0, 1}, y{0, 1};
    double scale = 1;  ///< of type and lines

    [[nodiscard]] double to_x(double value) const {
        return area.x + area.width * (value - x[0]) / (x[1] - x[0]);
    }
    [[nodiscard]] double to_y(double value) const {
        return area.y + area.height * (value - y[0]) / (y[1] - y[0]);
    }
};

/// The area that is left in `rect` for a heading of `heading` pixels, tick labels and titles of axes.
/// @param right room to the right of the area [pixels]
[[nodiscard]] Rect axes_area(const Rect& rect, double heading, double right, double scale);

/// Frame, ticks, labels, titles. @param grid draw faint lines through the area, before what is shown.
void paint_axes(Canvas& canvas, const Axes& axes, const Rect& rect, const std::string& x_title,
                const std::string& y_title);
void paint_grid(Canvas& canvas, const Axes& axes);

/// The title of a panel at the top of `rect`. @returns its height, 0 without title.
double paint_panel_title(Canvas& canvas, const Rect& rect, const std::string& title, double scale);
[[nodiscard]] double panel_title_height(const std::string& title, double scale);

/// Boxes with labels in rows below `top`, as wide as `rect`. @param paint false only measures. @returns their
/// height.
double paint_legend(Canvas& canvas, const Rect& rect, double top, const std::vector<std::string>& labels,
                    const std::vector<Colour>& colours, double scale, bool paint);

}  // namespace percuss::render
