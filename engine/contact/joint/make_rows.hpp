#pragma once

#include "contact/joint/row_builder.hpp"
#include "contact/surface.hpp"
#include "mesh/mesh.hpp"
#include "scene/scene.hpp"

namespace percuss {

/// The two surfaces of a pair. Sides on the axis of an axisymmetric scene are none.
struct PairSurfaces {
    Surface master, slave;
};
[[nodiscard]] PairSurfaces pair_surfaces(const Scene& scene, const Mesh& mesh, const ContactPair& pair);

/// Whether the nodes of the pair's first body are the ones that its scheme keeps out (or whose shape
/// functions weigh the gap). A pair with master and slave says so itself. For one of two bodies it follows
/// from them, in whatever order they are named: the body that yields at less than half the stress of the
/// other, else the one with the shorter sides, else the first in the scene; never a wall.
[[nodiscard]] bool first_is_fine(const Scene& scene, const Mesh& mesh, const ContactPair& pair);

/// The scheme that a pair asks for.
[[nodiscard]] AnyRowBuilder make_rows(const Scene& scene, const Mesh& mesh, const ContactPair& pair);

}  // namespace percuss
