#include "dynamics/loads.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/select.hpp"

namespace percuss {
namespace {

/// Integrals of the two linear shape functions over a side with weight r (ring, per radian) or 1.
std::array<double, 2> side_areas(double r_i, double r_j, double length, Geometry geometry) {
    if (geometry != Geometry::axisymmetric) return {length / 2, length / 2};
    return {length * (2 * r_i + r_j) / 6, length * (r_i + 2 * r_j) / 6};
}

template <class Visit>
void for_each_side(const Edge& edge, Visit visit) {
    const std::size_t count = edge.nodes.size();
    for (std::size_t k = 0; k + (edge.closed ? 0 : 1) < count; ++k)
        visit(edge.nodes[k], edge.nodes[(k + 1) % count]);
}

}  // namespace

Loads::Loads(const Scene& scene, const Mesh& mesh) : geometry_(scene.geometry) {
    for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
        const Body& body = scene.bodies[b];
        const MeshBody& part = mesh.bodies[b];
        bodies_.push_back({part.node_begin, part.node_end, body.body_force});
        any_body_force_ = any_body_force_ || body.body_force[0] != 0 || body.body_force[1] != 0;
        for (const EdgeLoad& load : body.loads) {
            LoadedEdge loaded{{}, load};
            for_each_side(*find_edge(part, load.edge), [&](std::int32_t i, std::int32_t j) {
                const Vec2 &a = mesh.nodes[static_cast<std::size_t>(i)],
                           &c = mesh.nodes[static_cast<std::size_t>(j)];
                loaded.sides.push_back({i, j, side_areas(a.x(), c.x(), (c - a).norm(), geometry_)});
            });
            edges_.push_back(std::move(loaded));
        }
    }
}

void Loads::mark_loaded(std::vector<char>& nodes) const {
    for (const Span& body : bodies_)
        if (body.acceleration[0] != 0 || body.acceleration[1] != 0)
            std::fill(nodes.begin() + body.begin, nodes.begin() + body.end, char{1});
    for (const LoadedEdge& edge : edges_)
        for (const LoadedSide& side : edge.sides)
            nodes[static_cast<std::size_t>(side.i)] = nodes[static_cast<std::size_t>(side.j)] = 1;
}

void Loads::evaluate(const Node* nodes, const std::vector<double>& mass, double time,
                     std::vector<double>& force) const {
    for (const Span& body : bodies_) {
        for (auto node = static_cast<std::size_t>(body.begin); node < static_cast<std::size_t>(body.end);
             ++node) {
            force[2 * node] = mass[node] * body.acceleration[0];
            force[2 * node + 1] = mass[node] * body.acceleration[1];
        }
    }
    for (const LoadedEdge& edge : edges_) {
        const double pressure = edge.load.pressure ? (*edge.load.pressure)(time) : 0;
        const std::array<double, 2> traction{edge.load.traction[0] ? (*edge.load.traction[0])(time) : 0,
                                             edge.load.traction[1] ? (*edge.load.traction[1])(time) : 0};
        for (const LoadedSide& side : edge.sides) {
            const double* a = nodes[side.i].x;
            const double* b = nodes[side.j].x;
            // The outward normal times the length is (dy, -dx); pressure pushes inward on the present side.
            const double normal[2] = {b[1] - a[1], -(b[0] - a[0])};
            const auto weight = side_areas(a[0], b[0], 1, geometry_);
            for (std::size_t d = 0; d < 2; ++d) {
                force[2 * static_cast<std::size_t>(side.i) + d] +=
                    traction[d] * side.area[0] - pressure * normal[d] * weight[0];
                force[2 * static_cast<std::size_t>(side.j) + d] +=
                    traction[d] * side.area[1] - pressure * normal[d] * weight[1];
            }
        }
    }
}

ImposedMotion impose_motion(const Scene& scene, const Mesh& mesh) {
    ImposedMotion motion;
    motion.held.assign(mesh.nodes.size(), {false, false});
    if (scene.geometry == Geometry::axisymmetric)
        for (std::size_t node = 0; node < mesh.nodes.size(); ++node)
            motion.held[node][0] = mesh.nodes[node].x() == 0;

    for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
        const MeshBody& part = mesh.bodies[b];
        for (const Constraint& constraint : scene.bodies[b].constraints) {
            for (const std::int32_t node : select_nodes(mesh, part, constraint.edge, constraint.box)) {
                for (std::size_t d = 0; d < 2; ++d)
                    if (constraint.fixed[d]) motion.held[static_cast<std::size_t>(node)][d] = true;
            }
        }
        for (const PrescribedVelocity& prescribed : scene.bodies[b].prescribed) {
            const int direction = prescribed.direction == Direction::first ? 0 : 1;
            const bool timed = prescribed.from > 0 || std::isfinite(prescribed.until);
            motion.timed = motion.timed || timed;
            motion.motions.push_back(prescribed);
            for (const std::int32_t node : select_nodes(mesh, part, prescribed.edge)) {
                auto& held = motion.held[static_cast<std::size_t>(node)][static_cast<std::size_t>(direction)];
                if (held) continue;  // constraints and earlier prescriptions come first
                held = !timed;
                motion.prescribed.push_back({node, direction,
                                             static_cast<std::int32_t>(motion.motions.size()) - 1,
                                             prescribed.acts(0)});
            }
        }
    }
    return motion;
}

}  // namespace percuss
