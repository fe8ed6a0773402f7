#include "mesh/overlap.hpp"

#include "mesh/segment_tree.hpp"
#include "mesh/select.hpp"

namespace percuss {
namespace {

Vec2 at(const Mesh& mesh, std::int32_t node) { return mesh.nodes[static_cast<std::size_t>(node)]; }

Vec2 unit(const Vec2& v) { return v / v.norm(); }

/// Unit normal of a walked segment, to the left: into the body.
Vec2 inward(const Segment& segment) {
    const Vec2 t = unit(segment.to - segment.from);
    return {-t.y(), t.x()};
}

}  // namespace

std::vector<Segment> outline_segments(const Mesh& mesh, const MeshBody& body) {
    std::vector<Segment> segments;
    for (const auto& loop : body.outlines)
        for (std::size_t i = 0; i < loop.nodes.size(); ++i)
            segments.push_back({at(mesh, loop.nodes[i]), at(mesh, loop.nodes[(i + 1) % loop.nodes.size()])});
    return segments;
}

std::optional<Overlap> find_overlap(const Mesh& mesh, const MeshBody& master, const std::string& master_edge,
                                    const MeshBody& slave, bool axisymmetric, double tolerance) {
    const SegmentTree tree(outline_segments(mesh, slave));
    const auto is_surface = [&](std::size_t i) {
        const auto& [from, to] = tree.segments()[i];
        return !axisymmetric || from.x() != 0 || to.x() != 0;
    };
    std::optional<Overlap> deepest;
    const auto keep = [&](double depth, const Vec2& point) {
        if (depth > tolerance && (!deepest || depth > deepest->depth)) deepest = Overlap{depth, point};
    };
    // Way out for a node whose body lies towards `into_master`: through a side that faces there.
    const auto keep_exit = [&](const Vec2& point, const Vec2& into_master) {
        const auto faces = [&](std::size_t i) {
            return is_surface(i) && inward(tree.segments()[i]).dot(into_master) < -1e-3;
        };
        if (const auto exit = tree.nearest(point, faces)) keep(exit->distance, point);
    };
    const auto examine = [&](const Vec2& point, const Vec2& into_master) {
        if (&master == &slave) {
            // Just outside its own surface a node must be outside the whole body.
            if (tree.winding(point - 100 * tolerance * into_master) != 0) keep_exit(point, into_master);
            return;
        }
        const auto nearest = tree.nearest(point, is_surface);
        if (!nearest) return;
        if (nearest->distance > tolerance) {
            if (tree.winding(point) != 0) keep(nearest->distance, point);
            return;
        }
        // The node is on the slave's surface; the bodies overlap when a little of the master beside it is
        // inside.
        const Vec2 beside = point + 100 * tolerance * into_master;
        if (tree.winding(beside) != 0 && tree.nearest(beside, is_surface)->distance > tolerance)
            keep_exit(point, into_master);
    };
    for (const auto* chain : surface_chains(master, master_edge)) {
        const auto& nodes = chain->nodes;
        const std::size_t count = nodes.size();
        for (std::size_t i = 0; i < count; ++i) {
            const bool first = i == 0 && !chain->closed, last = i + 1 == count && !chain->closed;
            const Vec2 here = at(mesh, nodes[i]);
            Vec2 into{0, 0};
            if (!first) into += inward({at(mesh, nodes[(i + count - 1) % count]), here});
            if (!last) into += inward({here, at(mesh, nodes[(i + 1) % count])});
            examine(here, into.norm() > 1e-6 ? unit(into) : into);
        }
    }
    return deepest;
}

}  // namespace percuss
