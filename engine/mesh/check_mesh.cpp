#include <algorithm>
#include <map>
#include <optional>

#include <fmt/format.h>

#include "contact/joint/massless_layer.hpp"
#include "dynamics/loads.hpp"
#include "mesh/build.hpp"
#include "mesh/overlap.hpp"
#include "mesh/segment_tree.hpp"
#include "mesh/select.hpp"
#include "mesh/wall.hpp"
#include "scene/faults.hpp"

namespace percuss {
namespace {

/// Checks one mesh; what several checks need of a body is found once.
class MeshCheck {
  public:
    MeshCheck(const Scene& scene, const Mesh& mesh, Faults& faults)
        : scene_(scene), mesh_(mesh), faults_(faults) {
        for (const auto& body : mesh.bodies) {
            bodies_.emplace(body.name, &body);
            sides_.emplace(body.name, smallest_side(mesh, body));
        }
    }

    void check_pair(const ContactPair& pair) const {
        if (const Wall* wall = find_wall(scene_, pair.slave.body)) return check_wall(pair, *wall);
        const auto &master = *bodies_.at(pair.master.body), &slave = *bodies_.at(pair.slave.body);
        if (&master == &slave && !pair.by_bodies) check_disjoint(pair, master);
        const double tolerance = 1e-9 * std::min(sides_.at(master.name), sides_.at(slave.name));
        const bool axisymmetric = scene_.geometry == Geometry::axisymmetric;
        check_overlap(pair, master, slave,
                      find_overlap(mesh_, master, pair.master.edge, slave, axisymmetric, tolerance));
        if (pair.by_bodies && &master != &slave)
            check_overlap(pair, slave, master,
                          find_overlap(mesh_, slave, "", master, axisymmetric, tolerance));
    }

    void check_probe(const Probe& probe) {
        const auto& body = *bodies_.at(probe.body);
        auto tree = trees_.find(body.name);
        if (tree == trees_.end()) tree = trees_.emplace(body.name, outline_segments(mesh_, body)).first;
        if (tree->second.winding(probe.at) != 0) return;
        const double away = tree->second.nearest(probe.at, [](std::size_t) { return true; })->distance;
        if (away > 1e-6 * sides_.at(body.name))
            faults_.error(
                probe.place,
                fmt::format("probe '{}' at {} lies {:.6g} {} outside body '{}'; move it inside", probe.name,
                            text(probe.at), away, scene_.units.length_name(), body.name));
    }

    void check_constraints(const Body& body) const {
        for (const auto& constraint : body.constraints)
            if (select_nodes(mesh_, *bodies_.at(body.name), constraint.edge, constraint.box).empty())
                faults_.error(
                    constraint.place,
                    fmt::format("body '{}': the constraint holds no node; enlarge its box", body.name));
    }

    /// Contact nodes without mass need others beside them, and motions that do not begin or end.
    void check_massless() const {
        if (scene_.contact_solver.scheme != ContactScheme::massless || scene_.contacts.empty()) return;
        const MasslessLayer layer(scene_, mesh_);
        const Place& place = scene_.contacts.front().place;
        if (const auto bare = layer.without_carrier())
            faults_.error(
                place,
                fmt::format("the scheme \"massless\" needs two layers of elements behind a surface; at "
                            "{} there is one: divide the body more finely, or choose another scheme",
                            text(mesh_.nodes[static_cast<std::size_t>(*bare)])));
        for (const MeshBody& body : mesh_.bodies)
            if (body.kind == ElementKind::triangle_averaged)
                faults_.error(
                    place,
                    fmt::format("the scheme \"massless\" takes no averaged triangles, and body '{}' has "
                                "them; choose another element or another scheme",
                                body.name));
        const ImposedMotion imposed = impose_motion(scene_, mesh_);
        if (imposed.timed)
            faults_.error(place,
                          "the scheme \"massless\" takes no motion that begins or ends within the run; leave "
                          "'from' and 'until' out, or choose another scheme");
    }

