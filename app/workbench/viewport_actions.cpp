#include "workbench/viewport_actions.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "view/bodies.hpp"
#include "view/probe_marks.hpp"

namespace percuss::app {
namespace {

std::array<double, 2> place_of_node(const Workbench& w, const Snapshot& snapshot, std::int32_t node) {
    const auto at = 2 * static_cast<std::size_t>(node);
    return w.viewport.view->plane()(snapshot.position[at], snapshot.position[at + 1]);
}

/// The node of a new mesh that is nearest to where the followed one began; its offset stays.
void find_again(Workbench& w, const RunSetup& setup) {
    FollowedNode& followed = *w.marks.followed;
    const auto body = std::find_if(setup.mesh.bodies.begin(), setup.mesh.bodies.end(),
                                   [&](const MeshBody& b) { return b.name == followed.body; });
    if (body == setup.mesh.bodies.end()) {
        stop_following(w);
        return;
    }
    const Probe probe{
        "", followed.body, Vec2(followed.start[0], followed.start[1]), {"velocity.magnitude"}, {}};
    followed.node = bind_probe(setup.scene, setup.mesh, probe).front().node;
}

void take_setup(Workbench& w, const std::shared_ptr<const RunSetup>& setup) {
    ViewportMarks& m = w.marks;
    if (m.setup == setup) return;
    const std::string pair =
        m.setup && m.pair < m.setup->scene.contacts.size() ? m.setup->scene.contacts[m.pair].name : "";
    m.setup = setup;
    m.sides.clear();
    m.menu = {};
    m.clicked.reset();
    m.scene_probes.clear();
    for (const Probe& probe : setup->scene.probes)
        m.scene_probes.push_back({probe, bind_probe(setup->scene, setup->mesh, probe), nullptr});
    if (m.pairs == ViewportMarks::Pairs::one) {  // by its name
        const auto& contacts = setup->scene.contacts;
        const auto same = std::find_if(contacts.begin(), contacts.end(),
                                       [&](const ContactPair& c) { return c.name == pair; });
        m.pair = static_cast<std::size_t>(same - contacts.begin());
        if (same == contacts.end()) m.pairs = ViewportMarks::Pairs::none;
    }
    if (m.followed) find_again(w, *setup);
}

}  // namespace

void add_probe_at(Workbench& w, const render::Picked& place, const std::string& field) {
    const RunSetup& setup = *w.run.snapshot()->setup;
    Probe probe;
    probe.name = free_probe_name(setup.scene, w.run.probes());
    probe.body = setup.mesh.bodies[static_cast<std::size_t>(place.body)].name;
    probe.record = {field};
    if (find_field(setup.scene, field).per_cell) {
        const Cell& cell = setup.mesh.cells[static_cast<std::size_t>(place.cell)];
        const int corners = corner_count(cell);
        for (int i = 0; i < corners; ++i)
            probe.at +=
                setup.mesh.nodes[static_cast<std::size_t>(cell[static_cast<std::size_t>(i)])] / corners;
    } else {
        probe.at = setup.mesh.nodes[static_cast<std::size_t>(place.node)];
    }
    w.run.add_probe(std::move(probe));
}

void remove_all_probes(Workbench& w) {
    const std::vector<Probe> probes = w.run.probes();
    for (const Probe& probe : probes) w.run.remove_probe(probe.name);
}

void follow_node(Workbench& w, std::int32_t node) {
    ViewportState& v = w.viewport;
    const Mesh& mesh = v.drawn->setup->mesh;
    const auto body = std::find_if(mesh.bodies.begin(), mesh.bodies.end(), [&](const MeshBody& b) {
        return b.node_begin <= node && node < b.node_end;
    });
    if (body == mesh.bodies.end()) return;  // of a wall: it never moves
    const Vec2& start = mesh.nodes[static_cast<std::size_t>(node)];
    w.marks.followed = FollowedNode{node, body->name, {start.x(), start.y()}, {}};
    move_camera(w, v.view->camera());
}

void stop_following(Workbench& w) { w.marks.followed.reset(); }

void zoom_to(Workbench& w, std::size_t body) {
    ViewportState& v = w.viewport;
    if (!v.view || !v.drawn) return;
    stop_following(w);
    move_camera(w, v.view->around(render::body_boxes(*v.drawn, v.view->plane())[body]));
}

void move_camera(Workbench& w, const render::LiveCamera& camera) {
    ViewportState& v = w.viewport;
    v.camera = camera;
    v.framing = Framing::chosen;
    v.dirty = true;
    if (!w.marks.followed || !v.drawn) return;
    const auto node = place_of_node(w, *v.drawn, w.marks.followed->node);
    for (std::size_t k = 0; k < 2; ++k) w.marks.followed->offset[k] = camera.centre[k] - node[k];
}

void follow_run(Workbench& w) {
    ViewportMarks& m = w.marks;
    m.hovered_pair.reset();
    m.hovered_probe.clear();
    if (!w.run.snapshot()) return;
    take_setup(w, w.run.snapshot()->setup);
    const bool none = m.probes.all().empty();
    if (!m.probes.follow(w.run)) return;
    ++m.probe_changes;
    m.list_probes = none && !m.probes.all().empty();
}

std::optional<std::array<double, 2>> centre_after_node(const Workbench& w, const Snapshot& shown) {
    const ViewportMarks& m = w.marks;
    if (!m.followed || w.viewport.framing != Framing::chosen || m.setup != shown.setup) return std::nullopt;
    auto centre = place_of_node(w, shown, m.followed->node);
    for (std::size_t k = 0; k < 2; ++k) centre[k] += m.followed->offset[k];
    return centre;
}

void move_after_node(Workbench& w, const Snapshot& shown) {
    if (const auto centre = centre_after_node(w, shown); centre && w.viewport.camera)
        w.viewport.camera->centre = *centre;
}

void paint_marks(const Workbench& w, const render::LiveView& view, const Snapshot& now, double scale,
                 render::Canvas& canvas) {
    const ViewportMarks& m = w.marks;
    if (m.setup != now.setup) return;
    const render::Rect& area = view.model();
    for (std::size_t p = 0; p < m.sides.size(); ++p) {
        const bool shown = m.hovered_pair ? *m.hovered_pair == p
                                          : m.pairs == ViewportMarks::Pairs::all ||
                                                (m.pairs == ViewportMarks::Pairs::one && m.pair == p);
        if (shown)
            render::paint_contact_sides(canvas, now, m.sides[p], view.plane(), view.fit(), area, scale);
    }
    const auto paint = [&](const ProbeCurve& probe) {
        const auto at = place_of(now, probe.readings.front());
        const auto place = view.fit()(view.plane()(at[0], at[1]));
        if (area.contains({place[0], place[1], 0, 0}))
            render::paint_probe(canvas, place, probe.probe.name, scale, probe.probe.name == m.hovered_probe);
    };
    for (const ProbeCurve& probe : m.scene_probes)
        if (!probe.readings.empty()) paint(probe);
    for (const ProbeCurve& probe : m.probes.all()) paint(probe);
    if (m.followed)
        render::paint_follow_mark(canvas, view.fit()(place_of_node(w, now, m.followed->node)), scale);
}

}  // namespace percuss::app
