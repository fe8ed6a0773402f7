#include "view/contact_sides.hpp"

#include <algorithm>
#include <cmath>

#include "contact/surface.hpp"
#include "view/legend.hpp"

namespace percuss::render {
namespace {

using Point = std::array<double, 2>;

/// Mean distance of neighbours along the chain [pixels].
double spacing(const std::vector<Point>& places) {
    double sum = 0;
    for (std::size_t i = 1; i < places.size(); ++i)
        sum += std::hypot(places[i][0] - places[i - 1][0], places[i][1] - places[i - 1][1]);
    return places.size() > 1 ? sum / static_cast<double>(places.size() - 1) : 100;
}

/// Cuts a line down to what lies inside (Liang & Barsky). @returns false when nothing does.
bool clip(Point& p, Point& q, const Rect& area) {
    const Point from = p, along{q[0] - p[0], q[1] - p[1]};
    const Point low{area.x, area.y}, high{area.right(), area.top()};
    double begin = 0, end = 1;
    for (std::size_t k = 0; k < 2; ++k) {
        if (along[k] == 0) {
            if (from[k] < low[k] || from[k] > high[k]) return false;
            continue;
        }
        const double a = (low[k] - from[k]) / along[k], b = (high[k] - from[k]) / along[k];
        begin = std::max(begin, std::min(a, b));
        end = std::min(end, std::max(a, b));
    }
    if (begin > end) return false;
    for (std::size_t k = 0; k < 2; ++k) {
        p[k] = from[k] + begin * along[k];
        q[k] = from[k] + end * along[k];
    }
    return true;
}

}  // namespace

std::vector<ContactSides> contact_sides(const RunSetup& setup) {
    std::vector<ContactSides> all;
    for (const ContactPair& pair : setup.scene.contacts) {
        ContactSides sides{make_surface(setup.mesh, pair.master).nodes, {}};
        for (const Side& side : make_surface(setup.mesh, pair.slave).sides)
            sides.slave_sides.push_back({side.i, side.j});
        all.push_back(std::move(sides));
    }
    return all;
}

void paint_contact_sides(Canvas& canvas, const Snapshot& snapshot, const ContactSides& sides,
                         const Plane& plane, const Fit& fit, const Rect& area, double scale) {
    for (int half = 0; half < (plane.mirrored ? 2 : 1); ++half) {
        const auto place = [&](std::int32_t node) {
            const auto at = 2 * static_cast<std::size_t>(node);
            auto point = plane(snapshot.position[at], snapshot.position[at + 1]);
            if (half == 1) point[plane.mirror_axis()] *= -1;
            return fit(point);
        };
        for (const auto& [i, j] : sides.slave_sides) {
            Point p = place(i), q = place(j);
            if (!clip(p, q, area)) continue;
            canvas.line(p[0], p[1], q[0], q[1], slave_force_colour, 3.5 * scale);
        }
        std::vector<Point> places;
        for (const std::int32_t node : sides.masters) places.push_back(place(node));
        // Discs of neighbours stay apart where the picture is large enough for that.
        const double radius = std::clamp(0.3 * spacing(places), 1.1 * scale, 3.2 * scale);
        double last_x = -1e30, last_y = -1e30;
        for (const auto& [x, y] : places) {
            // Nodes closer than a pixel look like one.
            if (!area.contains({x, y, 0, 0}) || std::hypot(x - last_x, y - last_y) < 1) continue;
            last_x = x, last_y = y;
            canvas.disc(x, y, radius, master_force_colour);
        }
    }
}

}  // namespace percuss::render
