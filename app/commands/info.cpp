#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <string_view>

#include <fmt/format.h>

#include "commands.hpp"
#include "effects.hpp"
#include "options.hpp"
#include "report.hpp"
#include "solver.hpp"

namespace percuss::app {
namespace {

std::string_view geometry_name(Geometry geometry) {
    switch (geometry) {
        case Geometry::axisymmetric:
            return "axisymmetric";
        case Geometry::plane_strain:
            return "plane strain";
        case Geometry::plane_stress:
            return "plane stress";
    }
    return "";
}

std::string_view kind_name(ElementKind kind) {
    switch (kind) {
        case ElementKind::quad_one_point:
            return "one-point quads";
        case ElementKind::quad_mean_dilatation:
            return "mean-dilatation quads";
        case ElementKind::triangle:
            return "triangles";
        case ElementKind::triangle_averaged:
            return "averaged triangles";
    }
    return "";
}

void print_bodies(const Solver& solver) {
    const RunSetup& setup = *solver.setup();
    const Scene& scene = setup.scene;
    const std::vector<double>& lumped = solver.lumped_mass();
    fmt::print("\n{:<16} {:>9} {:>9}  {:<22} {:<12} {:>12}  {}\n", "body", "elements", "nodes", "kind",
               "material", "mass", "initial velocity");
    double total = 0;
    for (std::size_t b = 0; b < setup.mesh.bodies.size(); ++b) {
        const MeshBody& meshed = setup.mesh.bodies[b];
        const Body& body = scene.bodies[b];
        const double mass = solver.scale() * std::accumulate(lumped.begin() + meshed.node_begin,
                                                             lumped.begin() + meshed.node_end, 0.0);
        total += mass;
        const std::string unit = scene.units.label(Quantity::velocity);
        fmt::print("{:<16} {:>9} {:>9}  {:<22} {:<12} {:>12}  ({:.4g}, {:.4g}) {}\n", body.name,
                   meshed.cell_end - meshed.cell_begin, meshed.node_end - meshed.node_begin,
                   kind_name(meshed.kind), body.material, with_unit(scene.units, Quantity::mass, mass),
                   body.velocity[0], body.velocity[1], unit);
    }
    fmt::print("{:<16} {:>9} {:>9}  {:<22} {:<12} {:>12}\n", "together", setup.mesh.cell_count(),
               setup.mesh.node_count(), "", "", with_unit(scene.units, Quantity::mass, total));
}

void print_step(const Scene& scene, double critical_step, double by_power_iteration) {
    const double dt = scene.step.fixed.value_or(scene.step.courant * critical_step);
    fmt::print("\nduration       {}\n", with_unit(scene.units, Quantity::time, scene.duration));
    fmt::print("critical step  {} at the start, from the elements; {} by power iteration\n",
               with_unit(scene.units, Quantity::time, critical_step),
               with_unit(scene.units, Quantity::time, by_power_iteration));
    fmt::print("step           {}, {:.3g} of critical{}\n", with_unit(scene.units, Quantity::time, dt),
               dt / critical_step, scene.step.fixed ? ", fixed" : "");
    fmt::print("steps to come  {}{:.0f}\n", scene.step.fixed ? "" : "about ",
               std::ceil(scene.duration / dt - 1e-9));
}

/// Its texts as they are wrapped in the file.
void print_lesson(const Scene& scene) {
    if (!scene.lesson) return;
    const Lesson& lesson = *scene.lesson;
    fmt::print("\nLesson: {}\n\n{}\n\nQuestion: {}\nMove:     {}\nLook for: {}\n\nAnswer:   {}\n",
               lesson.title, lesson.text, lesson.question, lesson.control, lesson.look_for, lesson.answer);
}

int info(const SceneOptions& options) {
    const Solver solver(load(options));
    const Scene& scene = solver.setup()->scene;
    fmt::print("{}: {}\n{}, units {}, {}, {}\n", options.file, scene.title, geometry_name(scene.geometry),
               scene.units.length_name(), scene.units.time_name(), scene.units.mass_name());
    print_bodies(solver);
    for (const ContactPair& pair : scene.contacts) {
        const auto surface = [](const SurfaceName& name) {
            return name.edge.empty() ? name.body : name.body + "." + name.edge;
        };
        fmt::print("contact {}: master nodes of {} on slave sides of {}\n", pair.name, surface(pair.master),
                   surface(pair.slave));
    }
    print_step(scene, solver.critical_step(), solver.critical_step_by_power_iteration());
    fmt::print("\n{:<34} {:<4} {}\n", "effect", "", "cost");
    for (const EffectInfo& effect : effects_of(scene)) {
        fmt::print("{:<34} {:<4} {}\n", effect.name, effect.on ? "on" : "off", effect.cost);
    }
    print_lesson(scene);
    return 0;
}

}  // namespace

void add_info(CLI::App& app, Job& job) {
    auto options = std::make_shared<SceneOptions>();
    CLI::App& command =
        *app.add_subcommand("info", "Bodies, masses, critical step, steps to come, effects and their cost");
    add_scene_options(command, *options);
    command.callback([&job, options] { job = [options] { return info(*options); }; });
}

}  // namespace percuss::app
