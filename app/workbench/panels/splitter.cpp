#include <algorithm>
#include <cmath>

#include <imgui.h>

#include "workbench/panels/panel.hpp"

namespace percuss::app {

float panel_width(const std::optional<double>& chosen, float by_itself) {
    if (!chosen) return std::round(by_itself);  // pictures between panels lie on whole pixels
    const float display = ImGui::GetIO().DisplaySize.x, em = ImGui::GetFontSize();
    return std::round(
        std::clamp(static_cast<float>(*chosen) * em, std::min(9 * em, 0.25F * display), 0.45F * display));
}

void show_splitter(Workbench& w, const char* name, const PanelArea& area, float present,
                   bool grows_rightwards, std::optional<double>& chosen) {
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1, 1});
    const Panel panel(name, area, false, false);
    ImGui::PopStyleVar();
    ImGui::InvisibleButton(name, {area.width, area.height});
    w.names.name(name);
    const bool active = ImGui::IsItemActive();
    if (active || ImGui::IsItemHovered()) {
        ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
        ImGui::GetWindowDrawList()->AddRectFilled(
            {area.x, area.y}, {area.x + area.width, area.y + area.height},
            ImGui::GetColorU32(active ? ImGuiCol_SeparatorActive : ImGuiCol_SeparatorHovered));
    }
    if (!active) tooltip("Drag: width of the panel; double click: as it was.");
    const float by = ImGui::GetIO().MouseDelta.x;
    if (active && by != 0) chosen = (present + (grows_rightwards ? by : -by)) / ImGui::GetFontSize();
    if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) chosen.reset();
}

}  // namespace percuss::app
