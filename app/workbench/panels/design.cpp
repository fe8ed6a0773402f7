#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <imgui.h>

#include "effects.hpp"
#include "workbench/glossary.hpp"
#include "workbench/panels/panel.hpp"

namespace percuss::app {
namespace {

const ImVec4 changed_colour{0.80F, 0.33F, 0.0F, 1};

/// Decimals with which a slider of this range moves in some hundreds of steps.
int decimals_for(double span) {
    return span > 0 ? std::clamp(3 - static_cast<int>(std::ceil(std::log10(span))), 0, 8) : 3;
}

std::optional<double> number(const std::string& text) {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
    return value;
}

/// A short unit stands with the number, where a long name still has room.
bool unit_with_number(const DesignValue& value) { return value.unit.size() <= 5; }

/// @param number how to print it
std::string format_of(const DesignValue& value, std::string number) {
    if (value.unit.empty() || !unit_with_number(value)) return number;
    number += " ";
    for (const char c : value.unit) number += c == '%' ? std::string("%%") : std::string(1, c);
    return number;
}

std::string title_of(const DesignValue& value) {
    return value.unit.empty() || unit_with_number(value) ? value.title
                                                         : fmt::format("{} [{}]", value.title, value.unit);
}

std::string help_of(const DesignValue& value) {
    std::string help = value.help.empty() ? title_of(value) : value.help;
    std::string words = value.title;
    for (const std::string& choice : value.choices) words += ", " + choice;
    if (const std::string terms = explain(words); !terms.empty()) help += "\n" + terms;
    if (value.range && value.group == "parameters")
        help += fmt::format("\n{:g} to {:g} {}", (*value.range)[0], (*value.range)[1], value.unit);
    if (!value.expression.empty()) return help + "\nFollows from parameters: " + value.expression;
    if (value.choices.empty())
        help += value.range ? "\nA double click, or Ctrl and a click: type the value."
                            : "\nDrag it sideways; a double click, or Ctrl and a click: type the value.";
    help += value.effect == ChangeEffect::rebuild     ? "\nA change builds the run anew."
            : value.effect == ChangeEffect::next_step ? "\nA change acts at once, from the next step on."
                                                      : "\nThe run does not read it.";
    return help;
}

/// A dot for what acts at once, a ring for what builds anew.
void show_mark(ChangeEffect effect) {
    const float size = ImGui::GetFontSize(), height = ImGui::GetFrameHeight();
    const ImVec2 at = ImGui::GetCursorScreenPos(), centre{at.x + 0.3F * size, at.y + 0.5F * height};
    ImDrawList& ink = *ImGui::GetWindowDrawList();
    if (effect == ChangeEffect::rebuild)
        ink.AddCircle(centre, 0.2F * size, ImGui::GetColorU32(ImGuiCol_TextDisabled), 0, 0.1F * size);
    else
        ink.AddCircleFilled(centre, 0.24F * size, IM_COL32(0, 158, 115, 255));
    ImGui::Dummy({0.6F * size, height});
}

/// The value's name; one that differs from the file has a button that takes it back.
void show_label(Workbench& w, const DesignValue& value) {
    ImGui::SameLine(0, 0.3F * ImGui::GetFontSize());
    show_mark(value.effect);
    ImGui::SameLine(0, 0.3F * ImGui::GetFontSize());
    const bool changed = w.run.setting(value.key).has_value();
    bool back = false;
    if (changed) {
        back = ImGui::SmallButton(fmt::format("\u2190##{}", value.key).c_str());
        w.names.name("back." + value.key);
        tooltip("Back to the value of the file.");
        ImGui::SameLine(0, 0.4F * ImGui::GetFontSize());
    }
    if (changed) ImGui::PushStyleColor(ImGuiCol_Text, changed_colour);
    const std::string title = title_of(value), fitting = shortened(title, ImGui::GetContentRegionAvail().x);
    ImGui::TextUnformatted(fitting.c_str());
    if (changed) ImGui::PopStyleColor();
    w.names.name("label." + value.key);
    back = back || (changed && ImGui::IsItemClicked(ImGuiMouseButton_Right));
    tooltip(fitting == title ? help_of(value) : title + "\n" + help_of(value));
    if (back) w.run.forget(value.key);
}

/// @returns whether it was changed
bool show_slider(Workbench& w, const DesignValue& value, const std::string& id, double& number) {
    if (w.design.typing == value.key) {
        if (std::exchange(w.design.just_begun, false)) ImGui::SetKeyboardFocusHere();
        const bool typed = ImGui::InputScalar(
            (id + ".typed").c_str(), ImGuiDataType_Double, &number, nullptr, nullptr, "%.6g",
            ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
        if (typed || ImGui::IsItemDeactivated()) w.design.typing.clear();
        return typed;
    }
    const auto [low, high] = *value.range;
    // A parameter has a range, another value may be typed beyond the ends of its slider.
    const ImGuiSliderFlags flags = value.group == "parameters" ? ImGuiSliderFlags_AlwaysClamp : 0;
    const bool moved =
        ImGui::SliderScalar(id.c_str(), ImGuiDataType_Double, &number, &low, &high,
                            format_of(value, fmt::format("%.{}f", decimals_for(high - low))).c_str(), flags);
    if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
        w.design.typing = value.key;
        w.design.just_begun = true;
        return false;
    }
    return moved;
}

bool show_field(const DesignValue& value, const std::string& id, double& number) {
    const double size = std::abs(number);
    const auto speed = static_cast<float>(size > 0 ? 0.005 * size : 0.001);
    const double high = std::numeric_limits<double>::max() / 4, low = std::max(value.least, -high);
    return ImGui::DragScalar(id.c_str(), ImGuiDataType_Double, &number, speed, &low, &high,
                             format_of(value, "%.5g").c_str(),
                             value.least > -high ? ImGuiSliderFlags_AlwaysClamp : 0);
}

void show_number(Workbench& w, const DesignValue& value) {
    double shown = value.number;
    if (const auto set = w.run.setting(value.key)) shown = number(*set).value_or(shown);
    ImGui::SetNextItemWidth(0.36F * ImGui::GetWindowWidth());
    const std::string id = "##" + value.key;
    const bool changed = value.range ? show_slider(w, value, id, shown) : show_field(value, id, shown);
    w.names.name(value.key);
    tooltip(help_of(value));
    if (changed) w.run.set(value.key, fmt::format("{:.9g}", shown));
}

void show_choice(Workbench& w, const DesignValue& value) {
    std::string chosen = value.choice;
    if (const auto set = w.run.setting(value.key)) {
        chosen = *set;
        std::erase(chosen, '"');
    }
    ImGui::SetNextItemWidth(0.36F * ImGui::GetWindowWidth());
    if (!begin_choice(w, ("##" + value.key).c_str(), chosen, value.key, help_of(value))) return;
    for (const std::string& choice : value.choices) {
        if (ImGui::Selectable(choice.c_str(), choice == chosen))
            w.run.set(value.key, fmt::format("\"{}\"", choice));
        w.names.name(value.key + "." + choice);
    }
    ImGui::EndCombo();
}

/// What follows from others cannot be moved by itself, but is worth seeing.
void show_derived(Workbench& w, const DesignValue& value) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextDisabled(format_of(value, "%.5g").c_str(), value.number);
    // Under the names of the others.
    ImGui::SameLine(0.36F * ImGui::GetWindowWidth() + ImGui::GetStyle().WindowPadding.x +
                    1.2F * ImGui::GetFontSize());
    line_of_text(title_of(value), true, help_of(value));
    w.names.name("label." + value.key);
}

}  // namespace

