#include "scene/named_schemes.hpp"

#include <algorithm>

#include "run/in_flight.hpp"
#include "scene/parse.hpp"
#include "scene/readers.hpp"

namespace percuss {
namespace {

/// A scheme sets all that another one may have set, so that any can follow any.
NamedScheme scheme(const char* name, const char* solver, const char* rows, const char* level,
                   const char* explanation, const char* sign = "restricted", const char* lagged = "false") {
    return {name,
            {std::string("contact_solver.scheme=") + solver, std::string("contact.*.scheme=") + rows,
             std::string("contact.*.level=") + level, std::string("contact.*.sign=") + sign,
             std::string("model.lagged=") + lagged},
            explanation};
}

}  // namespace

const std::vector<NamedScheme>& named_schemes() {
    static const std::vector<NamedScheme> table{
        scheme("lagged", "projection", "node-to-side", "position",
               "projection with stresses taken before the correction; it chatters: a teaching mode",
               "restricted", "true"),
        scheme("unrestricted", "projection", "node-to-side", "position",
               "projection by the paper's equations as they stand: contact may pull", "unrestricted"),
        scheme("projection", "projection", "node-to-side", "position",
               "the paper's nodal projection, pair by pair; contact only pushes"),
        scheme("joint", "joint", "node-to-side", "position",
               "all pairs in one nonnegative problem: master nodes out of slave sides"),
        scheme("symmetric", "joint", "symmetric", "position",
               "the same with nodes of both out of sides of the other: no roles"),
        scheme("segment-to-segment", "joint", "segment-to-segment", "position",
               "the same with mean gaps of overlapping sides (mortar), and guards for nodes"),
        scheme("velocity", "joint", "symmetric", "velocity",
               "symmetric at the level of velocities: what would close in the step stops where it is"),
        scheme("penalty", "penalty", "symmetric", "position",
               "springs against penetration on symmetric rows"),
        scheme("bipenalty", "bipenalty", "symmetric", "position",
               "the same springs with inertia, which spare the critical step"),
        scheme("massless", "massless", "symmetric", "position",
               "symmetric with contact nodes that have no mass: nothing is lost at an impact"),
    };
    return table;
}

std::vector<std::string> scheme_names() {
    std::vector<std::string> names;
    for (const NamedScheme& scheme : named_schemes()) names.push_back(scheme.name);
    return names;
}

const NamedScheme* find_scheme(std::string_view name) {
    const auto& table = named_schemes();
    const auto found =
        std::find_if(table.begin(), table.end(), [&](const NamedScheme& s) { return s.name == name; });
    return found == table.end() ? nullptr : &*found;
}

std::vector<std::string> spell_out(const std::string& setting, const Scene& scene) {
    const auto star = setting.find(".*.");
    if (star == std::string::npos || star > setting.find('=')) return {setting};
    const std::string table = setting.substr(0, star);
    std::vector<std::string> names;
    if (table == "body") names = names_of(scene.bodies);
    if (table == "material") names = names_of(scene.materials);
    if (table == "contact")
        for (const ContactPair& pair : scene.contacts)
            if (std::find(names.begin(), names.end(), pair.table) == names.end()) names.push_back(pair.table);
    std::vector<std::string> settings;
    for (const std::string& name : names) settings.push_back(table + "." + name + setting.substr(star + 2));
    return settings;
}

std::vector<std::string> scheme_overrides(const NamedScheme& scheme, const Scene& scene) {
    std::vector<std::string> overrides;
    for (const std::string& setting : scheme.overrides)
        for (std::string& each : spell_out(setting, scene)) overrides.push_back(std::move(each));
    return overrides;
}

std::vector<SchemeChoice> scheme_choices(const Scene& scene) {
    std::vector<SchemeChoice> choices;
    for (const NamedScheme& scheme : named_schemes()) {
        SchemeChoice choice{scheme.name, "", false, false};
        std::vector<std::string> overrides = scene.overrides;
        for (std::string& setting : scheme_overrides(scheme, scene)) overrides.push_back(std::move(setting));
        try {
            const Scene with = parse_scene(scene.text, scene.file, overrides);
            choice.goes_on = effect_of_change(scene, with) != ChangeEffect::rebuild;
            choice.present = with.lagged == scene.lagged && with.contacts == scene.contacts &&
                             with.contact_solver == scene.contact_solver;
        } catch (const SceneError& error) {
            choice.fault = error.messages().front();
        }
        choices.push_back(std::move(choice));
    }
    return choices;
}

}  // namespace percuss
