#pragma once

#include "mesh/mesh.hpp"
#include "scene/scene.hpp"

namespace percuss {

/// Exact volume of a body's straight-sided cells [length^3]: of the full ring, 2 pi int r dA, when
/// axisymmetric, else area times `thickness`.
[[nodiscard]] double body_volume(const Mesh& mesh, const MeshBody& body, Geometry geometry, double thickness);

}  // namespace percuss
