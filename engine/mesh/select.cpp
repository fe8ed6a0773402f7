#include "mesh/select.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace percuss {

const Edge* find_edge(const MeshBody& body, const std::string& name) {
    const auto found =
        std::find_if(body.edges.begin(), body.edges.end(), [&](const Edge& e) { return e.name == name; });
    return found == body.edges.end() ? nullptr : &*found;
}

std::vector<std::int32_t> select_nodes(const Mesh& mesh, const MeshBody& body, const std::string& edge,
                                       const std::optional<std::array<double, 4>>& box) {
    std::vector<std::int32_t> nodes;
    if (edge.empty()) {
        nodes.resize(static_cast<std::size_t>(body.node_end - body.node_begin));
        std::iota(nodes.begin(), nodes.end(), body.node_begin);
    } else if (const auto* chain = find_edge(body, edge)) {
        nodes = chain->nodes;
    }
    if (!box) return nodes;
    const auto outside = [&](std::int32_t node) {
        for (std::size_t axis = 0; axis < 2; ++axis) {
            const double low = (*box)[axis], high = (*box)[axis + 2];
            // Graded and curved nodes meet a side of the box only up to rounding.
            const double slack = 1e-9 * std::max({high - low, std::abs(low), std::abs(high)});
            const double x = mesh.nodes[static_cast<std::size_t>(node)][static_cast<Eigen::Index>(axis)];
            if (x < low - slack || x > high + slack) return true;
        }
        return false;
    };
    nodes.erase(std::remove_if(nodes.begin(), nodes.end(), outside), nodes.end());
    return nodes;
}

std::vector<const Edge*> surface_chains(const MeshBody& body, const std::string& edge) {
    std::vector<const Edge*> chains;
    if (!edge.empty()) {
        if (const auto* chain = find_edge(body, edge)) chains.push_back(chain);
    } else {
        for (const auto& outline : body.outlines) chains.push_back(&outline);
    }
    return chains;
}

double smallest_side(const Mesh& mesh, const MeshBody& body) {
    double smallest = std::numeric_limits<double>::infinity();
    for (auto c = body.cell_begin; c < body.cell_end; ++c) {
        const Cell& cell = mesh.cells[static_cast<std::size_t>(c)];
        const auto count = static_cast<std::size_t>(corner_count(cell));
        for (std::size_t i = 0; i < count; ++i) {
            const auto a = static_cast<std::size_t>(cell[i]),
                       b = static_cast<std::size_t>(cell[(i + 1) % count]);
            smallest = std::min(smallest, (mesh.nodes[a] - mesh.nodes[b]).norm());
        }
    }
    return smallest;
}

}  // namespace percuss
