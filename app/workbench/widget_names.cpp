#include "workbench/widget_names.hpp"

#include <imgui.h>

namespace percuss::app {

void WidgetNames::name(const std::string& name) {
    if (!ImGui::IsItemVisible()) return;
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    places_[name] = {low.x, low.y, high.x, high.y};
}

std::vector<std::string> WidgetNames::all() const {
    std::vector<std::string> names;
    for (const auto& [name, place] : places_) names.push_back(name);
    return names;
}

}  // namespace percuss::app
