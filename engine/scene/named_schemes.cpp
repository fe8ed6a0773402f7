#include "scene/named_schemes.hpp"

#include <algorithm>

#include "run/in_flight.hpp"
#include "scene/parse.hpp"
#include "scene/readers.hpp"
#include "scene/scheme_names.hpp"

namespace percuss {
namespace {

/// A scheme sets all that another one may have set, so that any can follow any.
NamedScheme scheme(const char* name, ContactScheme solver, RowScheme rows, const char* level,
                   const char* explanation, const char* sign = "restricted", const char* lagged = "false") {
    return {name,
            {"contact_solver.scheme=" + name_of(solver), "contact.*.scheme=" + name_of(rows),
             std::string("contact.*.level=") + level, std::string("contact.*.sign=") + sign,
             std::string("model.lagged=") + lagged},
            explanation};
}

}  // namespace

const std::vector<NamedScheme>& named_schemes() {
    using Solver = ContactScheme;
    using Rows = RowScheme;
    static const std::vector<NamedScheme> table{
        scheme("lagged", Solver::projection, Rows::node_to_side, "position",
               "projection with stresses taken before the correction; it chatters: a teaching mode",
               "restricted", "true"),
        scheme("unrestricted", Solver::projection, Rows::node_to_side, "position",
               "projection by the paper's equations as they stand: contact may pull", "unrestricted"),
        scheme("projection", Solver::projection, Rows::node_to_side, "position",
               "the paper's nodal projection, pair by pair; contact only pushes"),
        scheme("joint", Solver::joint, Rows::node_to_side, "position",
               "all pairs in one nonnegative problem: master nodes out of slave sides"),
        scheme("symmetric", Solver::joint, Rows::symmetric, "position",
               "the same with nodes of both out of sides of the other: no roles"),
        scheme("segment-to-segment", Solver::joint, Rows::segment_to_segment, "position",
               "the same with mean gaps of overlapping sides (mortar), and guards for nodes"),
        scheme("velocity", Solver::joint, Rows::symmetric, "velocity",
               "symmetric at the level of velocities: what would close in the step stops where it is"),
        scheme("penalty", Solver::penalty, Rows::symmetric, "position",
               "springs against penetration on symmetric rows"),
        scheme("bipenalty", Solver::bipenalty, Rows::symmetric, "position",
               "the same springs with inertia, which spare the critical step"),
        scheme("massless", Solver::massless, Rows::symmetric, "position",
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
