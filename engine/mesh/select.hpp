#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "mesh/mesh.hpp"

namespace percuss {

/// A named edge of a body; null when it has none of that name.
[[nodiscard]] const Edge* find_edge(const MeshBody& body, const std::string& name);

/// Nodes of a body that a constraint or prescribed velocity selects: those of the named edge, or all when
/// `edge` is empty, inside the box {min0, min1, max0, max1} (its sides included, up to rounding) when there
/// is one.
[[nodiscard]] std::vector<std::int32_t> select_nodes(
    const Mesh& mesh, const MeshBody& body, const std::string& edge,
    const std::optional<std::array<double, 4>>& box = std::nullopt);

/// The chains that a contact surface is made of: one named edge, or all outlines when `edge` is empty.
[[nodiscard]] std::vector<const Edge*> surface_chains(const MeshBody& body, const std::string& edge);

/// Length of the shortest cell side of a body [length].
[[nodiscard]] double smallest_side(const Mesh& mesh, const MeshBody& body);

}  // namespace percuss
