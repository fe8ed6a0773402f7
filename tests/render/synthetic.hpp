#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

#include "image.hpp"
#include "run/history.hpp"
#include "run/snapshot.hpp"

/// Scenes and snapshots made by hand, so that pictures are tested without parser and solver.
namespace percuss::synthetic {

/// Adds a body meshed as nx by ny quads over [x0, x1] x [y0, y1], with its outline.
inline void add_rectangle(RunSetup& setup, const std::string& name, std::array<double, 4> box, int nx, int ny,
                          std::array<double, 2> velocity = {0, 0}) {
    Mesh& mesh = setup.mesh;
    MeshBody body;
    body.name = name;
    body.node_begin = mesh.node_count();
    body.cell_begin = mesh.cell_count();
    const auto node = [&](int i, int j) { return body.node_begin + j * (nx + 1) + i; };
    for (int j = 0; j <= ny; ++j)
        for (int i = 0; i <= nx; ++i)
            mesh.nodes.emplace_back(box[0] + (box[2] - box[0]) * i / nx, box[1] + (box[3] - box[1]) * j / ny);
    for (int j = 0; j < ny; ++j)
        for (int i = 0; i < nx; ++i)
            mesh.cells.push_back({node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)});
    Edge outline{"outline", {}, true};
    for (int i = 0; i < nx; ++i) outline.nodes.push_back(node(i, 0));
    for (int j = 0; j < ny; ++j) outline.nodes.push_back(node(nx, j));
    for (int i = nx; i > 0; --i) outline.nodes.push_back(node(i, ny));
    for (int j = ny; j > 0; --j) outline.nodes.push_back(node(0, j));
    body.outlines.push_back(outline);
    body.node_end = mesh.node_count();
    body.cell_end = mesh.cell_count();
    mesh.bodies.push_back(body);
    Body described;
    described.name = name;
    described.material = "steel";
    described.velocity = velocity;
    setup.scene.bodies.push_back(described);
}

inline std::shared_ptr<RunSetup> empty_setup(Geometry geometry, double duration) {
    auto setup = std::make_shared<RunSetup>();
    setup->scene.title = "Two bodies";
    setup->scene.geometry = geometry;
    setup->scene.duration = duration;
    Material steel;
    steel.name = "steel";
    steel.density = 7.85e-6;
    steel.young = 210;
    setup->scene.materials.push_back(steel);
    ContactPair pair;
    pair.name = "impact";
    setup->scene.contacts.push_back(pair);
    return setup;
}

/// The undeformed state at time 0, without stress or contact.
inline Snapshot at_rest(const std::shared_ptr<const RunSetup>& setup) {
    Snapshot snapshot;
    snapshot.setup = setup;
    for (const Vec2& node : setup->mesh.nodes) {
        snapshot.position.push_back(node[0]);
        snapshot.position.push_back(node[1]);
    }
    snapshot.velocity.assign(snapshot.position.size(), 0);
    snapshot.stress.assign(setup->mesh.cells.size(), StressMean{});
    snapshot.pairs.resize(setup->scene.contacts.size());
    for (const Body& body : setup->scene.bodies) snapshot.bodies.push_back({body.velocity});
    return snapshot;
}

/// Two rods end to end along z, radius 10 mm, 100 and 200 mm long, that touch at z = 100 mm.
inline std::shared_ptr<RunSetup> rods(int radial = 5, int first = 50, int second = 100) {
    auto setup = empty_setup(Geometry::axisymmetric, 0.06);
    setup->scene.title = "Two rods, end to end";
    add_rectangle(*setup, "striker", {0, 0, 10, 100}, radial, first, {0, 10});
    add_rectangle(*setup, "long rod", {0, 100, 10, 300}, radial, second);
    setup->scene.view.up = VerticalAxis::first;
    setup->scene.view.field = "stress.axial";
    return setup;
}

/// The rods in contact: a square pulse of 203 MPa that has run `reach` mm both ways, force on the faces'
/// nodes.
inline Snapshot rods_in_contact(const std::shared_ptr<const RunSetup>& setup, double time, double reach) {
    Snapshot snapshot = at_rest(setup);
    snapshot.time = time;
    const Mesh& mesh = setup->mesh;
    for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
        double z = 0;
        for (const auto node : mesh.cells[c]) z += 0.25 * mesh.nodes[static_cast<std::size_t>(node)][1];
        const double front = std::abs(z - 100) - reach;
        snapshot.stress[c][1] = -0.203 / (1 + std::exp(0.6 * front));
    }
    for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
        const Vec2& at = mesh.nodes[i];
        if (at[1] != 100) continue;
        const bool master = static_cast<std::int32_t>(i) >= mesh.bodies[1].node_begin;
        const double share = at[0] == 0 ? 0.4 : at[0] == 10 ? 7 : 1.6 * at[0];
        snapshot.contact_forces.push_back(
            {static_cast<std::int32_t>(i), 0, master, {0, (master ? 1 : -1) * share * 1.4}});
    }
    snapshot.bodies[0].velocity = {0, 10 - 260 * time};
    snapshot.bodies[1].velocity = {0, 130 * time};
    return snapshot;
}

