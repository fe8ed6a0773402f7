#include <array>
#include <utility>

#include <imgui.h>

#include "workbench/command_table.hpp"
#include "workbench/glossary.hpp"
#include "workbench/panels/panel.hpp"

namespace percuss::app {
namespace {

constexpr std::array<std::pair<const char*, const char*>, 10> mouse{{
    {"drag in the picture", "moves it"},
    {"wheel in the picture", "zooms at the cursor"},
    {"double click on a body", "zooms to it; beside the bodies: fits all"},
    {"click on a body",
     "or with the right button: a menu with probes, following a node, zooming to the body"},
    {"mouse on a contact curve's name", "marks master nodes and slave sides of the pair in the picture"},
    {"mouse at rest", "values at the cursor, and what a term means"},
    {"wheel over a plot", "zooms its time axis at the cursor, for all plots"},
    {"drag in a plot", "moves the times shown; double click: all times"},
    {"click on a curve's name", "shows or hides it"},
    {"drop a file", "opens the scene"},
}};

void row(const char* key, const char* title, const char* help) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(key);
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(title);
    ImGui::TableNextColumn();
    ImGui::TextWrapped("%s", help);
}

}  // namespace

void show_help(Workbench& w) {
    if (!w.help) return;
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({0.5F * display.x, 0.5F * display.y}, ImGuiCond_Always, {0.5F, 0.5F});
    ImGui::SetNextWindowSize({std::min(0.94F * display.x, 56 * ImGui::GetFontSize()), 0.9F * display.y});
    ImGui::SetNextWindowBgAlpha(1);  // a page to read
    ImGui::Begin("Keys and commands", &w.help,
                 ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse |
                     ImGuiWindowFlags_NoSavedSettings);
    const ImVec2 low = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
    w.names.place("help.page", {low.x, low.y, low.x + size.x, low.y + size.y});
    if (ImGui::BeginTable("commands", 3, ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingFixedFit)) {
        ImGui::TableSetupColumn("key");
        ImGui::TableSetupColumn("what");
        ImGui::TableSetupColumn("help", ImGuiTableColumnFlags_WidthStretch);
        for (const WorkbenchCommand& command : workbench_commands())
            row(command.key.c_str(), command.title.c_str(), command.help.c_str());
        ImGui::EndTable();
    }
    ImGui::Separator();
    if (ImGui::BeginTable("mouse", 2, ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingFixedFit)) {
        for (const auto& [what, does] : mouse) {
            ImGui::TableNextRow();
            ImGui::TableNextColumn();
            ImGui::TextUnformatted(what);
            ImGui::TableNextColumn();
            ImGui::TextUnformatted(does);
        }
        ImGui::EndTable();
    }
    ImGui::Separator();
    if (ImGui::BeginTable("glossary", 2, ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingFixedFit)) {
        ImGui::TableSetupColumn("term");
        ImGui::TableSetupColumn("meaning", ImGuiTableColumnFlags_WidthStretch);
        for (const Term& term : glossary()) {
            ImGui::TableNextRow();
            ImGui::TableNextColumn();
            ImGui::TextUnformatted(term.words.front().c_str());
            ImGui::TableNextColumn();
            ImGui::TextWrapped("%s", term.meaning.c_str());
        }
        ImGui::EndTable();
    }
    ImGui::End();
}

}  // namespace percuss::app
