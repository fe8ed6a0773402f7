#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "mesh/mesh.hpp"

namespace percuss {

/// A block side in the numbering of the mesh, walked with the block on the left.
struct SideChain {
    std::string name;                 ///< "" where the scene does not name it
    std::vector<std::int32_t> nodes;  ///< first to last
    std::size_t block = 0;            ///< index in the body
};

/// The boundary of one body: the side segments that no other block walks the other way.
class Boundary {
  public:
    /// @throws std::invalid_argument when blocks cover the same side.
    Boundary(const std::vector<SideChain>& sides, const std::vector<Vec2>& nodes);

    /// A boundary node within `tolerance` of a segment that it does not end, with its block: nodes that do
    /// not meet.
    [[nodiscard]] std::optional<std::pair<std::size_t, Vec2>> hanging_node(double tolerance) const;
    /// Every boundary node must have one next node, else no loop is defined. @throws std::invalid_argument
    /// when blocks meet in a single node.
    void require_loops() const;

    // What follows needs require_loops().

    /// The node after `node` on the boundary; nothing off the boundary.
    [[nodiscard]] std::optional<std::int32_t> next(std::int32_t node) const;
    /// All loops, the largest enclosed area first, named "outline", "outline 2", ...
    [[nodiscard]] std::vector<Edge> outlines() const;
    /// The chain of all sides that have one of the names. @throws std::invalid_argument when one lies inside
    /// the body or they do not connect.
    [[nodiscard]] Edge named_edge(const std::string& name, const std::vector<std::string>& side_names) const;

  private:
    [[nodiscard]] Vec2 point(std::int32_t node) const;
    [[nodiscard]] std::string at(std::int32_t node) const;  ///< "(1, 2)"

    const std::vector<SideChain>* sides_;
    const std::vector<Vec2>* nodes_;
    struct Step {
        std::int32_t from, to;
        std::size_t block;
    };
    std::vector<Step> steps_;  // in the order of the sides: results do not hang on hashing
    std::unordered_map<std::int32_t, std::int32_t> next_;
    std::optional<std::int32_t> pinched_;
};

}  // namespace percuss
