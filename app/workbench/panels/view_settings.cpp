#include <algorithm>

#include <fmt/format.h>
#include <imgui.h>

#include "figures/ticks.hpp"
#include "workbench/glossary.hpp"
#include "workbench/panels/panel.hpp"
#include "workbench/viewport_actions.hpp"

namespace percuss::app {
namespace {

void choose_field(Workbench& w, const Scene& scene) {
    ViewportState& view = w.viewport;
    const std::vector<FieldInfo> fields = available_fields(scene);
    const auto present = std::find_if(fields.begin(), fields.end(), [&](const FieldInfo& field) {
        return field.name == view.options.field;
    });
    const std::string title = present != fields.end() ? present->title : "";
    if (!begin_choice(w, "field", title, "view.field", explain(title))) return;
    for (const FieldInfo& field : fields) {
        if (ImGui::Selectable(field.title.c_str(), field.name == view.options.field)) {
            view.options.field = field.name;
            view.fixed_range = false;  // the range belonged to the other field
            view.options.range.reset();
            view.dirty = true;
        }
        w.names.name("view.field." + field.name);
        explain_tooltip(field.title);
    }
    ImGui::EndCombo();
}

void choose_colours(Workbench& w) {
    ViewportState& view = w.viewport;
    if (!begin_choice(w, "colours", view.options.colour_map, "view.colours")) return;
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
    const auto radio_width = [](const char* label) {
        return ImGui::GetFrameHeight() + ImGui::GetStyle().ItemInnerSpacing.x + ImGui::CalcTextSize(label).x;
    };
    if (mode("now", "view.range.frame", !view.fixed_range && !all, "Colours span the values of this moment."))
        take(false, render::RangeMode::frame);
    same_line_for(radio_width("all time"));
    if (mode("all time", "view.range.all", !view.fixed_range && all,
             "Colours span all values shown since the field was chosen."))
        take(false, render::RangeMode::all_time);
    same_line_for(radio_width("fixed"));
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

void choose_reference_force(Workbench& w, const Scene& scene) {
    ViewportState& view = w.viewport;
    const double present = *view.options.force_reference;
    const DisplayUnit unit = scene.units.display(Quantity::force, present);
    double shown = unit.scale * present;
    const bool changed = ImGui::InputDouble(fmt::format("{}###reference-force", unit.label).c_str(), &shown,
                                            0, 0, "%.4g", ImGuiInputTextFlags_EnterReturnsTrue);
    w.names.name("view.arrows.reference");
    tooltip("Force of the reference arrow beneath the picture, which keeps its length.");
    if (!changed || !(shown > 0)) return;
    view.options.force_reference = shown / unit.scale;
    view.dirty = true;
}

void choose_cut_off(Workbench& w) {
    ViewportState& view = w.viewport;
    const bool logarithmic = view.options.force_scale == ForceScale::logarithmic;
    double percent = 100 * view.options.force_cut_off.value_or(logarithmic ? 0.001 : 0.01);
    const double low = 0.01, high = 50;
    const bool changed =
        ImGui::SliderScalar("cut-off", ImGuiDataType_Double, &percent, &low, &high, "%.3g %%",
                            ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_AlwaysClamp);
    w.names.name("view.arrows.cut-off");
    tooltip(
        "Forces below this part of the reference arrow's have no arrow; logarithmic arrows shrink to nothing "
        "there.");
    if (!changed) return;
    view.options.force_cut_off = percent / 100;
    view.dirty = true;
}

void choose_arrows(Workbench& w, const Scene& scene) {
    ViewportState& view = w.viewport;
    if (!view.options.forces || !view.view) return;
    struct Kind {
        ForceScale scale;
        const char *name, *help;
    };
    constexpr Kind kinds[] = {
        {ForceScale::automatic, "automatic", "The largest force of the run so far has the longest arrow."},
        {ForceScale::fixed, "fixed", "A length stands for the same force always: the one written below."},
        {ForceScale::logarithmic, "logarithmic",
         "Small forces beside large ones: each decade has the same length."}};
    const auto present = std::find_if(std::begin(kinds), std::end(kinds), [&](const Kind& kind) {
        return kind.scale == view.options.force_scale;
    });
    if (begin_choice(w, "arrows", present->name, "view.arrows", present->help)) {
        for (const Kind& kind : kinds) {
            if (ImGui::Selectable(kind.name, kind.scale == view.options.force_scale)) {
                // The fixed scale begins with the reference of the moment; the others find their own.
                const double reference = view.view->force_reference();
                view.options.force_reference.reset();
                if (kind.scale == ForceScale::fixed)
                    view.options.force_reference =
                        reference > 0 ? reference : scene.view.force_reference.value_or(1.0);
                view.options.force_scale = kind.scale;
                view.options.force_cut_off.reset();
                view.dirty = true;
            }
            w.names.name(fmt::format("view.arrows.{}", kind.name));
            tooltip(kind.help);
        }
        ImGui::EndCombo();
    }
    if (view.options.force_scale == ForceScale::fixed) choose_reference_force(w, scene);
    choose_cut_off(w);
}

/// All pairs, none, or one; the one that is pointed at is marked at once.
void choose_pairs(Workbench& w, const Scene& scene) {
    using Pairs = ViewportMarks::Pairs;
    ViewportMarks& m = w.marks;
    const std::string present = m.pairs == Pairs::none  ? "none"
                                : m.pairs == Pairs::all ? "all"
                                                        : scene.contacts[m.pair].name;
    const std::string help =
        "Contact pairs that are marked in the picture: master nodes as dots, slave sides as bold lines.\n" +
        explain("master slave");
    if (!begin_choice(w, "pairs", present, "view.pairs", help)) return;
    const auto entry = [&](const std::string& text, Pairs pairs, std::size_t pair) {
        if (ImGui::Selectable(text.c_str(), m.pairs == pairs && (pairs != Pairs::one || m.pair == pair)))
            m.pairs = pairs, m.pair = pair;
        w.names.name("view.pairs." + text);
    };
    entry("none", Pairs::none, 0);
    entry("all", Pairs::all, 0);
    for (std::size_t p = 0; p < scene.contacts.size(); ++p) {
        const ContactPair& pair = scene.contacts[p];
        entry(pair.name, Pairs::one, p);
        if (ImGui::IsItemHovered()) m.hovered_pair = p;
        tooltip(fmt::format("master {}.{}, slave {}.{}", pair.master.body, pair.master.edge, pair.slave.body,
                            pair.slave.edge));
    }
    ImGui::EndCombo();
}

void zoom_to_body(Workbench& w, const Snapshot& now) {
    if (!begin_choice(w, "zoom to", "body ...", "view.zoom-to")) return;
    const auto& bodies = now.setup->mesh.bodies;
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        if (ImGui::Selectable(bodies[b].name.c_str())) zoom_to(w, b);
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
    // In a narrow panel the choices need the room more than their names do.
    const float em = ImGui::GetFontSize();
    ImGui::PushItemWidth(ImGui::GetContentRegionAvail().x < 14 * em ? -4.2F * em : -5.5F * em);
    choose_field(w, scene);
    choose_range(w, scene);
    choose_colours(w);
    const float half = 0.54F * ImGui::GetContentRegionAvail().x + ImGui::GetCursorPosX();
    const bool beside = half > 10 * ImGui::GetFontSize();  // else there is room for one box a line
    command_box(w, "view.edges");
    if (beside) ImGui::SameLine(half);
    command_box(w, "view.velocities");
    if (scene.geometry == Geometry::axisymmetric) {
        command_box(w, "view.mirror");
        if (beside && !scene.contacts.empty()) ImGui::SameLine(half);
    }
    if (!scene.contacts.empty()) {
        command_box(w, "view.forces");
        choose_arrows(w, scene);
        choose_pairs(w, scene);
    }
    zoom_to_body(w, now);
    ImGui::PopItemWidth();
}

}  // namespace percuss::app
