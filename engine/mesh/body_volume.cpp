#include "mesh/body_volume.hpp"

#include <numbers>

namespace percuss {

double body_volume(const Mesh& mesh, const MeshBody& body, Geometry geometry, double thickness) {
    double area = 0, moment = 0;  // int dA, int r dA, as sums over the sides (Green's theorem)
    for (std::int32_t c = body.cell_begin; c < body.cell_end; ++c) {
        const Cell& cell = mesh.cells[static_cast<std::size_t>(c)];
        const int corners = corner_count(cell);
        for (int i = 0; i < corners; ++i) {
            const auto node = [&](int k) -> const Vec2& {
                return mesh.nodes[static_cast<std::size_t>(cell[static_cast<std::size_t>(k % corners)])];
            };
            const Vec2 &a = node(i), &b = node(i + 1);
            const double cross = a.x() * b.y() - b.x() * a.y();
            area += cross / 2;
            moment += (a.x() + b.x()) * cross / 6;
        }
    }
    return geometry == Geometry::axisymmetric ? 2 * std::numbers::pi * moment : thickness * area;
}

}  // namespace percuss
