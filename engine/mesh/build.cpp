#include "mesh/build.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>

#include "mesh/block_grid.hpp"
#include "mesh/boundary.hpp"
#include "mesh/join.hpp"
#include "scene/faults.hpp"
#include "scene/readers.hpp"
#include "mesh/wall.hpp"

namespace percuss {
namespace {

/// Nodes nearer than this fraction of the smallest cell side are one node.
constexpr double joining = 1e-6;
/// Radii nearer to the axis than this fraction of the smallest cell side are on it.
constexpr double on_axis = 1e-9;

/// Meshes one body and appends it to the mesh.
class BodyMesher {
  public:
    BodyMesher(const Scene& scene, const Body& body, Faults& faults)
        : scene_(scene), body_(body), faults_(faults) {}

    void append_to(Mesh& mesh) {
        if (body_.blocks.empty()) {
            faults_.error(body_.place, prefix() + "the mesh is empty; add a [[body.block]]");
            return;
        }
        for (const auto& block : body_.blocks) add_grid(block);
        if (!good_) return;
        check_resolution();
        if (scene_.geometry == Geometry::axisymmetric) settle_axis();
        if (good_) append(mesh);
    }

  private:
    [[nodiscard]] std::string prefix() const { return "body '" + body_.name + "': "; }

    void fail(const Place& place, const std::string& message) {
        good_ = false;
        faults_.error(place, prefix() + message);
    }

    void add_grid(const Block& block) {
        try {
            grids_.push_back(mesh_block(block, body_.pattern));
        } catch (const FormulaError& error) {
            return fail(error.place(), error.what());
        } catch (const std::invalid_argument& error) {
            return fail(block.place, error.what());
        }
        const auto fault = fault_of_cells(grids_.back(), scene_.units.length_name());
        if (!fault.empty()) return fail(block.place, fault);
        smallest_ = std::min(smallest_, grids_.back().smallest_side());
    }

    /// Below this the joining tolerance would drown in the rounding of the coordinates.
    void check_resolution() {
        double largest = 0;
        for (const auto& grid : grids_)
            for (const auto& node : grid.nodes)
                largest = std::max({largest, std::abs(node.x()), std::abs(node.y())});
        if (!(smallest_ > 1e-9 * largest))
            fail(body_.place,
                 fmt::format("the smallest cell side {:.3g} {} is too small for coordinates of {:.3g}; use "
                             "larger cells or move the body nearer to the origin",
                             smallest_, scene_.units.length_name(), largest));
    }

    void settle_axis() {
        for (std::size_t b = 0; b < grids_.size(); ++b) {
            double lowest = 0;
            for (auto& node : grids_[b].nodes) {
                if (std::abs(node.x()) <= on_axis * smallest_) node.x() = 0;
                lowest = std::min(lowest, node.x());
            }
            if (lowest < 0)
                fail(body_.blocks[b].place,
                     fmt::format("the mesh reaches r = {:.6g} {}; an axisymmetric scene needs "
                                 "r >= 0 everywhere",
                                 lowest, scene_.units.length_name()));
        }
    }

    void append(Mesh& mesh) {
        MeshBody result;
        result.name = body_.name;
        result.kind = body_.element;
        result.node_begin = mesh.node_count();
        result.cell_begin = mesh.cell_count();
        const auto numbers = number_nodes(mesh);
        for (std::size_t b = 0; b < grids_.size(); ++b) {
            for (Cell cell : grids_[b].cells) {
                for (auto& node : cell)
                    if (node >= 0) node = numbers[b][static_cast<std::size_t>(node)];
                mesh.cells.push_back(cell);
            }
        }
        result.node_end = mesh.node_count();
        result.cell_end = mesh.cell_count();
        try {
            find_edges(mesh, numbers, result);
        } catch (const std::invalid_argument& error) {
            fail(body_.place, error.what());
        }
        mesh.bodies.push_back(std::move(result));
    }

    /// Mesh numbers of the nodes of each block; coinciding nodes on block sides get one number.
    std::vector<std::vector<std::int32_t>> number_nodes(Mesh& mesh) const {
        std::vector<Vec2> side_points;
        std::vector<std::pair<std::size_t, std::size_t>> origin;  // block and node of each side point
        for (std::size_t b = 0; grids_.size() > 1 && b < grids_.size(); ++b)
            for (std::size_t side = 0; side < 4; ++side)
                for (const auto node : grids_[b].side(side)) {
                    side_points.push_back(grids_[b].nodes[static_cast<std::size_t>(node)]);
                    origin.emplace_back(b, static_cast<std::size_t>(node));
                }
        const auto first = coinciding(side_points, joining * smallest_);
        std::vector<std::vector<std::int32_t>> numbers;
        for (const auto& grid : grids_) numbers.emplace_back(grid.nodes.size(), -1);
        std::vector<std::vector<std::int32_t>> same = numbers;  // side point whose number a node takes
        for (std::size_t p = 0; p < first.size(); ++p) same[origin[p].first][origin[p].second] = first[p];
        for (std::size_t b = 0; b < grids_.size(); ++b) {
            for (std::size_t n = 0; n < grids_[b].nodes.size(); ++n) {
                const auto point = same[b][n];
                const auto& [block, node] =
                    point < 0 ? std::pair(b, n) : origin[static_cast<std::size_t>(point)];
                if (numbers[block][node] < 0) {
                    numbers[block][node] = mesh.node_count();
                    mesh.nodes.push_back(grids_[block].nodes[node]);
                }
                numbers[b][n] = numbers[block][node];
            }
        }
        return numbers;
    }

    void find_edges(const Mesh& mesh, const std::vector<std::vector<std::int32_t>>& numbers,
                    MeshBody& result) {
        std::vector<SideChain> sides;
        for (std::size_t b = 0; b < grids_.size(); ++b) {
            for (std::size_t side = 0; side < 4; ++side) {
                SideChain chain{body_.blocks[b].edge_names[side], grids_[b].side(side), b};
                for (auto& node : chain.nodes) node = numbers[b][static_cast<std::size_t>(node)];
                sides.push_back(std::move(chain));
            }
        }
        const Boundary boundary(sides, mesh.nodes);
        if (const auto hanging = boundary.hanging_node(joining * smallest_))
            return fail(
                body_.blocks[hanging->first].place,
                fmt::format("a node at ({:.6g}, {:.6g}) {} lies inside a cell side of another block; give "
                            "touching sides the same corners, divisions and grading",
                            hanging->second.x(), hanging->second.y(), scene_.units.length_name()));
        boundary.require_loops();
        result.outlines = boundary.outlines();
        for (const auto& name : edge_names(body_))
            result.edges.push_back(boundary.named_edge(name, sides_of(name)));
    }

    /// Names of the block sides that make up an edge: its own, or those of its chain.
    [[nodiscard]] std::vector<std::string> sides_of(const std::string& edge) const {
        for (const auto& chain : body_.chains)
            if (chain.name == edge) return chain.edges;
        return {edge};
    }

    const Scene& scene_;
    const Body& body_;
    Faults& faults_;
    std::vector<BlockGrid> grids_;
    double smallest_ = std::numeric_limits<double>::infinity();
    bool good_ = true;
};

}  // namespace

Mesh build_mesh(const Scene& scene) {
    Faults faults(scene.file, scene.overrides);
    Mesh mesh;
    if (scene.bodies.empty()) faults.error({}, "the mesh is empty; add a [[body]]");
    for (const auto& body : scene.bodies) BodyMesher(scene, body, faults).append_to(mesh);
    faults.throw_if_any();
    append_walls(scene, mesh);
    return mesh;
}

}  // namespace percuss
