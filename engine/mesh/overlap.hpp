#pragma once

#include <optional>

#include "mesh/mesh.hpp"
#include "mesh/segment_tree.hpp"

namespace percuss {

/// All boundary segments of a body, walked with the body on the left.
[[nodiscard]] std::vector<Segment> outline_segments(const Mesh& mesh, const MeshBody& body);

/// The deepest master node that lies in the slave body before the first step.
struct Overlap {
    double depth = 0;  ///< way out of the slave body [length]
    Vec2 at{0, 0};
};

/// @param master_edge, slave_edge named edges, or "" for whole outlines. @param axisymmetric sides on r = 0
/// are no surface. Touching, and overlap below `tolerance` [length], is none. O((n + m) log n).
[[nodiscard]] std::optional<Overlap> find_overlap(const Mesh& mesh, const MeshBody& master,
                                                  const std::string& master_edge, const MeshBody& slave,
                                                  bool axisymmetric, double tolerance);

}  // namespace percuss
