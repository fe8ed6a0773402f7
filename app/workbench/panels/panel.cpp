#include "workbench/panels/panel.hpp"

#include <fmt/format.h>
#include <imgui.h>

#include "figures/ticks.hpp"
#include "workbench/command_table.hpp"
#include "workbench/glossary.hpp"

namespace percuss::app {

Panel::Panel(const char* name, const PanelArea& area, bool padded, bool scrolls) {
    ImGui::SetNextWindowPos({area.x, area.y});
    ImGui::SetNextWindowSize({area.width, area.height});
    if (!padded) ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
    ImGuiWindowFlags flags = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                             ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse |
                             ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoSavedSettings;
    if (!scrolls) flags |= ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse;
    ImGui::Begin(name, nullptr, flags);
    if (!padded) ImGui::PopStyleVar();
}

Panel::~Panel() { ImGui::End(); }

void same_line_for(float width, float gap) {
    const float apart = gap < 0 ? ImGui::GetStyle().ItemSpacing.x : gap;
    const float right = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;
    if (ImGui::GetItemRectMax().x + apart + width <= right) ImGui::SameLine(0, apart);
}

std::string shortened(const std::string& text, float width) {
    if (ImGui::CalcTextSize(text.c_str()).x <= width) return text;
    std::string part = text;
    while (!part.empty()) {
        const bool within =
            (static_cast<unsigned char>(part.back()) & 0xC0U) == 0x80U;  // a letter of more bytes
        part.pop_back();
        if (within) continue;
        while (!part.empty() && part.back() == ' ') part.pop_back();
        if (ImGui::CalcTextSize((part + "\u2026").c_str()).x <= width) break;
    }
    return part + "\u2026";
}

void line_of_text(const std::string& text, bool soft, const std::string& help) {
    const std::string fitting = shortened(text, ImGui::GetContentRegionAvail().x);
    if (soft)
        ImGui::TextDisabled("%s", fitting.c_str());
    else
        ImGui::TextUnformatted(fitting.c_str());
    if (fitting == text)
        tooltip(help);
    else
        tooltip(help.empty() ? text : text + "\n" + help);
}

bool begin_choice(Workbench& w, const char* label, const std::string& chosen, const std::string& name,
                  const std::string& help) {
    const float room =
        ImGui::CalcItemWidth() - ImGui::GetFrameHeight() - 2 * ImGui::GetStyle().FramePadding.x;
    const std::string fitting = shortened(chosen, room);
    const bool open = ImGui::BeginCombo(label, fitting.c_str());
    w.names.name(name);
    if (open) return true;
    if (fitting == chosen)
        tooltip(help);
    else
        tooltip(help.empty() ? chosen : chosen + "\n" + help);
    return false;
}

void tooltip(const std::string& text) {
    if (text.empty() || !ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(28 * ImGui::GetFontSize());
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

void explain_tooltip(const std::string& text, const std::string& first) {
    if (!ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
    const std::string terms = explain(text);
    tooltip(first.empty() || terms.empty() ? first + terms : first + "\n" + terms);
}

namespace {

std::string help_of(const WorkbenchCommand& command) {
    std::string text = command.help.empty() ? command.title : command.help;
    if (!command.key.empty()) text += fmt::format("  [{}]", command.key);
    return text;
}

}  // namespace

bool command_button(Workbench& workbench, const char* name, const char* label, float width) {
    const WorkbenchCommand& command = *find_command(name);
    const std::string text = fmt::format("{}##{}", *label != '\0' ? label : command.title.c_str(), name);
    const bool pressed = ImGui::Button(text.c_str(), {width, 0});
    workbench.names.name(command.name);
    explain_tooltip(command.title + ". " + command.help, help_of(command));
    if (pressed) command.act(workbench);
    return pressed;
}

void command_box(Workbench& workbench, const char* name) {
    const WorkbenchCommand& command = *find_command(name);
    bool on = command.on(workbench);
    if (ImGui::Checkbox(fmt::format("{}##{}", command.title, name).c_str(), &on)) command.act(workbench);
    workbench.names.name(command.name);
    explain_tooltip(command.title + ". " + command.help, help_of(command));
}

std::string quantity_text(const Units& units, Quantity quantity, double value) {
    const DisplayUnit unit = units.display(quantity, value);
    const std::string number = render::format_number(unit.scale * value);
    return unit.label.empty() ? number : number + " " + unit.label;
}

const char* status_word(RunStatus status) {
    switch (status) {
        case RunStatus::paused:
            return "paused";
        case RunStatus::running:
            return "running";
        case RunStatus::finished:
            return "finished";
        case RunStatus::diverged:
            return "diverged";
    }
    return "";
}

}  // namespace percuss::app
