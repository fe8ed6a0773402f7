#pragma once

#include <string>

#include <vtkImageData.h>
#include <vtkLookupTable.h>

#include "canvas.hpp"
#include "units.hpp"
#include "view/colour_range.hpp"
#include "view/force_scale.hpp"
#include "view/layout.hpp"

namespace percuss::render {

inline constexpr Colour master_force_colour = 0xd1135b, slave_force_colour = 0xf08a24,
                        velocity_colour = 0x12324f;

/// A row of 256 pixels in the colours of the table.
[[nodiscard]] vtkSmartPointer<vtkImageData> colour_strip(vtkLookupTable& table);

/// Title with unit, coloured strip, ticks. @param rect the left part of the legend.
void paint_colour_bar(Canvas& canvas, const Rect& rect, double scale, const std::string& title,
                      Quantity quantity, const ColourRange& range, const Units& units, vtkImageData* strip);

/// The reference arrow with its value, and which colour is on which side.
void paint_force_legend(Canvas& canvas, const Rect& rect, double scale, const ForceScaling& forces,
                        const Units& units);

/// A bar of round length. @param x its right end.
void paint_scale_bar(Canvas& canvas, double x, double y, double scale, double pixels_per_unit,
                     const Units& units);

}  // namespace percuss::render
