#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace percuss {

using Vec2 = Eigen::Vector2d;

enum class ElementKind {
    quad_one_point,        ///< 4 nodes, one integration point, hourglass stiffness
    quad_mean_dilatation,  ///< 4 nodes, 2x2 points, one pressure (B-bar)
    triangle,              ///< 3 nodes, constant strain
    triangle_averaged,     ///< the same with volumes averaged at nodes
};

[[nodiscard]] inline bool is_triangle(ElementKind kind) {
    return kind == ElementKind::triangle || kind == ElementKind::triangle_averaged;
}

/// Nodes of one element, counter-clockwise in (x, y) or (r, z). A triangle has -1 in its last place.
using Cell = std::array<std::int32_t, 4>;

/// A chain of boundary nodes, walked with the body on the left hand (outward normal = tangent turned by -90
/// degrees). A closed chain does not repeat its first node.
struct Edge {
    std::string name;  ///< "face", or "outline" / "outline 2" for the whole boundary loops of the body
    std::vector<std::int32_t> nodes;
    bool closed = false;
};

/// The part of the mesh that belongs to one body: contiguous ranges of nodes and cells.
struct MeshBody {
    std::string name;
    ElementKind kind = ElementKind::quad_one_point;
    std::int32_t node_begin = 0, node_end = 0;
    std::int32_t cell_begin = 0, cell_end = 0;
    std::vector<Edge> edges;     ///< the edges that the scene names
    std::vector<Edge> outlines;  ///< all boundary loops, outer loop first
};

/// All bodies of a scene in one numbering. Lengths in scene units; first coordinate x or r, second y or z.
struct Mesh {
    std::vector<Vec2> nodes;
    std::vector<Cell> cells;
    std::vector<MeshBody> bodies;
    std::vector<Edge> walls;  ///< one side each, between two nodes beyond those of the bodies, which never move

    [[nodiscard]] std::int32_t node_count() const { return static_cast<std::int32_t>(nodes.size()); }
    [[nodiscard]] std::int32_t cell_count() const { return static_cast<std::int32_t>(cells.size()); }
};

[[nodiscard]] inline int corner_count(const Cell& cell) { return cell[3] < 0 ? 3 : 4; }

}  // namespace percuss
