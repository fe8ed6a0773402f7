#include <algorithm>

#include "workbench/panels/panel.hpp"
#include "workbench/workbench.hpp"

namespace percuss::app {
namespace {

using Value = Workbench::Value;

struct NamedValue {
    const char* name;
    Value (*of)(const Workbench& workbench);
};

std::string joined(const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines) text += (text.empty() ? "" : "\n") + line;
    return text;
}

double flag(bool on) { return on ? 1 : 0; }

/// What needs no scene, then what needs one.
constexpr NamedValue always[] = {
    {"status", [](const Workbench& w) -> Value { return std::string(status_word(w.run.status())); }},
    {"building", [](const Workbench& w) -> Value { return flag(w.run.building()); }},
    {"builds", [](const Workbench& w) -> Value { return static_cast<double>(w.run.builds()); }},
    {"messages", [](const Workbench& w) -> Value { return joined(w.run.messages()); }},
    {"file", [](const Workbench& w) -> Value { return w.run.file().string(); }},
    {"panels", [](const Workbench& w) -> Value { return flag(w.panels); }},
    {"help", [](const Workbench& w) -> Value { return flag(w.help); }},
    {"frames", [](const Workbench& w) -> Value { return static_cast<double>(w.frames); }},
    {"reference", [](const Workbench& w) -> Value { return flag(w.reference.has_value()); }},
    {"scale", [](const Workbench& w) -> Value { return w.screen.scale(); }},
    {"field", [](const Workbench& w) -> Value { return w.viewport.options.field; }},
    {"edges", [](const Workbench& w) -> Value { return flag(w.viewport.options.edges); }},
    {"forces", [](const Workbench& w) -> Value { return flag(w.viewport.options.forces); }},
    {"velocities", [](const Workbench& w) -> Value { return flag(w.viewport.options.velocities); }},
    {"probes", [](const Workbench& w) -> Value { return static_cast<double>(w.run.probes().size()); }},
    {"probe.rows",
     [](const Workbench& w) -> Value {
         const auto& probes = w.marks.probes.all();
         return probes.empty() ? 0.0 : static_cast<double>(probes.back().curves->rows());
     }},
    {"following", [](const Workbench& w) -> Value { return flag(w.marks.followed.has_value()); }},
    {"pairs.marked",
     [](const Workbench& w) -> Value {
         const ViewportMarks& m = w.marks;
         if (m.hovered_pair || m.pairs == ViewportMarks::Pairs::one)
             return w.run.snapshot()->setup->scene.contacts[m.hovered_pair.value_or(m.pair)].name;
         return std::string(m.pairs == ViewportMarks::Pairs::all ? "all" : "none");
     }},
    {"arrows",
     [](const Workbench& w) -> Value {
         const ForceScale scale = w.viewport.options.force_scale;
         return std::string(scale == ForceScale::automatic ? "automatic"
                            : scale == ForceScale::fixed   ? "fixed"
                                                           : "logarithmic");
     }},
    {"mirror", [](const Workbench& w) -> Value { return flag(w.viewport.options.mirror); }},
    {"colours", [](const Workbench& w) -> Value { return w.viewport.options.colour_map; }},
};

constexpr NamedValue of_scene[] = {
    {"time", [](const Workbench& w) -> Value { return w.run.snapshot()->time; }},
    {"steps", [](const Workbench& w) -> Value { return static_cast<double>(w.run.snapshot()->step); }},
    {"dt", [](const Workbench& w) -> Value { return w.run.snapshot()->dt; }},
    {"step.fraction",
     [](const Workbench& w) -> Value { return w.run.snapshot()->dt / w.run.snapshot()->critical_step; }},
    {"title", [](const Workbench& w) -> Value { return w.run.snapshot()->setup->scene.title; }},
    {"rows", [](const Workbench& w) -> Value { return static_cast<double>(w.run.history()->rows()); }},
    {"contacts",
     [](const Workbench& w) -> Value {
         return static_cast<double>(w.run.snapshot()->contact_forces.size());
     }},
};

constexpr NamedValue of_view[] = {
    {"zoom", [](const Workbench& w) -> Value { return w.viewport.view->fit().pixels_per_unit; }},
    {"range.low", [](const Workbench& w) -> Value { return w.viewport.view->range()[0]; }},
    {"range.high", [](const Workbench& w) -> Value { return w.viewport.view->range()[1]; }},
    {"arrows.reference", [](const Workbench& w) -> Value { return w.viewport.view->force_reference(); }},
    {"centre.x", [](const Workbench& w) -> Value { return w.viewport.view->camera().centre[0]; }},
    {"centre.y", [](const Workbench& w) -> Value { return w.viewport.view->camera().centre[1]; }},
    {"hovered",
     [](const Workbench& w) -> Value {
         const auto body = w.viewport.hovered.body;
         return body < 0 ? std::string("nothing")
                         : w.viewport.setup->mesh.bodies[static_cast<std::size_t>(body)].name;
     }},
};

template <std::size_t n>
std::optional<Value> find(const NamedValue (&table)[n], const std::string& name, const Workbench& w) {
    const auto* found =
        std::find_if(std::begin(table), std::end(table), [&](const NamedValue& v) { return name == v.name; });
    if (found == std::end(table)) return std::nullopt;
    return found->of(w);
}

}  // namespace

std::optional<Value> Workbench::value(const std::string& name) const {
    if (const auto value = find(always, name, *this)) return value;
    if (!run.snapshot()) return std::nullopt;
    if (const auto value = find(of_scene, name, *this)) return value;
    if (viewport.view && viewport.drawn)
        if (const auto value = find(of_view, name, *this)) return value;
    if (name == "plots.from" && plots.time) return (*plots.time)[0];
    if (name == "plots.to" && plots.time) return (*plots.time)[1];
    constexpr std::string_view parameters = "parameters.";
    if (!name.starts_with(parameters)) return std::nullopt;
    for (const Parameter& parameter : run.snapshot()->setup->scene.parameters)
        if (parameter.name == name.substr(parameters.size())) return parameter.value;
    return std::nullopt;
}

std::vector<std::string> Workbench::value_names() {
    std::vector<std::string> names;
    for (const NamedValue& value : always) names.emplace_back(value.name);
    for (const NamedValue& value : of_scene) names.emplace_back(value.name);
    for (const NamedValue& value : of_view) names.emplace_back(value.name);
    names.insert(names.end(), {"plots.from", "plots.to", "parameters.NAME"});
    return names;
}

}  // namespace percuss::app
