#pragma once

#include "mesh/mesh.hpp"
#include "scene/scene.hpp"

namespace percuss {

/// Meshes all bodies of a scene: each block by transfinite interpolation, blocks of one body joined at
/// coinciding nodes, boundary loops extracted, named edges ordered with the body on the left.
/// @throws SceneError for an empty mesh, degenerate or inverted elements, r < 0, edges that are not on the
/// boundary.
[[nodiscard]] Mesh build_mesh(const Scene& scene);

/// Checks that need the mesh: initial overlap of contact pairs (depth and place), constraints and loads that
/// select no node, probes outside their body, a fixed step above the critical step is checked by the solver.
/// @throws SceneError.
void check_mesh(const Scene& scene, const Mesh& mesh);

}  // namespace percuss
