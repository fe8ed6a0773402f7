#pragma once

#include <array>
#include <string>

#include "canvas.hpp"

namespace percuss::render {

inline constexpr Colour probe_colour = 0x000000;

/// A probe: a disc at its place with its name on a plate beside it.
/// @param place [pixels] @param strong larger, for the one that is pointed at
void paint_probe(Canvas& canvas, const std::array<double, 2>& place, const std::string& name, double scale,
                 bool strong);

/// A cross of four strokes around a node that the picture follows.
void paint_follow_mark(Canvas& canvas, const std::array<double, 2>& place, double scale);

}  // namespace percuss::render