/// A column of `rows` steps over [0, duration]: contact force, velocities, energies of the rods.
inline std::unique_ptr<History> rods_history(double duration, int rows) {
    auto history = std::make_unique<History>(std::vector<HistoryColumn>{
        {"time", Quantity::time},
        {"contact.impact.axial", Quantity::force},
        {"contact.impact.radial", Quantity::force},
        {"body.striker.velocity.axial", Quantity::velocity},
        {"body.striker.velocity.radial", Quantity::velocity},
        {"body.long rod.velocity.axial", Quantity::velocity},
        {"body.long rod.velocity.radial", Quantity::velocity},
        {"energy.kinetic", Quantity::energy},
        {"energy.internal", Quantity::energy},
        {"energy.contact", Quantity::energy},
    });
    for (int i = 0; i < rows; ++i) {
        const double t = duration * i / (rows - 1);
        const bool on = t > 0.001 && t < 0.0397;
        const double p = std::clamp((t - 0.001) / 0.0387, 0.0, 1.0);
        const double force = on ? 63.8 * (1 + 0.15 * std::exp(-300 * (t - 0.001)) * std::cos(4000 * t)) : 0;
        const double kinetic = 12.33 * (1 - 0.5 * (1 - std::abs(2 * p - 1)));
        const std::array<double, 10> row{t,     force, 0,       10 * (1 - p),    0,
                                         5 * p, 0,     kinetic, 12.27 - kinetic, -0.06 * (p > 0)};
        history->append(row);
    }
    return history;
}

/// Two blocks side by side in the plane, the upper one falling on the lower one. 5,000 quads.
inline std::shared_ptr<RunSetup> blocks(int nx = 50, int ny = 50) {
    auto setup = empty_setup(Geometry::plane_strain, 0.2);
    setup->scene.title = "Block on block";
    add_rectangle(*setup, "lower", {-30, 0, 30, 40}, nx, ny);
    add_rectangle(*setup, "upper", {-20, 40, 20, 70}, nx, ny, {1.5, -4});
    return setup;
}

inline Snapshot blocks_in_contact(const std::shared_ptr<const RunSetup>& setup, double time) {
    Snapshot snapshot = at_rest(setup);
    snapshot.time = time;
    const Mesh& mesh = setup->mesh;
    for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
        Vec2 at = Vec2::Zero();
        for (const auto node : mesh.cells[c]) at += 0.25 * mesh.nodes[static_cast<std::size_t>(node)];
        const double depth = std::hypot(at[0] / 20, (at[1] - 40) / 20);
        snapshot.stress[c] = {-0.05 / (1 + depth), -0.3 / (1 + depth * depth), -0.1 / (1 + depth),
                              0.02 * at[0] / 20};
    }
    for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
        const Vec2& at = mesh.nodes[i];
        snapshot.position[2 * i] += 0.4 * std::sin(at[1] / 12);
        const bool master = static_cast<std::int32_t>(i) >= mesh.bodies[1].node_begin;
        if (at[1] == 40 && std::abs(at[0]) <= 20 && (static_cast<int>(i) % 3 == 0))
            snapshot.contact_forces.push_back(
                {static_cast<std::int32_t>(i),
                 0,
                 master,
                 {0.1 * (master ? 1 : -1), (master ? 1 : -1) * (2 - at[0] * at[0] / 250)}});
    }
    return snapshot;
}

/// Pixels of a rectangle {left, top, right, bottom} (top row first) for which `test(r, g, b)` holds.
template <class Test>
int count_pixels(const render::Image& image, std::array<int, 4> where, const Test& test) {
    int count = 0;
    for (int y = std::max(0, where[1]); y < std::min(image.height, where[3]); ++y)
        for (int x = std::max(0, where[0]); x < std::min(image.width, where[2]); ++x) {
            const auto* p = image.pixels.data() +
                            3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                                 static_cast<std::size_t>(x));
            if (test(p[0], p[1], p[2])) ++count;
        }
    return count;
}

}  // namespace percuss::synthetic
