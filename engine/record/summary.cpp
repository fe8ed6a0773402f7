#include "record/summary.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "record/analysis_summary.hpp"
#include "record/summary_history.hpp"
#include "run/fields.hpp"
#include "run/force_error.hpp"
#include "scene/scheme_names.hpp"

namespace percuss {
namespace {

using Json = nlohmann::ordered_json;
using Names = std::array<std::string, 2>;

Json by_direction(const Names& names, const std::array<double, 2>& values) {
    return {{names[0], values[0]}, {names[1], values[1]}};
}

double ratio(double a, double b) { return b > 0 ? a / b : 0; }

Json wall_seconds(const RunStatistics& statistics) {
    const PhaseSeconds& s = statistics.seconds;
    return {{"elements", s.elements},
            {"contact_search", s.contact_search},
            {"contact_solve", s.contact_solve},
            {"integrate", s.integrate},
            {"critical_step", s.critical_step},
            {"loads", s.loads},
            {"probes", s.probes},
            {"history", s.history},
            {"record", s.record},
            {"render", s.render},
            {"step_total", statistics.step_seconds},
            {"total", statistics.total_seconds}};
}

Json energy(const Scene& scene, const RunStatistics& statistics, const Energies& last) {
    Json result{{"initial", statistics.initial_energy},
                {"final", last.kinetic + last.internal},
                {"maximum_growth", statistics.maximum_growth},
                {"maximum_loss", statistics.maximum_loss},
                {"elastic_error", statistics.elastic_energy_error},
                {"kinetic", last.kinetic},
                {"internal", last.internal},
                {"hourglass", last.hourglass},
                {"viscous", last.viscous},
                {"plastic", last.plastic},
                {"contact", last.contact},
                {"contact_in", statistics.contact_energy_in},
                {"external", last.external},
                {"balance", last.balance()}};
    if (has_friction(scene)) result["friction"] = last.friction;
    return result;
}

Json momentum(const RunStatistics& statistics, const Names& names, Geometry geometry) {
    const auto& [before, after] = std::pair(statistics.momentum_initial, statistics.momentum_final);
    // Radial components of a ring cancel: they carry no momentum of the whole.
    const std::array<double, 2>& impulse = statistics.external_impulse;
    const auto missing = [&](std::size_t d) { return std::abs(after[d] - before[d] - impulse[d]); };
    const double change = geometry == Geometry::axisymmetric ? missing(1) : std::max(missing(0), missing(1));
    Json result{{"initial", by_direction(names, before)},
                {"final", by_direction(names, after)},
                {"external_impulse", by_direction(names, impulse)},
                {"error", ratio(change, statistics.momentum_scale + statistics.external_impulse_gross)}};
    if (geometry != Geometry::axisymmetric) {
        result["angular_initial"] = statistics.angular_momentum_initial;
        result["angular_final"] = statistics.angular_momentum_final;
    }
    return result;
}

Json contacts(const Scene& scene, const RunStatistics& statistics, const History& history,
              const Names& names) {
    Json result = Json::object();
    for (std::size_t p = 0; p < std::min(scene.contacts.size(), statistics.pairs.size()); ++p) {
        const PairStatistics& pair = statistics.pairs[p];
        Json& contact = result[scene.contacts[p].name];
        contact = {{"peak_force", pair.peak_force},           {"impulse", by_direction(names, pair.impulse)},
                   {"open_close_events", pair.events},        {"node_openings", pair.openings},
                   {"node_closings", pair.closings},          {"negative_forces", pair.negative_forces},
                   {"max_penetration", pair.max_penetration}, {"work", pair.work}};
        if (scene.contacts[p].friction > 0) contact["friction_work"] = pair.friction_work;
        contact.update(contact_history(history, scene.contacts[p].name, names));
    }
    return result;
}

Json contact_solver(const Scene& scene, const RunStatistics& statistics) {
    const ContactSolverStatistics& s = statistics.contact_solver;
    const auto problems = static_cast<double>(s.problems);
    const ContactScheme scheme = scene.contact_solver.scheme;
    if (scheme == ContactScheme::projection || (scheme == ContactScheme::penalty && !has_friction(scene)))
        return {{"scheme", name_of(scheme)}};
    Json result{{"scheme", name_of(scheme)},
                {"problems", s.problems},
                {"rows_mean", ratio(static_cast<double>(s.rows), problems)},
                {"rows_max", s.most_rows},
                {"iterations_mean", ratio(static_cast<double>(s.iterations), problems)},
                {"iterations_max", s.most_iterations},
                {"fallbacks", s.fallbacks}};
    if (has_friction(scene))
        result["friction"] = {{"solutions", s.friction_solutions},
                              {"rounds_mean", ratio(static_cast<double>(s.friction_rounds),
                                                    static_cast<double>(s.friction_solutions))},
                              {"rounds_max", s.most_friction_rounds},
                              {"unsettled", s.unsettled}};
    return result;
}

/// Smallest and largest coordinate of a body's nodes.
Json extent(const Mesh& mesh, const Snapshot& last, std::size_t body, const Names& names) {
    Json result = Json::object();
    const MeshBody& part = mesh.bodies[body];
    for (std::size_t d = 0; d < 2; ++d) {
        double least = std::numeric_limits<double>::infinity(), most = -least;
        for (auto n = static_cast<std::size_t>(part.node_begin); n < static_cast<std::size_t>(part.node_end);
             ++n) {
            least = std::min(least, last.position[2 * n + d]);
            most = std::max(most, last.position[2 * n + d]);
        }
        result[names[d]] = {{"min", least}, {"max", most}, {"length", most - least}};
    }
    return result;
}

Json parameters(const Scene& scene) {
    Json result = Json::object();
    for (const Parameter& parameter : scene.parameters) result[parameter.name] = parameter.value;
    return result;
}

Json bodies(const RunSetup& setup, const RunStatistics& statistics, const History& history,
            const Snapshot& last, const Names& names) {
    const Scene& scene = setup.scene;
    Json result = Json::object();
    for (std::size_t b = 0; b < std::min(scene.bodies.size(), last.bodies.size()); ++b) {
        Json& body = result[scene.bodies[b].name];
        body = {{"velocity", by_direction(names, last.bodies[b].velocity)},
                {"extent", extent(setup.mesh, last, b, names)}};
        body.update(body_history(history, scene.bodies[b].name, names));
        if (b < statistics.bodies.size()) {
            const BodyEnergies& e = statistics.bodies[b];
            body["energy"] = {{"kinetic", e.kinetic},
                              {"elastic", e.elastic},
                              {"plastic", e.plastic},
                              {"hourglass", e.hourglass},
                              {"viscous", e.viscous}};
        }
        if (!last.plastic_strain.empty()) {
            const auto cells = last.plastic_strain.begin();
            const MeshBody& part = setup.mesh.bodies[b];
            body["plastic_strain_max"] = *std::max_element(cells + part.cell_begin, cells + part.cell_end);
        }
    }
    return result;
}

Json exact_answers(const Scene& scene, const History& history) {
    Json result = Json::object();
    if (scene.exact.empty() || history.rows() < 2) return result;
    const std::vector<double> time = history.values("time");
    for (const ExactHistory& exact : scene.exact) {
        std::vector<double> force = history.values(exact.quantity);
        force.resize(std::min(force.size(), time.size()));
        const auto times = std::span(time).first(force.size());
        result[exact.quantity] = {
            {"error", force_error(times, force, exact.points, 0, scene.duration)},
            {"error_averaged", force_error(times, force, exact.points, exact.window, scene.duration)},
            {"window", exact.window},
            {"first_sample", first_sample(force, exact.points)}};
    }
    return result;
}

const char* status_name(RunStatus status) {
    switch (status) {
        case RunStatus::finished:
            return "finished";
        case RunStatus::diverged:
            return "diverged";
        default:
            return "interrupted";
    }
}

Json unit_labels(const Units& units) {
    Json result = Json::object();
    for (const auto& [name, quantity] :
         {std::pair{"length", Quantity::length}, std::pair{"time", Quantity::time},
          std::pair{"mass", Quantity::mass}, std::pair{"velocity", Quantity::velocity},
          std::pair{"force", Quantity::force}, std::pair{"stress", Quantity::stress},
          std::pair{"energy", Quantity::energy}, std::pair{"momentum", Quantity::impulse}}) {
        result[name] = units.label(quantity);
    }
    return result;
}

}  // namespace

nlohmann::ordered_json make_summary(const RunSetup& setup, const RunStatistics& statistics,
                                    const History& history, const Snapshot& last) {
    const Scene& scene = setup.scene;
    const Names names = direction_names(scene.geometry);
    const PhaseSeconds& seconds = statistics.seconds;
    Json summary;
    summary["percuss"] = PERCUSS_VERSION;
    summary["scene"] = scene.title;
    summary["parameters"] = parameters(scene);
    summary["status"] = status_name(last.status);
    summary["message"] = last.message;
    if (last.failed_cell >= 0) summary["failed_element"] = last.failed_cell;
    summary["time"] = last.time;
    summary["steps"] = statistics.steps;
    summary["elements"] = statistics.cells;
    summary["visited_share"] = statistics.visited_share;
    summary["threads"] = statistics.threads;
    summary["wall_seconds"] = wall_seconds(statistics);
    summary["contact_share"] = ratio(seconds.contact_search + seconds.contact_solve, statistics.step_seconds);
    summary["element_steps_per_second"] =
        ratio(static_cast<double>(statistics.steps) * static_cast<double>(statistics.cells),
              statistics.step_seconds);
    summary["dt_min"] = statistics.dt_min;
    summary["dt_max"] = statistics.dt_max;
    summary["critical_step"] = statistics.critical_step_initial;
    summary["critical_step_min"] = statistics.critical_step_min;
    summary["energy"] = energy(scene, statistics, last.energy);
    summary["energy_budget"] = budget_summary(last);
    summary["momentum"] = momentum(statistics, names, scene.geometry);
    if (!scene.contacts.empty()) summary["contact_solver"] = contact_solver(scene, statistics);
    Json& pairs = summary["contact"] = contacts(scene, statistics, history, names);
    Json of_bodies = bodies(setup, statistics, history, last, names);
    Json analysis = analyse(scene, history, pairs, of_bodies);
    summary["body"] = std::move(of_bodies);
    summary["analysis"] = std::move(analysis);
    summary["exact"] = exact_answers(scene, history);
    summary["state_hash"] = statistics.state_hash;
    summary["units"] = unit_labels(scene.units);
    return summary;
}

}  // namespace percuss
