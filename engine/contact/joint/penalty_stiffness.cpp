#include "contact/joint/penalty_stiffness.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <unordered_map>

#include "contact/surface.hpp"
#include "dynamics/node.hpp"
#include "elements/batch.hpp"

namespace percuss {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

std::int64_t key_of(std::int32_t i, std::int32_t j) {
    return (static_cast<std::int64_t>(std::min(i, j)) << 32) | static_cast<std::int64_t>(std::max(i, j));
}

double bulk_modulus(const Scene& scene, const Body& body) {
    const auto material = std::find_if(scene.materials.begin(), scene.materials.end(),
                                       [&](const Material& m) { return m.name == body.material; });
    return material->young / (3 * (1 - 2 * material->poisson));
}

}  // namespace

PenaltyStiffness::PenaltyStiffness(const Scene& scene, const Mesh& mesh)
    : of_node_(mesh.nodes.size(), infinity) {
    std::vector<Node> nodes;
    for (const Vec2& x : mesh.nodes) nodes.push_back({{x.x(), x.y()}, {0, 0}});
    for (std::size_t b = 0; b < mesh.bodies.size(); ++b) {
        const MeshBody& body = mesh.bodies[b];
        const double bulk = bulk_modulus(scene, scene.bodies[b]);
        std::unordered_map<std::int64_t, std::int32_t> cell_of;  // of sides on the boundary, the only one
        for (std::int32_t cell = body.cell_begin; cell < body.cell_end; ++cell) {
            const Cell& corners = mesh.cells[static_cast<std::size_t>(cell)];
            const auto count = static_cast<std::size_t>(corner_count(corners));
            for (std::size_t k = 0; k < count; ++k)
                cell_of[key_of(corners[k], corners[(k + 1) % count])] = cell;
        }
        std::unordered_map<std::int32_t, std::pair<double, int>> sums;
        Surface outline = make_surface(mesh, {body.name, "", {}});
        if (scene.geometry == Geometry::axisymmetric) drop_axis(outline, mesh);  // its sides have no area
        for (const Side& side : outline.sides) {
            const Vec2 &i = mesh.nodes[static_cast<std::size_t>(side.i)],
                       &j = mesh.nodes[static_cast<std::size_t>(side.j)];
            const double radius = scene.geometry == Geometry::axisymmetric ? 0.5 * (i.x() + j.x()) : 1;
            const double area = radius * (j - i).norm();
            const Cell& cell = mesh.cells[static_cast<std::size_t>(cell_of.at(key_of(side.i, side.j)))];
            const double stiffness = bulk * area * area / cell_volume(cell, nodes.data(), scene.geometry);
            for (const std::int32_t node : {side.i, side.j}) {
                sums[node].first += stiffness;
                ++sums[node].second;
            }
        }
        for (const auto& [node, sum] : sums)
            of_node_[static_cast<std::size_t>(node)] = sum.first / sum.second;
    }
}

double PenaltyStiffness::of(std::span<const RowTerm> terms, std::int32_t master_terms) const {
    const auto mean = [&](std::span<const RowTerm> part) {
        double sum = 0, parts = 0;
        for (const RowTerm& term : part) {
            const double share = std::hypot(term.g[0], term.g[1]);
            if (share == 0) continue;
            sum += share * of_node_[static_cast<std::size_t>(term.node)];
            parts += share;
        }
        return sum / parts;
    };
    const auto masters = static_cast<std::size_t>(master_terms);
    return std::min(mean(terms.first(masters)), mean(terms.subspan(masters)));
}

}  // namespace percuss
