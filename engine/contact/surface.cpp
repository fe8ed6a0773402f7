#include "contact/surface.hpp"

#include <algorithm>

#include "mesh/select.hpp"

namespace percuss {
namespace {

void append_chain(Surface& surface, const Edge& chain) {
    const auto count = static_cast<std::int32_t>(chain.nodes.size());
    const auto first = static_cast<std::int32_t>(surface.sides.size());
    const std::int32_t sides = chain.closed ? count : count - 1;
    for (std::int32_t k = 0; k < sides; ++k) {
        Side side;
        side.i = chain.nodes[static_cast<std::size_t>(k)];
        side.j = chain.nodes[static_cast<std::size_t>((k + 1) % count)];
        side.previous = k > 0 ? first + k - 1 : (chain.closed ? first + sides - 1 : -1);
        side.next = k + 1 < sides ? first + k + 1 : (chain.closed ? first : -1);
        surface.sides.push_back(side);
    }
    surface.nodes.insert(surface.nodes.end(), chain.nodes.begin(), chain.nodes.end());
}

}  // namespace

Surface make_surface(const Mesh& mesh, const SurfaceName& name) {
    Surface surface;
    const auto wall = std::find_if(mesh.walls.begin(), mesh.walls.end(),
                                   [&](const Edge& w) { return w.name == name.body; });
    if (wall != mesh.walls.end()) {
        append_chain(surface, *wall);
        return surface;
    }
    const auto body = std::find_if(mesh.bodies.begin(), mesh.bodies.end(),
                                   [&](const MeshBody& b) { return b.name == name.body; });
    for (const Edge* chain : surface_chains(*body, name.edge)) append_chain(surface, *chain);
    return surface;
}

std::vector<std::int32_t> wall_nodes(const Mesh& mesh) {
    std::vector<std::int32_t> nodes;
    for (const Edge& wall : mesh.walls) nodes.insert(nodes.end(), wall.nodes.begin(), wall.nodes.end());
    return nodes;
}

}  // namespace percuss
