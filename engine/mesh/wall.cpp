#include "mesh/wall.hpp"

#include <algorithm>

namespace percuss {
namespace {

/// Half the length of a wall over the farthest distance of a body's node from its point.
constexpr double reach = 100;

}  // namespace

void append_walls(const Scene& scene, Mesh& mesh) {
    const auto bodies_end = static_cast<std::ptrdiff_t>(mesh.nodes.size());
    for (const Wall& wall : scene.walls) {
        double farthest = 0;
        std::for_each(mesh.nodes.begin(), mesh.nodes.begin() + bodies_end,
                      [&](const Vec2& node) { farthest = std::max(farthest, (node - wall.point).norm()); });
        // Walked with the wall on the left hand, as bodies are.
        const Vec2 along = reach * farthest * Vec2(-wall.normal.y(), wall.normal.x());
        const std::int32_t first = mesh.node_count();
        mesh.nodes.push_back(wall.point - along);
        mesh.nodes.push_back(wall.point + along);
        mesh.walls.push_back({wall.name, {first, first + 1}, false});
    }
}

const Wall* find_wall(const Scene& scene, const std::string& name) {
    const auto found =
        std::find_if(scene.walls.begin(), scene.walls.end(), [&](const Wall& w) { return w.name == name; });
    return found == scene.walls.end() ? nullptr : &*found;
}

}  // namespace percuss
