#include <fmt/format.h>
#include <imgui.h>

#include "workbench/command_table.hpp"
#include "workbench/panels/panel.hpp"

namespace percuss::app {
namespace {

void item(Workbench& workbench, const WorkbenchCommand& command) {
    const bool on = command.on != nullptr && command.on(workbench);
    if (ImGui::MenuItem(command.title.c_str(), command.key.c_str(), on)) command.act(workbench);
    workbench.names.name("menu." + command.name);
    tooltip(command.help);
}

void menu(Workbench& workbench, const char* title, std::initializer_list<const char*> prefixes) {
    const bool open = ImGui::BeginMenu(title);
    workbench.names.name(fmt::format("menu.{}", title));
    if (!open) return;
    for (const char* prefix : prefixes)
        for (const WorkbenchCommand& command : workbench_commands())
            if (command.name.starts_with(prefix)) item(workbench, command);
    ImGui::EndMenu();
}

}  // namespace

void show_menu(Workbench& workbench) {
    if (!ImGui::BeginMainMenuBar()) return;
    menu(workbench, "Scene", {"scene.", "reference.", "quit"});
    menu(workbench, "Run", {"run.", "time."});
    menu(workbench, "View", {"view.", "probe.", "plots."});
    menu(workbench, "Export", {"export."});
    menu(workbench, "Window", {"panels.", "window."});
    menu(workbench, "Help", {"help"});
    std::string right = workbench.note();
    if (right.empty() && workbench.run.snapshot()) {
        const Scene& scene = workbench.run.snapshot()->setup->scene;
        right = fmt::format("{}  ({})", scene.title, workbench.run.file().filename().string());
    }
    const float em = ImGui::GetFontSize(), end = ImGui::GetWindowWidth() - em;
    const std::string fitting = shortened(right, std::max(end - ImGui::GetCursorPosX() - em, em));
    ImGui::SameLine(end - ImGui::CalcTextSize(fitting.c_str()).x);
    ImGui::TextDisabled("%s", fitting.c_str());
    if (fitting != right) tooltip(right);
    ImGui::EndMainMenuBar();
}

}  // namespace percuss::app