  private:
    /// The joint problem remembers an overlap that is small against the cells, such as that of the chords of
    /// curved faces; a deeper one is a slip of the scene.
    [[nodiscard]] double most_overlap(const MeshBody& one, const MeshBody& other) const {
        if (scene_.contact_solver.scheme == ContactScheme::projection) return 0;
        return 0.1 * std::min(sides_.at(one.name), sides_.at(other.name));
    }

    void check_overlap(const ContactPair& pair, const MeshBody& one, const MeshBody& other,
                       const std::optional<Overlap>& overlap) const {
        const double most = most_overlap(one, other);
        if (!overlap || overlap->depth <= most) return;
        const std::string limit =
            most > 0 ? fmt::format(", or overlap by no more than {:.6g} {}, a tenth of the smallest side",
                                   most, scene_.units.length_name())
                     : "";
        faults_.error(
            pair.place,
            fmt::format("contact '{}': body '{}' overlaps {} by {:.6g} {} at {}; move them apart "
                        "until they touch or leave a gap{}",
                        pair.name, one.name, &one == &other ? "itself" : "body '" + other.name + "'",
                        overlap->depth, scene_.units.length_name(), text(overlap->at), limit));
    }

    [[nodiscard]] std::string text(const Vec2& point) const {
        return fmt::format("({:.6g}, {:.6g}) {}", point.x(), point.y(), scene_.units.length_name());
    }

    void check_wall(const ContactPair& pair, const Wall& wall) const {
        const MeshBody& master = *bodies_.at(pair.master.body);
        double deepest = std::max(1e-9 * sides_.at(master.name), most_overlap(master, master));
        std::int32_t at = -1;
        for (const Edge* chain : surface_chains(master, pair.master.edge)) {
            for (const std::int32_t node : chain->nodes) {
                const double depth = -distance(wall, mesh_.nodes[static_cast<std::size_t>(node)]);
                if (depth > deepest) {
                    deepest = depth;
                    at = node;
                }
            }
        }
        if (at < 0) return;
        faults_.error(
            pair.place,
            fmt::format(
                "contact '{}': body '{}' reaches {:.6g} {} into wall '{}' at {}; move it out of the wall, or "
                "turn the wall's normal if it faces the wrong way",
                pair.name, master.name, deepest, scene_.units.length_name(), wall.name,
                text(mesh_.nodes[static_cast<std::size_t>(at)])));
    }

    /// A node on both sides of a pair would be master and slave of itself.
    void check_disjoint(const ContactPair& pair, const MeshBody& body) const {
        const auto *a = find_edge(body, pair.master.edge), *b = find_edge(body, pair.slave.edge);
        auto nodes = a->nodes;
        std::sort(nodes.begin(), nodes.end());
        const auto shared = std::find_if(b->nodes.begin(), b->nodes.end(), [&](std::int32_t node) {
            return std::binary_search(nodes.begin(), nodes.end(), node);
        });
        if (shared == b->nodes.end()) return;
        faults_.error(
            pair.place,
            fmt::format("contact '{}': edges '{}' and '{}' share the node at {}; contact of a body "
                        "with itself needs edges without common nodes",
                        pair.name, a->name, b->name, text(mesh_.nodes[static_cast<std::size_t>(*shared)])));
    }

    const Scene& scene_;
    const Mesh& mesh_;
    Faults& faults_;
    std::map<std::string, const MeshBody*> bodies_;
    std::map<std::string, double> sides_;
    std::map<std::string, SegmentTree> trees_;
};

}  // namespace

void check_mesh(const Scene& scene, const Mesh& mesh) {
    Faults faults(scene.file, scene.overrides);
    MeshCheck check(scene, mesh, faults);
    for (const auto& pair : scene.contacts) check.check_pair(pair);
    for (const auto& probe : scene.probes) check.check_probe(probe);
    for (const auto& body : scene.bodies) check.check_constraints(body);
    check.check_massless();
    faults.throw_if_any();
}

}  // namespace percuss
