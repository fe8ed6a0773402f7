#include "contact/joint/make_rows.hpp"

#include <algorithm>
#include <limits>
#include <memory>
#include <utility>
#include <variant>

#include "contact/joint/near_search.hpp"
#include "contact/joint/node_to_side_rows.hpp"
#include "contact/joint/segment_rows.hpp"
#include "contact/joint/symmetric_rows.hpp"
#include "mesh/overlap.hpp"
#include "mesh/select.hpp"
#include "mesh/wall.hpp"

namespace percuss {
namespace {

template <class List>
std::size_t index_of(const List& list, const std::string& name) {
    return static_cast<std::size_t>(
        std::find_if(list.begin(), list.end(), [&](const auto& element) { return element.name == name; }) -
        list.begin());
}

/// At the start; infinite for what never yields [stress].
double yield_stress(const Scene& scene, const Body& body) {
    const Plasticity& law = scene.materials[index_of(scene.materials, body.material)].plasticity;
    if (const auto* voce = std::get_if<VoceHardening>(&law)) return voce->yield;
    if (const auto* table = std::get_if<TabulatedHardening>(&law)) return table->points.front().second;
    if (const auto* johnson_cook = std::get_if<JohnsonCook>(&law)) return johnson_cook->yield;
    return std::numeric_limits<double>::infinity();
}

double mean_side(const Mesh& mesh, const Surface& surface) {
    double sum = 0;
    for (const Side& side : surface.sides)
        sum += (mesh.nodes[static_cast<std::size_t>(side.i)] - mesh.nodes[static_cast<std::size_t>(side.j)])
                   .norm();
    return sum / static_cast<double>(std::max<std::size_t>(1, surface.sides.size()));
}

/// Indices of the nodes of a surface that begin inside the body, or behind the wall, of the other.
std::vector<std::int32_t> overlapping(const Scene& scene, const Mesh& mesh, const Surface& surface,
                                      const SurfaceName& other) {
    std::vector<std::int32_t> inside;
    const auto collect = [&](const auto& depth_of) {
        for (std::size_t k = 0; k < surface.nodes.size(); ++k)
            if (depth_of(mesh.nodes[static_cast<std::size_t>(surface.nodes[k])]))
                inside.push_back(static_cast<std::int32_t>(k));
    };
    const double tolerance = 1e-9 * mean_side(mesh, surface);
    if (const Wall* wall = find_wall(scene, other.body)) {
        collect([&](const Vec2& x) { return distance(*wall, x) < -tolerance; });
        return inside;
    }
    const MeshBody& body = mesh.bodies[index_of(scene.bodies, other.body)];
    Vec2 low = mesh.nodes[static_cast<std::size_t>(body.node_begin)], high = low;
    for (auto n = static_cast<std::size_t>(body.node_begin); n < static_cast<std::size_t>(body.node_end);
         ++n) {
        low = low.cwiseMin(mesh.nodes[n]);
        high = high.cwiseMax(mesh.nodes[n]);
    }
    const auto within_box = [&](const Vec2& x) {
        return (x.array() >= low.array()).all() && (x.array() <= high.array()).all();
    };
    collect(within_box);
    if (inside.empty()) return inside;
    inside.clear();
    const SegmentTree tree(outline_segments(mesh, body));
    collect([&](const Vec2& x) {
        return within_box(x) && tree.winding(x) != 0 &&
               tree.nearest(x, [](std::size_t) { return true; })->distance > tolerance;
    });
    return inside;
}

}  // namespace

PairSurfaces pair_surfaces(const Scene& scene, const Mesh& mesh, const ContactPair& pair) {
    PairSurfaces surfaces{make_surface(mesh, pair.master), make_surface(mesh, pair.slave)};
    if (scene.geometry == Geometry::axisymmetric) {
        drop_axis(surfaces.master, mesh);
        drop_axis(surfaces.slave, mesh);
    }
    return surfaces;
}

bool first_is_fine(const Scene& scene, const Mesh& mesh, const ContactPair& pair) {
    if (!pair.by_bodies || find_wall(scene, pair.slave.body)) return true;
    const std::size_t a = index_of(scene.bodies, pair.master.body),
                      b = index_of(scene.bodies, pair.slave.body);
    const double yield_a = yield_stress(scene, scene.bodies[a]),
                 yield_b = yield_stress(scene, scene.bodies[b]);
    if (yield_a < 0.5 * yield_b || yield_b < 0.5 * yield_a) return yield_a < yield_b;
    const PairSurfaces surfaces = pair_surfaces(scene, mesh, pair);
    const double side_a = mean_side(mesh, surfaces.master), side_b = mean_side(mesh, surfaces.slave);
    if (side_a < 0.99 * side_b || side_b < 0.99 * side_a) return side_a < side_b;
    return a < b;
}

AnyRowBuilder make_rows(const Scene& scene, const Mesh& mesh, const ContactPair& pair) {
    const PairSurfaces surfaces = pair_surfaces(scene, mesh, pair);
    const auto masters = static_cast<std::int32_t>(surfaces.master.nodes.size()),
               slaves = static_cast<std::int32_t>(surfaces.slave.nodes.size());
    if (is_self_contact(pair))
        return AnyRowBuilder(std::make_unique<NodeToSideRows>(
            NearSearch(surfaces.master, surfaces.slave, {.by_facing = true, .self = true})));
    const auto search = [&](bool of_master, std::int32_t first_key, double slack) {
        const std::int32_t first_owner = of_master ? 0 : masters;
        // Whole outlines have corners that stand on each other.
        const bool by_facing = pair.by_bodies || pair.scheme != RowScheme::node_to_side;
        NearRole role{of_master,
                      first_owner,
                      first_key + first_owner,
                      slack,
                      by_facing,
                      overlapping(scene, mesh, of_master ? surfaces.master : surfaces.slave,
                                  of_master ? pair.slave : pair.master)};
        return of_master ? NearSearch(surfaces.master, surfaces.slave, std::move(role))
                         : NearSearch(surfaces.slave, surfaces.master, std::move(role));
    };
    const bool first = first_is_fine(scene, mesh, pair);
    switch (pair.scheme) {
        case RowScheme::symmetric:
            return AnyRowBuilder(std::make_unique<SymmetricRows>(search(true, 0, 0), search(false, 0, 0)));
        case RowScheme::segment_to_segment: {
            const std::int32_t guards = masters + slaves;
            return AnyRowBuilder(std::make_unique<SegmentRows>(
                search(first, guards, SegmentRows::guard_slack),
                search(!first, guards, SegmentRows::guard_slack), scene.geometry == Geometry::axisymmetric));
        }
        case RowScheme::node_to_side:
            break;
    }
    return AnyRowBuilder(std::make_unique<NodeToSideRows>(search(first, 0, 0)));
}

}  // namespace percuss
