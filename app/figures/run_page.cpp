#include "figures/run_page.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "exit_status.hpp"
#include "run/fields.hpp"

namespace percuss::app {
namespace {

bool declares(const std::vector<FigureSpec>& figures, FigureKind kind) {
    return std::any_of(figures.begin(), figures.end(), [&](const FigureSpec& f) { return f.kind == kind; });
}

FigureSpec inferred(FigureKind kind, const std::string& name, const std::string& title) {
    FigureSpec figure;
    figure.kind = kind;
    figure.name = name;
    figure.title = title;
    return figure;
}

/// One history of all owners in the scene's main direction.
FigureSpec inferred_history(const Scene& scene, const std::string& name, const std::string& title,
                            const std::string& kind, const std::string& quantity,
                            const std::vector<std::string>& owners) {
    FigureSpec figure = inferred(FigureKind::history, name, title);
    figure.value_title = title;
    for (const std::string& owner : owners) {
        figure.columns.push_back(
            fmt::format("{}.{}.{}{}", kind, owner, quantity, direction_names(scene.geometry)[1]));
        figure.labels.push_back(owner);
    }
    return figure;
}

}  // namespace

RunPage make_run_page(const RecordedRun& run, const FigureSpec& figure) {
    switch (figure.kind) {
        case FigureKind::history:
            return make_history_page(run, figure);
        case FigureKind::mesh:
            return make_mesh_page(run, figure);
        case FigureKind::space_time:
            return make_space_time_page(run, figure);
        case FigureKind::surface_forces:
            return make_surface_forces_page(run, figure);
        case FigureKind::clamping:
            return make_clamping_page(run, figure);
        case FigureKind::energy:
            return make_energy_page(run, figure);
    }
    return {};
}

std::vector<FigureSpec> all_figures(const RecordedRun& run) {
    const Scene& scene = run.setup->scene;
    std::vector<FigureSpec> figures = scene.figures;
    const auto add = [&](FigureSpec figure) {
        const bool taken = std::any_of(figures.begin(), figures.end(),
                                       [&](const FigureSpec& other) { return other.name == figure.name; });
        if (!taken) figures.push_back(std::move(figure));
    };
    std::vector<std::string> pairs, bodies;
    for (const ContactPair& pair : scene.contacts) pairs.push_back(pair.name);
    for (const Body& body : scene.bodies) bodies.push_back(body.name);
    if (!declares(scene.figures, FigureKind::history)) {
        if (!pairs.empty()) {
            FigureSpec forces = inferred_history(scene, "forces", "contact force", "contact", "", pairs);
            forces.window = scene.analysis.window.value_or(scene.duration / 200);
            add(std::move(forces));
        }
        add(inferred_history(scene, "velocities", "mean velocity", "body", "velocity.", bodies));
    }
    if (!declares(scene.figures, FigureKind::mesh) && run.frames.size() > 0) {
        FigureSpec mesh = inferred(FigureKind::mesh, "mesh", "Deformed mesh");
        const double end = run.frames.times.back();
        mesh.times = {0, 0.5 * end, end};
        mesh.region = scene.view.window;
        add(std::move(mesh));
    }
    if (!declares(scene.figures, FigureKind::clamping) && !pairs.empty()) {
        FigureSpec clamping = inferred(FigureKind::clamping, "clamping", "Forces between the bodies");
        clamping.columns = pairs;
        add(std::move(clamping));
    }
    if (!declares(scene.figures, FigureKind::energy) && run.frames.size() > 1 &&
        !run.frames[0]->body_energies.empty())
        add(inferred(FigureKind::energy, "energy", "Where the energy went"));
    return figures;
}

std::shared_ptr<const Snapshot> frame_near(const RunFrames& frames, double time) {
    if (frames.size() == 0) throw UsageError("the run has no complete frame");
    const std::vector<double>& times = frames.times;
    const auto nearest = std::min_element(times.begin(), times.end(), [&](double a, double b) {
        return std::abs(a - time) < std::abs(b - time);
    });
    return frames[static_cast<std::size_t>(nearest - times.begin())];
}

std::string titled(const std::string& title, const std::string& unit) {
    return unit.empty() ? title : fmt::format("{} [{}]", title, unit);
}

DisplayUnit time_unit(const RecordedRun& run) {
    const Scene& scene = run.setup->scene;
    return scene.units.display(Quantity::time, scene.duration);
}

std::array<double, 2> time_range(const RecordedRun& run, const FigureSpec& figure) {
    const double scale = time_unit(run).scale;
    const auto shown = figure.time.value_or(std::array{0.0, run.setup->scene.duration});
    return {scale * shown[0], scale * shown[1]};
}

std::string coordinate_name(const Scene& scene, std::size_t direction) {
    if (scene.geometry == Geometry::axisymmetric) return direction == 0 ? "r" : "z";
    return direction == 0 ? "x" : "y";
}

}  // namespace percuss::app
