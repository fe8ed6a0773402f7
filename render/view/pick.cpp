#include "view/pick.hpp"

#include <cmath>
#include <limits>

namespace percuss::render {
namespace {

using Point = std::array<double, 2>;

Point position(const Snapshot& snapshot, std::int32_t node) {
    const auto at = 2 * static_cast<std::size_t>(node);
    return {snapshot.position[at], snapshot.position[at + 1]};
}

/// By the crossing number, so that cells may be turned either way round.
bool inside(const Snapshot& snapshot, const Cell& cell, const Point& p) {
    const auto corners = static_cast<std::size_t>(corner_count(cell));
    bool odd = false;
    for (std::size_t i = 0, j = corners - 1; i < corners; j = i++) {
        const Point a = position(snapshot, cell[i]), b = position(snapshot, cell[j]);
        if ((a[1] > p[1]) != (b[1] > p[1]) && p[0] < (b[0] - a[0]) * (p[1] - a[1]) / (b[1] - a[1]) + a[0])
            odd = !odd;
    }
    return odd;
}

}  // namespace

Picked pick(const Snapshot& snapshot, const Plane& plane, std::array<double, 2> point) {
    const Mesh& mesh = snapshot.setup->mesh;
    // Exchanging the coordinates twice gives them back, so the plane is its own inverse.
    Point model = plane(point[0], point[1]);
    if (plane.mirrored) model[0] = std::abs(model[0]);
    for (std::size_t b = 0; b < mesh.bodies.size(); ++b)
        for (std::int32_t c = mesh.bodies[b].cell_begin; c < mesh.bodies[b].cell_end; ++c) {
            const Cell& cell = mesh.cells[static_cast<std::size_t>(c)];
            if (!inside(snapshot, cell, model)) continue;
            Picked picked{static_cast<std::int32_t>(b), c, -1};
            double nearest = std::numeric_limits<double>::infinity();
            for (std::size_t k = 0; k < static_cast<std::size_t>(corner_count(cell)); ++k) {
                const Point at = position(snapshot, cell[k]);
                const double away = std::hypot(at[0] - model[0], at[1] - model[1]);
                if (away < nearest) nearest = away, picked.node = cell[k];
            }
            return picked;
        }
    return {};
}

}  // namespace percuss::render