void show_design_value(Workbench& w, const DesignValue& value) {
    if (value.key == "contact_solver.scheme" && value.expression.empty()) {
        show_scheme_choice(w);  // the same by names that say more
        return;
    }
    if (!value.expression.empty()) {
        show_derived(w, value);
        return;
    }
    if (value.choices.empty())
        show_number(w, value);
    else
        show_choice(w, value);
    show_label(w, value);
}

namespace {

void show_group(Workbench& w, const std::string& group, bool derived) {
    for (const DesignValue& value : w.run.design())
        if (value.group == group && (derived || value.expression.empty())) show_design_value(w, value);
}

void show_legend() {
    show_mark(ChangeEffect::next_step);
    ImGui::SameLine(0, 0.3F * ImGui::GetFontSize());
    ImGui::AlignTextToFramePadding();
    ImGui::TextDisabled("acts at once");
    same_line_for(ImGui::CalcTextSize("builds the run anew").x + 1.5F * ImGui::GetFontSize(),
                  1.2F * ImGui::GetFontSize());
    show_mark(ChangeEffect::rebuild);
    ImGui::SameLine(0, 0.3F * ImGui::GetFontSize());
    ImGui::AlignTextToFramePadding();
    ImGui::TextDisabled("builds the run anew");
}

void show_groups(Workbench& w) {
    std::string last = "parameters";
    for (const DesignValue& value : w.run.design()) {
        if (value.group == last || value.group == "run") continue;
        last = value.group;
        const bool open = ImGui::TreeNodeEx(last.c_str(), ImGuiTreeNodeFlags_NoTreePushOnOpen);
        w.names.name("design." + last);
        if (open) show_group(w, last, true);
    }
}

void show_effects(const Scene& scene) {
    for (const EffectInfo& effect : effects_of(scene)) {
        if (!effect.on) continue;
        ImGui::BulletText("%s", effect.name.c_str());
        explain_tooltip(effect.name, "Costs " + effect.cost + ".");
    }
}

/// A recorded run is what it is.
void show_recorded_design(const Scene& scene) {
    ImGui::PushTextWrapPos(0);
    ImGui::TextDisabled("a recorded run; it was made with");
    ImGui::PopTextWrapPos();
    for (const Parameter& parameter : scene.parameters) {
        ImGui::TextUnformatted(
            fmt::format("{} = {:.6g} {}", parameter.name, parameter.value, parameter.unit).c_str());
        tooltip(parameter.description);
    }
    if (scene.parameters.empty()) ImGui::TextDisabled("no [parameters]");
    ImGui::PushTextWrapPos(0);
    for (const std::string& changed : scene.overrides) ImGui::TextDisabled("--set %s", changed.c_str());
    ImGui::PopTextWrapPos();
}

}  // namespace

void show_design(Workbench& w) {
    const bool open = ImGui::CollapsingHeader("Design", ImGuiTreeNodeFlags_DefaultOpen);
    w.names.name("header.design");
    if (!open || !w.run.snapshot()) return;
    if (w.run.recorded()) {
        show_recorded_design(w.run.snapshot()->setup->scene);
        return;
    }
    const std::vector<DesignValue>& values = w.run.design();
    if (!values.empty()) show_legend();
    const bool any = std::any_of(values.begin(), values.end(), [](const DesignValue& value) {
        return value.group == "parameters" && value.expression.empty();
    });
    if (any)
        show_group(w, "parameters", false);
    else
        ImGui::TextDisabled("the scene has no [parameters]");
    show_group(w, "run", true);
    show_groups(w);
    command_button(w, "scene.file-values");
    const bool effects = ImGui::CollapsingHeader("Effects that are on");
    w.names.name("header.effects");
    if (effects) show_effects(w.run.snapshot()->setup->scene);
}

}  // namespace percuss::app
