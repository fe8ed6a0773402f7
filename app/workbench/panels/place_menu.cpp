#include <fmt/format.h>
#include <imgui.h>

#include "workbench/command_table.hpp"
#include "workbench/panels/panel.hpp"
#include "workbench/panels/viewport_parts.hpp"
#include "workbench/viewport_actions.hpp"

namespace percuss::app {
namespace {

bool item(Workbench& w, const std::string& text, const std::string& name, const std::string& help) {
    const bool chosen = ImGui::MenuItem(text.c_str());
    w.names.name("viewport.menu." + name);
    tooltip(help);
    return chosen;
}

void command_item(Workbench& w, const char* name) {
    const WorkbenchCommand& command = *find_command(name);
    if (item(w, command.title, name, command.help)) command.act(w);
}

void choose_probe_field(Workbench& w, const Scene& scene) {
    const bool open = ImGui::BeginMenu("Probe here: another field");
    w.names.name("viewport.menu.fields");
    if (!open) return;
    for (const FieldInfo& field : available_fields(scene)) {
        if (ImGui::MenuItem(field.title.c_str())) add_probe_at(w, w.marks.menu, field.name);
        w.names.name("viewport.menu.fields." + field.name);
        explain_tooltip(field.title);
    }
    ImGui::EndMenu();
}

void show_items(Workbench& w) {
    const ViewportMarks& m = w.marks;
    if (m.menu.body >= 0) {
        const RunSetup& setup = *w.viewport.setup;
        const std::string& body = setup.mesh.bodies[static_cast<std::size_t>(m.menu.body)].name;
        ImGui::TextDisabled("%s, element %d, node %d", body.c_str(), m.menu.cell, m.menu.node);
        const FieldInfo& field = w.viewport.view->field();
        if (item(w, "Probe here: " + field.title, "probe",
                 w.run.recorded() ? "A curve of it over the recorded frames."
                                  : "A curve of it, at each step from now on."))
            add_probe_at(w, m.menu, field.name);
        choose_probe_field(w, setup.scene);
        if (item(w, "Follow this node", "follow", "The picture moves with it.")) follow_node(w, m.menu.node);
        if (item(w, "Zoom to " + body, "zoom", "Shows this body as large as there is room."))
            zoom_to(w, static_cast<std::size_t>(m.menu.body));
        ImGui::Separator();
    }
    if (m.followed && item(w, "Stop following", "stop", "The picture stays where it is.")) stop_following(w);
    command_item(w, "view.fit");
    command_item(w, "view.scene");
    command_item(w, "view.pairs");
    if (!w.run.probes().empty()) command_item(w, "probe.clear");
}

}  // namespace

void show_place_menu(Workbench& w) {
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding,
                        {0.6F * ImGui::GetFontSize(), 0.5F * ImGui::GetFontSize()});
    if (ImGui::BeginPopup("viewport.menu")) {
        show_items(w);
        ImGui::EndPopup();
    }
    ImGui::PopStyleVar();
}

}  // namespace percuss::app
