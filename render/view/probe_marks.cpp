#include "view/probe_marks.hpp"

namespace percuss::render {

void paint_probe(Canvas& canvas, const std::array<double, 2>& place, const std::string& name, double scale,
                 bool strong) {
    const auto [x, y] = place;
    const double radius = (strong ? 6 : 4) * scale;
    const TextStyle style{13 * scale, ink::white, Align::left, VerticalAlign::centre, true};
    const auto [width, height] = canvas.text_size(name, style);
    const double left = x + radius + 4 * scale;
    canvas.disc(x, y, radius, probe_colour);
    canvas.rectangle({left, y - 0.5 * height - scale, width + 8 * scale, height + 2 * scale}, probe_colour,
                     0.85);
    canvas.text(left + 4 * scale, y, name, style);
}

void paint_follow_mark(Canvas& canvas, const std::array<double, 2>& place, double scale) {
    const auto [x, y] = place;
    const double from = 5 * scale, to = 12 * scale;
    for (const auto& [dx, dy] : {std::array{1.0, 0.0}, {-1.0, 0.0}, {0.0, 1.0}, {0.0, -1.0}})
        for (const auto& [colour, width] : {std::pair{Colour{ink::white}, 4.0}, {Colour{probe_colour}, 2.0}})
            canvas.line(x + from * dx, y + from * dy, x + to * dx, y + to * dy, colour, width * scale);
}

}  // namespace percuss::render
