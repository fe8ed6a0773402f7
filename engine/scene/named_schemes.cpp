#include "scene/named_schemes.hpp"

#include <algorithm>

#include "scene/parse.hpp"

namespace percuss {
namespace {

constexpr std::string_view each_pair = "contact.*.";

/// A scheme sets all that another one may have set, so that any can follow any.
NamedScheme projection(const char* name, const char* lagged, const char* sign, const char* explanation) {
    return {name,
            {"contact_solver.scheme=projection", std::string("contact.*.sign=") + sign,
             std::string("model.lagged=") + lagged},
            explanation};
}

NamedScheme joint(const char* name, const char* rows, const char* explanation) {
    return {name,
            {"contact_solver.scheme=joint", "contact.*.sign=restricted", "model.lagged=false",
             std::string("contact.*.scheme=") + rows},
            explanation};
}

}  // namespace

const std::vector<NamedScheme>& named_schemes() {
    static const std::vector<NamedScheme> table{
        projection("lagged", "true", "restricted",
                   "projection with stresses taken before the correction; it chatters: a teaching mode"),
        projection("unrestricted", "false", "unrestricted",
                   "projection by the paper's equations as they stand: contact may pull"),
        projection("projection", "false", "restricted",
                   "the paper's nodal projection, pair by pair; contact only pushes"),
        joint("joint", "node-to-side",
              "all pairs in one nonnegative problem: master nodes out of slave sides"),
        joint("symmetric", "symmetric", "the same with nodes of both out of sides of the other: no roles"),
        joint("segment-to-segment", "segment-to-segment",
              "the same with mean gaps of overlapping sides (mortar), and guards for nodes"),
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

std::vector<std::string> scheme_overrides(const NamedScheme& scheme, const Scene& scene) {
    std::vector<std::string> overrides;
    for (const std::string& setting : scheme.overrides) {
        if (!setting.starts_with(each_pair)) {
            overrides.push_back(setting);
            continue;
        }
        for (const ContactPair& pair : scene.contacts)
            overrides.push_back("contact." + pair.name + "." + setting.substr(each_pair.size()));
    }
    return overrides;
}

std::vector<SchemeChoice> scheme_choices(const Scene& scene) {
    std::vector<SchemeChoice> choices;
    for (const NamedScheme& scheme : named_schemes()) {
        SchemeChoice choice{scheme.name, "", false};
        std::vector<std::string> overrides = scene.overrides;
        for (std::string& setting : scheme_overrides(scheme, scene)) overrides.push_back(std::move(setting));
        try {
            const Scene with = parse_scene(scene.text, scene.file, overrides);
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
