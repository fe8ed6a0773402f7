#include "view/outline.hpp"

#include <algorithm>
#include <cmath>

namespace percuss::render {

void paint_outline(Canvas& canvas, const Snapshot& snapshot, const Plane& plane, const Fit& fit, const Rect& area,
                   Colour colour, double width) {
    const auto place = [&](std::int32_t node, bool image) {
        const auto at = 2 * static_cast<std::size_t>(node);
        auto point = plane(snapshot.position[at], snapshot.position[at + 1]);
        if (image) point[plane.mirror_axis()] *= -1;
        return fit(point);
    };
    const auto on_axis = [&](std::int32_t node) { return snapshot.position[2 * static_cast<std::size_t>(node)] <= 0; };
    for (const MeshBody& body : snapshot.setup->mesh.bodies)
        for (const Edge& edge : body.outlines)
            for (std::size_t i = 0; i + (edge.closed ? 0 : 1) < edge.nodes.size(); ++i) {
                const std::int32_t a = edge.nodes[i], b = edge.nodes[(i + 1) % edge.nodes.size()];
                if (plane.mirrored && on_axis(a) && on_axis(b)) continue;  // where the images meet
                for (int half = 0; half < (plane.mirrored ? 2 : 1); ++half) {
                    const auto p = place(a, half == 1), q = place(b, half == 1);
                    const Rect box{std::min(p[0], q[0]), std::min(p[1], q[1]), std::abs(p[0] - q[0]),
                                   std::abs(p[1] - q[1])};
                    const bool beside = box.x > area.right() || box.right() < area.x || box.y > area.top() ||
                                        box.top() < area.y;
                    if (!beside) canvas.line(p[0], p[1], q[0], q[1], colour, width);
                }
            }
}

}  // namespace percuss::render
