#include "view/ground.hpp"

#include <algorithm>
#include <utility>

#include "view/walls.hpp"

namespace percuss::render {

void paint_ground(Canvas& canvas, const Scene& scene, const Plane& plane, const Fit& fit, const Rect& area,
                  double scale) {
    paint_walls(canvas, scene.walls, plane, fit, area, scale);
    if (scene.geometry != Geometry::axisymmetric) return;
    const std::size_t across = plane.mirror_axis();
    const double s = scale, at = fit.offset[across];
    const double begin = across == 0 ? area.y : area.x, end = across == 0 ? area.top() : area.right();
    if (at < (across == 0 ? area.x : area.y) || at > (across == 0 ? area.right() : area.top())) return;
    // Long and short dashes.
    for (double from = begin; from < end; from += 26 * s)
        for (const auto& [start, length] : {std::pair{0.0, 16.0}, std::pair{20.0, 2.0}}) {
            const double a = from + start * s, b = std::min(a + length * s, end);
            if (a < b && across == 0) canvas.line(at, a, at, b, ink::line, s);
            if (a < b && across == 1) canvas.line(a, at, b, at, ink::line, s);
        }
}

}  // namespace percuss::render
