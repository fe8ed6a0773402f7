#include <algorithm>

#include <fmt/format.h>
#include <imgui.h>

#include "figures/ticks.hpp"
#include "view/bodies.hpp"
#include "workbench/panels/panel.hpp"

namespace percuss::app {
namespace {

void choose_field(Workbench& w, const Scene& scene) {
    ViewportState& view = w.viewport;
    const std::vector<FieldInfo> fields = available_fields(scene);
    const auto present = std::find_if(fields.begin(), fields.end(), [&](const FieldInfo& field) {
        return field.name == view.options.field;
    });
    const bool open = ImGui::BeginCombo("field", present != fields.end() ? present->title.c_str() : "");
    w.names.name("view.field");
    if (!open) return;
    for (const FieldInfo& field : fields) {
        if (ImGui::Selectable(field.title.c_str(), field.name == view.options.field)) {
            view.options.field = field.name;
            view.fixed_range = false;  // the range belonged to the other field
            view.options.range.reset();
            view.dirty = true;
        }
        w.names.name("view.field." + field.name);
    }
    ImGui::EndCombo();
}

void choose_colours(Workbench& w) {
    ViewportState& view = w.viewport;
    const bool open = ImGui::BeginCombo("colours", view.options.colour_map.c_str());
    w.names.name("view.colours");
    if (!open) return;
    for (const std::string& name : colour_map_names()) {
        if (ImGui::Selectable(name.c_str(), name == view.options.colour_map)) {
            view.options.colour_map = name;
            view.dirty = true;
        }
        w.names.name("view.colours." + name);
    }
    ImGui::EndCombo();
}

void choose_range(Workbench& w, const Scene& scene) {
    ViewportState& view = w.viewport;
    const auto mode = [&](const char* label, const char* name, bool on, const char* help) {
        const bool chosen = ImGui::RadioButton(label, on);
        w.names.name(name);
        tooltip(help);
        return chosen;
    };
    const bool all = view.range_mode == render::RangeMode::all_time;
    const auto take = [&](bool fixed, render::RangeMode range_mode) {
        if (fixed && !view.fixed_range && view.view) view.fixed = view.view->range();
        view.fixed_range = fixed;
        view.range_mode = range_mode;
        view.options.range.reset();
        if (fixed) view.options.range = view.fixed;
        view.dirty = true;
    };
    if (mode("now", "view.range.frame", !view.fixed_range && !all, "Colours span the values of this moment."))
        take(false, render::RangeMode::frame);
    ImGui::SameLine();
    if (mode("all time", "view.range.all", !view.fixed_range && all,
             "Colours span all values shown since the field was chosen."))
        take(false, render::RangeMode::all_time);
    ImGui::SameLine();
    if (mode("fixed", "view.range.fixed", view.fixed_range, "Colours span what is written below."))
        take(true, render::RangeMode::frame);
    if (!view.fixed_range || !view.view) return;
    const FieldInfo& field = view.view->field();
    const DisplayUnit unit =
        scene.units.display(field.quantity, std::max(std::abs(view.fixed[0]), std::abs(view.fixed[1])));
    double shown[2] = {unit.scale * view.fixed[0], unit.scale * view.fixed[1]};
    const std::string label = unit.label.empty() ? "range" : fmt::format("{}###range", unit.label);
    const bool changed = ImGui::InputScalarN(label.c_str(), ImGuiDataType_Double, shown, 2, nullptr, nullptr,
                                             "%.4g", ImGuiInputTextFlags_EnterReturnsTrue);
    w.names.name("view.range.values");
    if (changed && shown[0] < shown[1]) {
        view.fixed = {shown[0] / unit.scale, shown[1] / unit.scale};
        view.options.range = view.fixed;
        view.dirty = true;
    }
}

void choose_arrows(Workbench& w) {
    ViewportState& view = w.viewport;
    if (!view.options.forces) return;
    const bool logarithmic = view.options.force_scale == ForceScale::logarithmic;
    const bool open = ImGui::BeginCombo("arrows", logarithmic ? "logarithmic" : "linear");
    w.names.name("view.arrows");
    if (!open) return;
    for (const bool log : {false, true}) {
        if (ImGui::Selectable(log ? "logarithmic" : "linear", log == logarithmic)) {
            view.options.force_scale = log ? ForceScale::logarithmic : ForceScale::automatic;
            view.dirty = true;
        }
        w.names.name(log ? "view.arrows.logarithmic" : "view.arrows.linear");
    }
    ImGui::EndCombo();
}

void zoom_to_body(Workbench& w, const Snapshot& now) {
    ViewportState& view = w.viewport;
    const bool open = ImGui::BeginCombo("zoom to", "body ...");
    w.names.name("view.zoom-to");
    if (!open) return;
    const auto& bodies = now.setup->mesh.bodies;
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        if (ImGui::Selectable(bodies[b].name.c_str()) && view.view) {
            view.camera = view.view->around(render::body_boxes(now, view.view->plane())[b]);
            view.framing = Framing::chosen;
            view.dirty = true;
        }
        w.names.name("view.zoom-to." + bodies[b].name);
    }
    ImGui::EndCombo();
}

}  // namespace

void show_view_settings(Workbench& w) {
    const bool open = ImGui::CollapsingHeader("Picture", ImGuiTreeNodeFlags_DefaultOpen);
    w.names.name("header.picture");
    if (!open || !w.run.snapshot()) return;
    const Snapshot& now = *w.run.snapshot();
    const Scene& scene = now.setup->scene;
    ImGui::PushItemWidth(-5.5F * ImGui::GetFontSize());
    choose_field(w, scene);
    choose_range(w, scene);
    choose_colours(w);
    const float half = 0.54F * ImGui::GetContentRegionAvail().x + ImGui::GetCursorPosX();
    command_box(w, "view.edges");
    ImGui::SameLine(half);
    command_box(w, "view.velocities");
    if (scene.geometry == Geometry::axisymmetric) {
        command_box(w, "view.mirror");
        if (!scene.contacts.empty()) ImGui::SameLine(half);
    }
    if (!scene.contacts.empty()) {
        command_box(w, "view.forces");
        choose_arrows(w);
    }
    zoom_to_body(w, now);
    ImGui::PopItemWidth();
}

}  // namespace percuss::app
