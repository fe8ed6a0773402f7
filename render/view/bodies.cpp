#include "view/bodies.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace percuss::render {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::array<double, 4> nothing{infinity, infinity, -infinity, -infinity};

void include(std::array<double, 4>& box, const std::array<double, 2>& point) {
    for (std::size_t k = 0; k < 2; ++k) {
        if (!std::isfinite(point[k])) continue;
        box[k] = std::min(box[k], point[k]);
        box[k + 2] = std::max(box[k + 2], point[k]);
    }
}

/// The box of a body whose nodes are at `at(i)`; its mirror image is added.
template <class Position>
std::array<double, 4> box_of(const MeshBody& body, const Plane& plane, const Position& at) {
    std::array<double, 4> box = nothing;
    for (std::int32_t i = body.node_begin; i < body.node_end; ++i)
        include(box, at(static_cast<std::size_t>(i)));
    if (plane.mirrored) {
        const std::size_t k = plane.mirror_axis();
        const double reach = std::max(box[k + 2], -box[k]);
        box[k] = -reach;
        box[k + 2] = reach;
    }
    return box;
}

}  // namespace

std::vector<std::array<double, 4>> body_boxes(const Snapshot& snapshot, const Plane& plane) {
    std::vector<std::array<double, 4>> boxes;
    for (const MeshBody& body : snapshot.setup->mesh.bodies)
        boxes.push_back(box_of(body, plane, [&](std::size_t i) {
            return plane(snapshot.position[2 * i], snapshot.position[2 * i + 1]);
        }));
    return boxes;
}

std::array<double, 4> box_around(const std::vector<std::array<double, 4>>& boxes) {
    std::array<double, 4> all = nothing;
    for (const auto& box : boxes) {
        include(all, {box[0], box[1]});
        include(all, {box[2], box[3]});
    }
    return all[0] <= all[2] ? all : std::array<double, 4>{0, 0, 1, 1};
}

std::array<double, 4> initial_box(const RunSetup& setup, const Plane& plane) {
    std::vector<std::array<double, 4>> boxes;
    for (const MeshBody& body : setup.mesh.bodies)
        boxes.push_back(box_of(body, plane, [&](std::size_t i) {
            return plane(setup.mesh.nodes[i][0], setup.mesh.nodes[i][1]);
        }));
    const std::array<double, 4> start = box_around(boxes);
    const double limit = 0.2 * std::max(start[2] - start[0], start[3] - start[1]);
    std::array<double, 4> swept = start;
    const std::size_t moving = std::min(setup.scene.bodies.size(), boxes.size());
    for (std::size_t b = 0; b < moving; ++b) {
        const auto velocity = plane(setup.scene.bodies[b].velocity[0], setup.scene.bodies[b].velocity[1]);
        for (std::size_t k = 0; k < 2; ++k) {
            const double travel = std::clamp(velocity[k] * setup.scene.duration, -limit, limit);
            swept[k] = std::min(swept[k], boxes[b][k] + travel);
            swept[k + 2] = std::max(swept[k + 2], boxes[b][k + 2] + travel);
        }
    }
    return swept;
}

std::array<double, 2> drawn_velocity(const Snapshot& snapshot, std::size_t body, const Plane& plane) {
    const auto& velocity = snapshot.bodies[body].velocity;
    const bool axisymmetric = snapshot.setup->scene.geometry == Geometry::axisymmetric;
    return plane(axisymmetric ? 0 : velocity[0], velocity[1]);
}

}  // namespace percuss::render
