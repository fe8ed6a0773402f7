#include <algorithm>

#include <imgui.h>

#include "workbench/command_table.hpp"
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
    const char* heading = unwritten   ? "This was not written"
                          : !refused  ? "The run diverged; shown is the last sound step"
                          : !snapshot ? "This cannot be used"
                                      : "This cannot be used; what is shown is the scene before";
    const ImGuiStyle& style = ImGui::GetStyle();
    const float width = viewport.width - 2 * style.WindowPadding.x;
    // As high as it takes, buttons and all; a long list scrolls and leaves some of the picture.
    float height = 2 * style.WindowPadding.y + 2 * ImGui::GetFrameHeightWithSpacing();
    ImGui::PushFont(w.screen.fonts().bold);
    height += ImGui::CalcTextSize(heading, nullptr, false, width).y + style.ItemSpacing.y;
    ImGui::PopFont();
    for (const std::string& text : lines)
        height += ImGui::CalcTextSize(text.c_str(), nullptr, false, width).y + style.ItemSpacing.y;
    height = std::min(height, 0.85F * viewport.height);
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
    ImGui::PushTextWrapPos(0);
    ImGui::TextUnformatted(heading);
    ImGui::PopFont();
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
        const std::string& title = find_command("scene.file-values")->title;
        same_line_for(ImGui::CalcTextSize(title.c_str()).x + 2 * style.FramePadding.x);
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
