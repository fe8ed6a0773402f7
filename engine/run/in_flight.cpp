#include "run/in_flight.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace percuss {
namespace {

using Names = std::string_view;

/// Tables and keys that are read when pictures, records and summaries are made.
constexpr std::array beside_the_run{Names("title"),  Names("description"), Names("view"),     Names("record"),
                                    Names("expect"), Names("exact"),       Names("analysis"), Names("lesson"),
                                    Names("study"),  Names("accuracy")};

/// Keys of a figure that say how it is drawn, not what is sampled for it.
constexpr std::array drawn{Names("title"),  Names("time"),       Names("range"),  Names("columns"),
                           Names("labels"), Names("axis"),       Names("factor"), Names("window"),
                           Names("times"),  Names("colour_map"), Names("along"),  Names("bins"),
                           Names("pairs"),  Names("direction")};

template <class List>
bool contains(const List& list, std::string_view name) {
    return std::find(list.begin(), list.end(), name) != list.end();
}

/// Takes the part before the first dot off the key.
std::string_view take(std::string_view& key) {
    const std::string_view part = key.substr(0, key.find('.'));
    key.remove_prefix(std::min(key.size(), part.size() + 1));
    return part;
}

}  // namespace

ChangeEffect effect_of_change(std::string_view key) {
    if (key == "model.step" || key.starts_with("model.step.")) return ChangeEffect::next_step;
    // Quoted names may hold dots: only before them is it clear which part is which.
    const bool quoted = key.find('"') != std::string_view::npos;
    const std::string_view table = take(key);
    if (contains(beside_the_run, table)) return ChangeEffect::none;
    if (table != "figure" || quoted) return ChangeEffect::rebuild;
    take(key);  // the figure's name or index
    return contains(drawn, take(key)) ? ChangeEffect::none : ChangeEffect::rebuild;
}

namespace {

const Material& material_of(const Scene& scene, const Body& body) {
    return *std::find_if(scene.materials.begin(), scene.materials.end(),
                         [&](const Material& m) { return m.name == body.material; });
}

bool both(bool a, bool b) { return a && b; }

/// Gives `to` the values of `from` by which a run of `to` can go on.
void take_in_flight(Scene& to, const Scene& from) {
    to.step = from.step;
    if (to.contacts.size() == from.contacts.size()) {
        // The scheme that friction takes is one and the same.
        // Springs that come in or stiffen between two steps bring energy, and nodes lose their mass at the
        // start.
        const auto by_impulse = [](const ContactSolver& solver) {
            return solver.scheme == ContactScheme::projection || solver.scheme == ContactScheme::joint;
        };
        const ContactSolver &before = to.contact_solver, &after = from.contact_solver;
        const bool same_springs = before.scheme == after.scheme && before.penalty == after.penalty &&
                                  before.step_of_elements == after.step_of_elements;
        if (both(by_impulse(before), by_impulse(after)) || same_springs) to.contact_solver = after;
        for (std::size_t p = 0; p < to.contacts.size(); ++p)
            if (both(to.contacts[p].friction > 0, from.contacts[p].friction > 0))
                to.contacts[p].friction = from.contacts[p].friction;
    }
    if (to.materials.size() == from.materials.size())
        for (std::size_t m = 0; m < to.materials.size(); ++m)
            if (both(to.materials[m].viscosity.has_value(), from.materials[m].viscosity.has_value()))
                to.materials[m].viscosity = from.materials[m].viscosity;
    if (to.bodies.size() != from.bodies.size()) return;
    const auto falls = [](const Scene& scene) {
        return std::any_of(scene.bodies.begin(), scene.bodies.end(), [](const Body& body) {
            return body.body_force[0] != 0 || body.body_force[1] != 0;
        });
    };
    const bool fall = both(falls(to), falls(from));
    for (std::size_t b = 0; b < to.bodies.size(); ++b) {
        Body& body = to.bodies[b];
        const Body& other = from.bodies[b];
        if (both(body.hourglass > 0, other.hourglass > 0)) body.hourglass = other.hourglass;
        if (fall) body.body_force = other.body_force;
        if (body.loads.size() == other.loads.size()) body.loads = other.loads;
    }
}

/// Gives `to` the values of `from` that no run reads.
void take_beside_the_run(Scene& to, const Scene& from) {
    to.title = from.title;
    to.description = from.description;
    to.parameters = from.parameters;  // what they stand for is compared where it stands
    to.record = from.record;
    to.view = from.view;
    to.analysis = from.analysis;
    to.exact = from.exact;
    to.expect = from.expect;
    to.lesson = from.lesson;
    to.study = from.study;
    to.accuracy = from.accuracy;
    to.file = from.file;
    to.text = from.text;
    to.overrides = from.overrides;
    to.warnings = from.warnings;
}

}  // namespace

InFlight in_flight(const Scene& scene) {
    InFlight values{scene.step, scene.contact_solver, {}, {}};
    for (const ContactPair& pair : scene.contacts) values.friction.push_back(pair.friction);
    for (const Body& body : scene.bodies)
        values.bodies.push_back(
            {material_of(scene, body).viscosity, body.hourglass, body.body_force, body.loads});
    return values;
}

ChangeEffect effect_of_change(const Scene& before, const Scene& after) {
    Scene same = before;
    take_beside_the_run(same, after);
    if (same == after) return ChangeEffect::none;
    take_in_flight(same, after);
    return same == after ? ChangeEffect::next_step : ChangeEffect::rebuild;
}

}  // namespace percuss
