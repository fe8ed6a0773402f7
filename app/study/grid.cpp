#include "study/grid.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "exit_status.hpp"
#include "nearest_name.hpp"
#include "run/in_flight.hpp"
#include "scene/parse.hpp"

namespace percuss::app {
namespace {

/// Parts between commas that stand in no brackets and no quotes.
std::vector<std::string> split(const std::string& text) {
    std::vector<std::string> parts(1);
    int depth = 0;
    char quote = 0;
    for (const char c : text) {
        if (quote != 0)
            quote = c == quote ? '\0' : quote;
        else if (c == '"' || c == '\'')
            quote = c;
        depth += quote == 0 ? (c == '[' || c == '{') - (c == ']' || c == '}') : 0;
        if (c == ',' && depth == 0 && quote == 0)
            parts.emplace_back();
        else
            parts.back() += c;
    }
    return parts;
}

bool changes_nothing(const Scene& scene, const std::vector<std::string>& settings) {
    std::vector<std::string> overrides = scene.overrides;
    overrides.insert(overrides.end(), settings.begin(), settings.end());
    try {
        const Scene with = parse_scene(scene.text, scene.file, overrides);
        return effect_of_change(scene, with) == ChangeEffect::none;
    } catch (const SceneError&) {
        return false;  // told when the case is read
    }
}

}  // namespace

std::size_t Variation::home() const {
    const auto own = std::find_if(values.begin(), values.end(), [](const Value& v) { return v.own; });
    return own == values.end() ? values.size() - 1 : static_cast<std::size_t>(own - values.begin());
}

std::string Variation::describe(std::size_t value) const {
    const std::string& text = values[value].label;
    if (axis.kind == AxisKind::method) return text;
    return axis.name + " " + text + (unit.empty() ? "" : " " + unit);
}

const SchemeChoice& choose_scheme(const std::vector<SchemeChoice>& choices, const std::string& name,
                                  const std::string& option) {
    const auto found =
        std::find_if(choices.begin(), choices.end(), [&](const auto& c) { return c.name == name; });
    if (found == choices.end())
        throw UsageError(
            fmt::format("{}: unknown scheme '{}'{}", option, name, suggest_name(name, scheme_names())));
    if (!found->fault.empty())
        throw UsageError(
            fmt::format("{}: the scene cannot take the scheme '{}': {}", option, name, found->fault));
    return *found;
}

Variation make_variation(const StudyAxis& axis, const Scene& scene) {
    Variation variation{axis, {}, ""};
    for (const Parameter& parameter : scene.parameters)
        if (axis.key == "parameters." + parameter.name) variation.unit = parameter.unit;
    const bool schemes = axis.key == "scheme";
    const auto choices = schemes ? scheme_choices(scene) : std::vector<SchemeChoice>{};
    for (const std::string& text : axis.values) {
        Variation::Value value{text, {}, false};
        if (schemes) {
            value.own = choose_scheme(choices, text, "scheme").present;
            value.overrides = scheme_overrides(*find_scheme(text), scene);
        } else {
            value.overrides = spell_out(axis.key + "=" + text, scene);
            if (value.overrides.empty())
                throw UsageError(
                    fmt::format("{}: the scene has nothing that the star stands for; write "
                                "body.*.KEY, material.*.KEY or contact.*.KEY",
                                axis.key));
            value.own = changes_nothing(scene, value.overrides);
        }
        variation.values.push_back(std::move(value));
    }
    return variation;
}

std::vector<Combination> combine(const std::vector<Variation>& axes) {
    std::vector<Combination> all{{}};
    for (const Variation& axis : axes) {
        std::vector<Combination> longer;
        for (const Combination& one : all)
            for (std::size_t i = 0; i < axis.values.size(); ++i) {
                longer.push_back(one);
                longer.back().at.push_back(i);
            }
        all = std::move(longer);
    }
    const auto takes_away = [](const std::string& key) {
        return key == "scheme" || key == "contact_solver.scheme" || key.ends_with(".element");
    };
    for (Combination& one : all)
        for (const bool takers : {true, false})
            for (std::size_t a = 0; a < axes.size(); ++a) {
                if (takes_away(axes[a].axis.key) != takers) continue;
                const auto& settings = axes[a].values[one.at[a]].overrides;
                one.overrides.insert(one.overrides.end(), settings.begin(), settings.end());
            }
    return all;
}

bool is_set(const StudyAxis& axis, const std::vector<std::string>& overrides) {
    return std::any_of(overrides.begin(), overrides.end(), [&](const std::string& text) {
        return text.starts_with(axis.key + "=") ||
               (axis.key.starts_with("model.step.") && text.starts_with("model.step."));
    });
}

StudyAxis parse_axis(const std::string& text, const std::string& option) {
    const auto equals = text.find('=');
    StudyAxis axis;
    if (equals != std::string::npos && equals > 0) {
        axis.key = text.substr(0, equals);
        axis.values = split(text.substr(equals + 1));
    }
    if (axis.values.empty() || std::find(axis.values.begin(), axis.values.end(), "") != axis.values.end())
        throw UsageError(
            fmt::format("{} {}: write KEY=VALUE,VALUE, e.g. parameters.friction=0.1,0.3", option, text));
    for (std::size_t i = 1; i < axis.values.size(); ++i)
        if (std::find(axis.values.begin(), axis.values.begin() + static_cast<std::ptrdiff_t>(i),
                      axis.values[i]) != axis.values.begin() + static_cast<std::ptrdiff_t>(i))
            throw UsageError(
                fmt::format("{} {}: the value {} stands there twice", option, text, axis.values[i]));
    axis.name = usual_name(axis.key);
    axis.kind = usual_kind(axis.key);
    return axis;
}

}  // namespace percuss::app
