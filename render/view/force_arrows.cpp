#include "view/force_arrows.hpp"

#include <algorithm>
#include <cmath>

#include "view/legend.hpp"

namespace percuss::render {

std::vector<Rect> paint_force_arrows(Canvas& canvas, const Snapshot& snapshot, const Plane& plane,
                                     const Fit& fit, const Rect& area, const ForceScaling& forces,
                                     double cell_size, double scale) {
    std::vector<Rect> covered;
    const int halves = plane.mirrored ? 2 : 1;
    // Arrows of neighbouring nodes stay apart.
    const double thickness = std::clamp(0.32 * cell_size, scale, 2.4 * scale);
    // Slave forces first: where both are drawn, the master's are on top.
    for (const bool master : {false, true})
        for (const ContactForce& contact : snapshot.contact_forces) {
            if (contact.master != master) continue;
            const double force = std::hypot(contact.force[0], contact.force[1]);
            const double length = forces.length(force);
            if (length < 5 * scale) continue;
            const auto node = 2 * static_cast<std::size_t>(contact.node);
            auto place = plane(snapshot.position[node], snapshot.position[node + 1]);
            auto direction = plane(contact.force[0] / force, contact.force[1] / force);
            for (int half = 0; half < halves; ++half) {
                if (half == 1) {
                    place[plane.mirror_axis()] *= -1;
                    direction[plane.mirror_axis()] *= -1;
                }
                const auto [x, y] = fit(place);
                if (!area.contains({x, y, 0, 0})) continue;
                const double dx = length * direction[0], dy = length * direction[1];
                canvas.arrow(x, y, dx, dy, master ? master_force_colour : slave_force_colour, thickness);
                covered.push_back({std::min(x, x + dx), std::min(y, y + dy), std::abs(dx), std::abs(dy)});
            }
        }
    return covered;
}

}  // namespace percuss::render
