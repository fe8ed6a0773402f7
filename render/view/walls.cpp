#include "view/walls.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace percuss::render {
namespace {

using Point = std::array<double, 2>;

/// The part of a line through `at` along `along` that lies in the rectangle (Liang & Barsky), as distances
/// from `at`.
std::optional<std::array<double, 2>> inside(const Rect& area, const Point& at, const Point& along,
                                            std::array<double, 2> part) {
    const std::array<double, 2> low{area.x, area.y}, high{area.right(), area.top()};
    for (std::size_t d = 0; d < 2; ++d) {
        if (std::abs(along[d]) < 1e-12) {
            if (at[d] < low[d] || at[d] > high[d]) return std::nullopt;
            continue;
        }
        const double a = (low[d] - at[d]) / along[d], b = (high[d] - at[d]) / along[d];
        part[0] = std::max(part[0], std::min(a, b));
        part[1] = std::min(part[1], std::max(a, b));
    }
    if (part[0] >= part[1]) return std::nullopt;
    return part;
}

void paint_wall(Canvas& canvas, Point at, const Point& normal, const Rect& area, double scale) {
    const Point along{-normal[1], normal[0]};
    const double reach = 4 * (area.width + area.height) + std::hypot(at[0] - area.x, at[1] - area.y);
    const auto shown = inside(area, at, along, {-reach, reach});
    if (!shown) return;
    const auto point = [&](double distance) -> Point {
        return {at[0] + distance * along[0], at[1] + distance * along[1]};
    };
    const double pitch = 9 * scale, length = 12 * scale;
    const Point hatch{-0.707 * normal[0] - 0.707 * along[0], -0.707 * normal[1] - 0.707 * along[1]};
    // Hatches stand at multiples of the pitch from the wall's point, so that they rest while the window moves
    // over them.
    for (double s = std::ceil((*shown)[0] / pitch) * pitch; s < (*shown)[1]; s += pitch) {
        const Point from = point(s);
        const auto part = inside(area, from, hatch, {0, length});
        if (part)
            canvas.line(from[0], from[1], from[0] + (*part)[1] * hatch[0], from[1] + (*part)[1] * hatch[1],
                        ink::soft, scale);
    }
    const Point a = point((*shown)[0]), b = point((*shown)[1]);
    canvas.line(a[0], a[1], b[0], b[1], ink::text, 2.4 * scale);
}

}  // namespace

void paint_walls(Canvas& canvas, const std::vector<Wall>& walls, const Plane& plane, const Fit& fit,
                 const Rect& area, double scale) {
    for (const Wall& wall : walls) {
        Point at = plane(wall.point.x(), wall.point.y()), normal = plane(wall.normal.x(), wall.normal.y());
        paint_wall(canvas, fit(at), normal, area, scale);
        const std::size_t across = plane.mirror_axis();
        if (!plane.mirrored || (normal[across] == 0)) continue;  // its mirror image is itself
        at[across] *= -1;
        normal[across] *= -1;
        paint_wall(canvas, fit(at), normal, area, scale);
    }
}

}  // namespace percuss::render
