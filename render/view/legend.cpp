#include "view/legend.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "figures/ticks.hpp"

namespace percuss::render {

vtkSmartPointer<vtkImageData> colour_strip(vtkLookupTable& table) {
    const auto size = static_cast<int>(table.GetNumberOfTableValues());
    auto strip = vtkSmartPointer<vtkImageData>::New();
    strip->SetDimensions(size, 1, 1);
    strip->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
    for (int i = 0; i < size; ++i) {
        auto* pixel = static_cast<unsigned char*>(strip->GetScalarPointer(i, 0, 0));
        const double* rgba = table.GetTableValue(i);
        for (int c = 0; c < 3; ++c) pixel[c] = static_cast<unsigned char>(std::lround(255 * rgba[c]));
    }
    return strip;
}

namespace {

/// Where two numbers alone would leave the ends of a short bar unsaid, as many as have room side by side.
Ticks bar_ticks(Canvas& canvas, double low, double high, double width, double scale) {
    const int wanted = std::max(2, static_cast<int>(width / (75 * scale)));
    Ticks ticks = make_ticks(low, high, wanted);
    for (int more = 6; more > wanted && ticks.values.size() < 3; --more) {
        Ticks closer = make_ticks(low, high, more);
        double room = width;
        for (const std::string& label : closer.labels)
            room -= canvas.text_size(label, {13 * scale})[0] + 8 * scale;
        if (room > 0) ticks = std::move(closer);
    }
    return ticks;
}

}  // namespace

void paint_colour_bar(Canvas& canvas, const Rect& rect, double scale, const std::string& title,
                      Quantity quantity, const ColourRange& range, const Units& units, vtkImageData* strip) {
    const DisplayUnit unit = units.display(quantity, std::max(std::abs(range[0]), std::abs(range[1])));
    const std::string heading = unit.label.empty() ? title : fmt::format("{} [{}]", title, unit.label);
    const Rect bar{rect.x, rect.y + 26 * scale, rect.width, 13 * scale};
    canvas.text(rect.x, bar.top() + 14 * scale, heading, {14 * scale});
    canvas.image(bar, strip);
    const double low = unit.scale * range[0], high = unit.scale * range[1];
    const Ticks ticks = bar_ticks(canvas, low, high, rect.width, scale);
    // A constant field is drawn in the middle colour.
    for (std::size_t i = 0; i < ticks.values.size(); ++i) {
        const double x =
            high > low ? bar.x + bar.width * (ticks.values[i] - low) / (high - low) : bar.x + 0.5 * bar.width;
        canvas.line(x, bar.y - 4 * scale, x, bar.y, ink::soft, 1);
        // A tick at the very end must not write into the picture's margin.
        const double half = 0.5 * canvas.text_size(ticks.labels[i], {13 * scale})[0];
        canvas.text(std::clamp(x, bar.x + half, bar.right() - half), bar.y - 13 * scale, ticks.labels[i],
                    {13 * scale, ink::text, Align::centre});
    }
}

void paint_force_legend(Canvas& canvas, const Rect& rect, double scale, const ForceScaling& forces,
                        const Units& units) {
    const double top = rect.y + 53 * scale, middle = rect.y + 32.5 * scale;
    const TextStyle plain{14 * scale};
    double x = rect.x;
    const auto word = [&](const std::string& text, Colour colour, bool bold) {
        TextStyle style = plain;
        style.colour = colour;
        style.bold = bold;
        canvas.text(x, top, text, style);
        x += canvas.text_size(text, style)[0];
    };
    word("contact force on ", ink::text, false);
    word("master", master_force_colour, true);
    word(", ", ink::text, false);
    word("slave", slave_force_colour, true);
    if (!(forces.reference > 0)) {
        canvas.text(rect.x, middle, "none now", {13 * scale, ink::soft});
        return;
    }
    canvas.arrow(rect.x, middle, forces.reference_length, 0, master_force_colour, 2.4 * scale);
    const DisplayUnit unit = units.display(Quantity::force, forces.reference);
    const std::string kind =
        forces.kind == ForceScale::logarithmic ? fmt::format(", log, {:.2g} decades", forces.decades()) : "";
    canvas.text(rect.x + forces.reference_length + 8 * scale, middle,
                fmt::format("{} {}{}", format_number(unit.scale * forces.reference), unit.label, kind),
                {13 * scale});
}

void paint_scale_bar(Canvas& canvas, double x, double y, double scale, double pixels_per_unit,
                     const Units& units) {
    const double length = round_below(100 * scale / pixels_per_unit);
    const double left = x - length * pixels_per_unit;
    const DisplayUnit unit = units.display(Quantity::length, length);
    for (const double end : {left, x})
        canvas.line(end, y - 4 * scale, end, y + 4 * scale, ink::soft, 1.5 * scale);
    canvas.line(left, y, x, y, ink::soft, 1.5 * scale);
    canvas.text(0.5 * (left + x), y + 13 * scale,
                fmt::format("{} {}", format_number(unit.scale * length), unit.label),
                {13 * scale, ink::text, Align::centre});
}

}  // namespace percuss::render
