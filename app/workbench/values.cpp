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
    {"width", [](const Workbench& w) -> Value { return static_cast<double>(w.screen.size()[0]); }},
    {"height", [](const Workbench& w) -> Value { return static_cast<double>(w.screen.size()[1]); }},
    {"fps", [](const Workbench& w) -> Value { return w.timing.frames_per_second(); }},
    {"frame.seconds", [](const Workbench& w) -> Value { return w.timing.frame_seconds(); }},
    {"engine.speed", [](const Workbench& w) -> Value { return w.timing.steps_per_second(); }},
    {"scheme",
     [](const Workbench& w) -> Value {
         for (const SchemeChoice& choice : w.run.schemes())
             if (choice.present) return choice.name;
         return std::string("another");
     }},
    {"lesson.answered", [](const Workbench& w) -> Value { return flag(w.lesson.answered); }},
    {"beside", [](const Workbench& w) -> Value { return static_cast<double>(w.beside.size()); }},
    {"beside.label",
     [](const Workbench& w) -> Value { return w.beside.empty() ? std::string() : w.beside[0].run->label(); }},
    {"beside.busy", [](const Workbench& w) -> Value { return flag(w.beside_busy()); }},
    {"beside.faults",
     [](const Workbench& w) -> Value {
         std::string text;
         for (const BesideView& each : w.beside) text += joined(each.run->run().messages());
         return text;
     }},
    {"reference", [](const Workbench& w) -> Value { return flag(w.reference.has_value()); }},
    {"recorded", [](const Workbench& w) -> Value { return flag(w.run.recorded()); }},
    {"live", [](const Workbench& w) -> Value { return flag(w.run.live()); }},
    {"playing", [](const Workbench& w) -> Value { return flag(w.run.playing()); }},
    {"reading", [](const Workbench& w) -> Value { return flag(w.run.reading()); }},
    {"ghost", [](const Workbench& w) -> Value { return flag(w.ghost.moment != nullptr); }},
    {"branch.asked", [](const Workbench& w) -> Value { return flag(w.run.branch_asked()); }},
    {"speed", [](const Workbench& w) -> Value { return w.run.speed(); }},
    {"speed.wanted", [](const Workbench& w) -> Value { return w.run.wanted_speed().value_or(0); }},
    {"exporting", [](const Workbench& w) -> Value { return flag(w.exports.busy()); }},
    {"export.progress", [](const Workbench& w) -> Value { return w.exports.progress(); }},
    {"export.written", [](const Workbench& w) -> Value { return joined(w.exports.written()); }},
    {"export.faults", [](const Workbench& w) -> Value { return joined(w.exports.faults()); }},
    {"recording", [](const Workbench& w) -> Value { return flag(w.exports.recording()); }},
    {"dark", [](const Workbench& w) -> Value { return flag(w.screen.dark()); }},
    {"recent",
     [](const Workbench& w) -> Value {
         return w.layout.recent.empty() ? std::string() : w.layout.recent.front().string();
     }},
    {"thumbnails.busy", [](const Workbench& w) -> Value { return flag(w.thumbnails.busy()); }},
    {"thumbnails.drawn",
     [](const Workbench& w) -> Value { return static_cast<double>(w.thumbnails.drawn()); }},
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
    {"newest", [](const Workbench& w) -> Value { return w.run.newest()->time; }},
    {"end", [](const Workbench& w) -> Value { return w.run.timeline().end; }},
    {"moments",
     [](const Workbench& w) -> Value { return static_cast<double>(w.run.timeline().frames.size()); }},
    {"failed-element",
     [](const Workbench& w) -> Value { return static_cast<double>(w.run.newest()->failed_cell); }},
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
    if (name == "ghost.time" && ghost.moment) return ghost.moment->time;
    if (name == "beside.time" && !beside.empty() && beside[0].run->moment())
        return beside[0].run->moment()->time;
    if (name == "beside.newest" && !beside.empty() && beside[0].run->run().newest())
        return beside[0].run->run().newest()->time;
    if (name == "beside.rows" && !beside.empty()) return static_cast<double>(beside[0].run->curves().rows());
    if (name == "reference.time" && reference && reference->moment) return reference->moment->time;
    const auto drops = run.branch_drops();
    if (name == "branch.from" && drops) return (*drops)[0];
    if (name == "branch.to" && drops) return (*drops)[1];
    if (name == "plots.from" && plots.time) return (*plots.time)[0];
    if (name == "plots.to" && plots.time) return (*plots.time)[1];
    if (name == "first.picture.seconds" && timing.first_picture()) return *timing.first_picture();
    if (name == "rebuild.seconds" && timing.rebuild_seconds()) return *timing.rebuild_seconds();
    const DesignValue* varied = run.design_value(name);
    if (varied == nullptr) return std::nullopt;
    return varied->choices.empty() ? Value(varied->number) : Value(varied->choice);
}

std::vector<std::string> Workbench::value_names() {
    std::vector<std::string> names;
    for (const NamedValue& value : always) names.emplace_back(value.name);
    for (const NamedValue& value : of_scene) names.emplace_back(value.name);
    for (const NamedValue& value : of_view) names.emplace_back(value.name);
    names.insert(names.end(), {"ghost.time", "beside.time", "beside.newest", "beside.rows", "reference.time",
                               "branch.from", "branch.to", "plots.from", "plots.to", "first.picture.seconds",
                               "rebuild.seconds", "parameters.NAME", "KEY of a value in the design panel"});
    return names;
}

}  // namespace percuss::app
