#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "contact/row.hpp"
#include "contact/solvers/profile_cholesky.hpp"
#include "dynamics/node.hpp"
#include "elements/elastic_stiffness.hpp"
#include "mesh/mesh.hpp"
#include "scene/scene.hpp"

namespace percuss {

/// The nodes of all surfaces that pairs keep apart, without mass: they are where the elements behind them and
/// the contact forces balance. Their masses are on the nodes next to them. Nodes that are held in both
/// directions, or driven, keep theirs.
class MasslessLayer {
  public:
    MasslessLayer(const Scene& scene, const Mesh& mesh);

    struct LayerNode {
        std::int32_t node;
        std::array<std::int32_t, 2> unknown;  ///< -1 in a direction that is held
        std::int32_t cells_begin, cells_end, carriers_begin, carriers_end;
    };
    [[nodiscard]] const std::vector<LayerNode>& nodes() const { return nodes_; }
    /// Index among nodes() of a node of the mesh, -1: it has mass.
    [[nodiscard]] std::int32_t index_of(std::int32_t node) const {
        return index_of_[static_cast<std::size_t>(node)];
    }
    [[nodiscard]] std::int32_t unknowns() const { return unknowns_; }
    /// The unknown of a node of the mesh in direction d, -1: it has mass, or is held.
    [[nodiscard]] std::int32_t unknown_of(std::int32_t node, std::size_t d) const {
        const std::int32_t at = index_of(node);
        return at < 0 ? -1 : nodes_[static_cast<std::size_t>(at)].unknown[d];
    }
    /// Nodes that carry the mass of one of nodes(), in equal parts.
    [[nodiscard]] std::span<const std::int32_t> carriers_of(const LayerNode& node) const {
        return std::span(carriers_).subspan(
            static_cast<std::size_t>(node.carriers_begin),
            static_cast<std::size_t>(node.carriers_end - node.carriers_begin));
    }
    /// Cells at one of nodes(), as indices of cells().
    [[nodiscard]] std::span<const std::int32_t> cells_of(const LayerNode& node) const {
        return std::span(cells_of_).subspan(static_cast<std::size_t>(node.cells_begin),
                                            static_cast<std::size_t>(node.cells_end - node.cells_begin));
    }
    struct LayerCell {
        Cell corners;
        ElementKind kind;
        ElasticConstants material;
        double area;  ///< undeformed [length^2]
        CellStiffness stiffness;
    };
    [[nodiscard]] const std::vector<LayerCell>& cells() const { return cells_; }
    /// Finds the stiffness of the cells at the start of a step. @param nodes at its end
    void find_stiffness(const Node* nodes, double dt);
    /// Takes the masses off the layer. @param mass per node of the mesh, changed
    void move_mass(std::vector<double>& mass) const;
    /// A node of the layer beside which no node keeps its mass: a body one element thick.
    [[nodiscard]] std::optional<std::int32_t> without_carrier() const;

  private:
    Geometry geometry_;
    std::vector<LayerNode> nodes_;
    std::vector<std::int32_t> index_of_, carriers_, cells_of_;
    std::vector<LayerCell> cells_;
    std::int32_t unknowns_ = 0;
};

}  // namespace percuss
