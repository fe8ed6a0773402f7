#include <algorithm>

#include <imgui.h>

#include "workbench/panels/panel.hpp"

namespace percuss::app {

void show_messages(Workbench& w, const PanelArea& viewport) {
    std::vector<std::string> lines = w.run.messages();
    const auto& snapshot = w.run.snapshot();
    const bool diverged = snapshot && snapshot->status == RunStatus::diverged;
    const bool refused = !lines.empty();
    if (diverged) lines.push_back(snapshot->message);
    const bool unwritten = lines.empty() && !w.exports.faults().empty();
    lines.insert(lines.end(), w.exports.faults().begin(), w.exports.faults().end());
    if (lines.empty()) return;
    const float line = ImGui::GetTextLineHeightWithSpacing();
    const float height =
        std::min(0.6F * viewport.height, (3.2F + 1.6F * static_cast<float>(lines.size())) * line);
    ImGui::PushStyleColor(ImGuiCol_WindowBg, w.screen.dark() ? ImVec4{0.25F, 0.08F, 0.08F, 0.96F}
                                                             : ImVec4{1, 0.93F, 0.92F, 0.97F});
    ImGui::SetNextWindowPos({viewport.x, viewport.y});
    ImGui::SetNextWindowSize({viewport.width, height});
    ImGui::Begin("messages", nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoSavedSettings);
    const ImVec2 low = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
    w.names.place("messages", {low.x, low.y, low.x + size.x, low.y + size.y});
    ImGui::PushFont(w.screen.fonts().bold);
    ImGui::TextUnformatted(unwritten   ? "This was not written"
                           : !refused  ? "The run diverged; shown is the last sound step"
                           : !snapshot ? "This cannot be used"
                                       : "This cannot be used; what is shown is the scene before");
    ImGui::PopFont();
    ImGui::PushTextWrapPos(0);
    for (const std::string& text : lines) ImGui::TextUnformatted(text.c_str());
    ImGui::PopTextWrapPos();
    if (refused || !w.exports.faults().empty()) {
        if (ImGui::Button("Dismiss")) {
            w.run.dismiss_messages();
            w.exports.dismiss_faults();
        }
        w.names.name("messages.dismiss");
    }
    if (refused) {
        ImGui::SameLine();
        command_button(w, "scene.file-values");
    } else if (diverged) {
        command_button(w, "run.reset");
        if (snapshot->failed_cell >= 0) {
            ImGui::SameLine();
            command_button(w, "view.failure");
        }
    }
    ImGui::End();
    ImGui::PopStyleColor();
}

}  // namespace percuss::app
