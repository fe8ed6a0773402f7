#pragma once

#include <array>
#include <vector>

#include "canvas.hpp"

namespace percuss::render {

/// Where the parts of a picture go, in pixels. Nothing overlaps.
struct Layout {
    double scale = 1;  ///< of fonts and gaps: 1 at 1280 x 720
    Rect title;        ///< scene title to the left, time to the right
    Rect model;
    Rect legend;  ///< colour bar, reference arrow, scale bar
    std::vector<Rect> charts;
};

/// @param aspect width / height of the shown part of the model. Wide models have their charts below, others
/// beside.
[[nodiscard]] Layout make_layout(int width, int height, double aspect, std::size_t charts);

/// The place of the model in its rectangle: pixel = offset + pixels_per_unit * coordinate.
struct Fit {
    double pixels_per_unit = 1;
    std::array<double, 2> offset{0, 0};
    [[nodiscard]] std::array<double, 2> operator()(const std::array<double, 2>& point) const {
        return {offset[0] + pixels_per_unit * point[0], offset[1] + pixels_per_unit * point[1]};
    }
};

/// Fits `box` {left, low, right, high} into `rect`, centred, `margin` {sideways, up and down} pixels inside
/// it.
[[nodiscard]] Fit fit_box(const std::array<double, 4>& box, const Rect& rect,
                          const std::array<double, 2>& margin);

/// A box that grows only, so that the picture does not shake while bodies move.
[[nodiscard]] std::array<double, 4> grown(const std::array<double, 4>& box,
                                          const std::array<double, 4>& needed);

/// The first of the candidates that lies inside `area` and overlaps none of `taken`; when all do, the
/// candidate inside the area that overlaps the fewest. Index into `candidates`.
[[nodiscard]] std::size_t choose_place(const std::vector<Rect>& candidates, const Rect& area,
                                       const std::vector<Rect>& taken);

}  // namespace percuss::render
