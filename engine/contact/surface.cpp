#include "contact/surface.hpp"

#include <algorithm>
#include <unordered_map>

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

void drop_axis(Surface& surface, const Mesh& mesh) {
    const auto r = [&](std::int32_t node) { return mesh.nodes[static_cast<std::size_t>(node)].x(); };
    std::vector<std::int32_t> place(surface.sides.size(), -1), ends;
    std::vector<Side> kept;
    for (std::size_t s = 0; s < surface.sides.size(); ++s) {
        const Side& side = surface.sides[s];
        if (r(side.i) == 0 && r(side.j) == 0) continue;
        place[s] = static_cast<std::int32_t>(kept.size());
        kept.push_back(side);
        ends.insert(ends.end(), {side.i, side.j});
    }
    for (Side& side : kept)
        for (std::int32_t* neighbour : {&side.previous, &side.next})
            if (*neighbour >= 0) *neighbour = place[static_cast<std::size_t>(*neighbour)];
    surface.sides = std::move(kept);
    std::erase_if(surface.nodes, [&](std::int32_t node) {
        return r(node) == 0 && std::find(ends.begin(), ends.end(), node) == ends.end();
    });
}

std::vector<std::array<std::int32_t, 2>> sides_beside(const Surface& surface) {
    std::unordered_map<std::int32_t, std::array<std::int32_t, 2>> of_node;
    for (std::size_t s = 0; s < surface.sides.size(); ++s) {
        const auto index = static_cast<std::int32_t>(s);
        of_node.try_emplace(surface.sides[s].j, std::array{-1, -1}).first->second[0] = index;
        of_node.try_emplace(surface.sides[s].i, std::array{-1, -1}).first->second[1] = index;
    }
    std::vector<std::array<std::int32_t, 2>> beside;
    for (const std::int32_t node : surface.nodes) {
        const auto found = of_node.find(node);
        beside.push_back(found == of_node.end() ? std::array{-1, -1} : found->second);
    }
    return beside;
}

std::vector<std::int32_t> wall_nodes(const Mesh& mesh) {
    std::vector<std::int32_t> nodes;
    for (const Edge& wall : mesh.walls) nodes.insert(nodes.end(), wall.nodes.begin(), wall.nodes.end());
    return nodes;
}

}  // namespace percuss
