#include "canvas.hpp"

#include <algorithm>
#include <cmath>

namespace percuss::render {

void Canvas::arrow(double x, double y, double dx, double dy, Colour colour, double thickness) {
    const double length = std::hypot(dx, dy);
    if (!(length > 0)) return;
    const double ux = dx / length, uy = dy / length;
    const double head = std::min(4.2 * thickness, 0.6 * length);
    const double half_head = 0.4 * head, half_shaft = 0.5 * std::min(thickness, 0.5 * head);
    const double neck = length - head;
    // Along the arrow and across it, anticlockwise from the tail.
    std::array<std::array<double, 2>, 7> outline{{{0, -half_shaft},
                                                  {neck, -half_shaft},
                                                  {neck, -half_head},
                                                  {length, 0},
                                                  {neck, half_head},
                                                  {neck, half_shaft},
                                                  {0, half_shaft}}};
    for (auto& [along, across] : outline) {
        const double a = along, c = across;
        along = x + a * ux - c * uy;
        across = y + a * uy + c * ux;
    }
    fill_arrow(outline, colour);
}

}  // namespace percuss::render
