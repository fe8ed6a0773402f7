#include <algorithm>
#include <charconv>
#include <cmath>

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

/// The name behind a widget; one that differs from the file can be taken back with the right button.
void label(Workbench& w, const std::string& key, const std::string& text, const std::string& help) {
    ImGui::SameLine();
    const bool changed = w.run.setting(key).has_value();
    if (changed)
        ImGui::TextColored(changed_colour, "%s", text.c_str());
    else
        ImGui::TextUnformatted(text.c_str());
    w.names.name("label." + key);
    if (changed && ImGui::IsItemClicked(ImGuiMouseButton_Right)) w.run.forget(key);
    tooltip(changed ? help + "\nChanged; a click with the right button takes the value of the file." : help);
}

void show_parameter(Workbench& w, const Parameter& parameter) {
    const std::string key = "parameters." + parameter.name;
    const std::string name =
        parameter.unit.empty() ? parameter.name : fmt::format("{} [{}]", parameter.name, parameter.unit);
    if (!parameter.expression.empty()) return;  // follows from the others
    double value = parameter.value;
    if (const auto set = w.run.setting(key)) value = number(*set).value_or(value);
    const std::string id = "##" + parameter.name;
    bool changed = false;
    ImGui::SetNextItemWidth(0.38F * ImGui::GetWindowWidth());
    std::string help = parameter.description;
    if (parameter.range) {
        const auto [low, high] = *parameter.range;
        const std::string format = fmt::format("%.{}f", decimals_for(high - low));
        changed = ImGui::SliderScalar(id.c_str(), ImGuiDataType_Double, &value, &low, &high, format.c_str(),
                                      ImGuiSliderFlags_AlwaysClamp);
        help +=
            fmt::format("\n{:g} to {:g} {}; Ctrl and a click: type the value.", low, high, parameter.unit);
    } else {
        changed = ImGui::InputScalar(id.c_str(), ImGuiDataType_Double, &value, nullptr, nullptr, "%.6g",
                                     ImGuiInputTextFlags_EnterReturnsTrue);
    }
    w.names.name(key);
    tooltip(help);
    if (changed) w.run.set(key, fmt::format("{:.9g}", value));
    label(w, key, name, help);
}

void show_step_fraction(Workbench& w, const Scene& scene) {
    if (scene.step.fixed) return;
    const std::string key = "model.step.courant";
    double value = scene.step.courant;
    if (const auto set = w.run.setting(key)) value = number(*set).value_or(value);
    const double low = 0.05, high = 1;
    ImGui::SetNextItemWidth(0.38F * ImGui::GetWindowWidth());
    const bool changed = ImGui::SliderScalar("##courant", ImGuiDataType_Double, &value, &low, &high, "%.2f",
                                             ImGuiSliderFlags_AlwaysClamp);
    w.names.name(key);
    if (changed) w.run.set(key, fmt::format("{:.9g}", value));
    label(w, key, "step / critical",
          "Changes at the next step of the run.\n" + explain("Courant, critical step"));
}

void choose_scheme(Workbench& w, const Scene& scene) {
    if (scene.contacts.empty()) return;
    const std::string key = "contact_solver.scheme";
    const char* present = scene.contact_solver.scheme == ContactScheme::joint ? "joint" : "projection";
    ImGui::SetNextItemWidth(0.38F * ImGui::GetWindowWidth());
    const bool open = ImGui::BeginCombo("##scheme", present);
    w.names.name(key);
    if (open) {
        for (const char* scheme : {"projection", "joint"}) {
            if (ImGui::Selectable(scheme, scheme == std::string_view(present)))
                w.run.set(key, fmt::format("\"{}\"", scheme));
            w.names.name(key + "." + scheme);
        }
        ImGui::EndCombo();
    }
    label(w, key, "contact", explain("projection, joint"));
}

void show_effects(const Scene& scene) {
    for (const EffectInfo& effect : effects_of(scene)) {
        if (!effect.on) continue;
        ImGui::BulletText("%s", effect.name.c_str());
        explain_tooltip(effect.name, "Costs " + effect.cost + ".");
    }
}

}  // namespace

void show_design(Workbench& w) {
    const bool open = ImGui::CollapsingHeader("Design", ImGuiTreeNodeFlags_DefaultOpen);
    w.names.name("header.design");
    if (!open || !w.run.snapshot()) return;
    const Scene& scene = w.run.snapshot()->setup->scene;
    bool any = false;
    for (const Parameter& parameter : scene.parameters) {
        show_parameter(w, parameter);
        any = any || parameter.expression.empty();
    }
    if (!any) ImGui::TextDisabled("the scene has no [parameters]");
    show_step_fraction(w, scene);
    choose_scheme(w, scene);
    command_button(w, "scene.file-values");
    const bool effects = ImGui::CollapsingHeader("Effects that are on");
    w.names.name("header.effects");
    if (effects) show_effects(scene);
}

}  // namespace percuss::app
