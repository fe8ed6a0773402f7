#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "mesh/mesh.hpp"
#include "scene/scene.hpp"

namespace percuss {

/// A straight piece of boundary between two nodes; the body lies on the left of i -> j, so the outward normal
/// is (dy, -dx) / length.
struct Side {
    std::int32_t i = 0, j = 0;
    std::int32_t previous = -1, next = -1;  ///< neighbours along the chain, -1 at an open end
};

/// One side of a contact pair: all sides of a named edge or of a body's outline, in chain order, and their
/// nodes.
struct Surface {
    std::vector<Side> sides;
    std::vector<std::int32_t> nodes;  ///< each once, in chain order
};

/// @pre the scene was checked: body and edge, or the wall, exist.
[[nodiscard]] Surface make_surface(const Mesh& mesh, const SurfaceName& name);

/// Takes away the sides that lie on the axis r = 0 and the nodes between them.
void drop_axis(Surface& surface, const Mesh& mesh);

/// Per node of a surface, in its order: the sides that end and that begin there, -1 where there is none.
[[nodiscard]] std::vector<std::array<std::int32_t, 2>> sides_beside(const Surface& surface);

/// The nodes of all walls, which never move.
[[nodiscard]] std::vector<std::int32_t> wall_nodes(const Mesh& mesh);

}  // namespace percuss
