#include <algorithm>

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include "workbench/command_table.hpp"
#include "workbench/panels/panel.hpp"

namespace percuss::app {
namespace {

void field(Workbench& w, const char* name, const char* help) {
    w.names.name(name);
    tooltip(help);
}

/// Goes on in the same line when a widget of this width fits into it.
void same_line(float width) {
    const float right = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;
    if (ImGui::GetItemRectMax().x + ImGui::GetStyle().ItemSpacing.x + width <= right) ImGui::SameLine();
}

void button_beside(Workbench& w, const char* command, const char* label = "") {
    const char* words = *label != '\0' ? label : find_command(command)->title.c_str();
    same_line(ImGui::CalcTextSize(words).x + 2 * ImGui::GetStyle().FramePadding.x);
    command_button(w, command, label);
}

void box_beside(const char* label, bool& on) {
    same_line(ImGui::CalcTextSize(label).x + ImGui::GetFrameHeight() + ImGui::GetStyle().ItemInnerSpacing.x);
    ImGui::Checkbox(label, &on);
}

void show_film(Workbench& w, const Units& units, double duration) {
    ExportSettings& s = w.exports.settings;
    const DisplayUnit unit = units.display(Quantity::time, duration);
    const double end = std::max(w.run.timeline().end, w.run.snapshot()->time);
    double times[2] = {unit.scale * s.from, unit.scale * s.to.value_or(end)};
    const std::string label = fmt::format("times [{}]###times", unit.label);
    if (ImGui::InputScalarN(label.c_str(), ImGuiDataType_Double, times, 2, nullptr, nullptr, "%.6g",
                            ImGuiInputTextFlags_EnterReturnsTrue)) {
        s.from = times[0] / unit.scale;
        // Typed as the end of the run, it follows the run on.
        s.to = times[1] >= unit.scale * end ? std::nullopt : std::optional(times[1] / unit.scale);
    }
    field(w, "export.times", "First and last moment of films and sequences; the last follows the run.");
    ImGui::InputInt("pictures", &s.count, 0);
    field(w, "export.count",
          "How many pictures films and sequences have, evenly spaced between these moments.");
    s.count = std::clamp(s.count, 1, 100000);
    ImGui::InputDouble("a second", &s.frames_per_second, 0, 0, "%.4g");
    field(w, "export.fps", "Pictures shown in each second of a film or recording.");
    int size[2] = {s.size[0], s.size[1]};
    const auto& drawn = w.viewport.drawn_size;
    if (size[0] <= 0 || size[1] <= 0) size[0] = drawn[0], size[1] = drawn[1];
    if (ImGui::InputInt2("pixels", size, ImGuiInputTextFlags_EnterReturnsTrue)) {
        const bool as_shown = size[0] == drawn[0] && size[1] == drawn[1];
        s.size = as_shown ? std::array{0, 0}
                          : std::array{std::clamp(size[0], 0, 8192), std::clamp(size[1], 0, 8192)};
    }
    field(w, "export.size", "Width and height of films and sequences; 0 0: as the viewport.");
}

void show_work(Workbench& w) {
    if (!w.exports.working()) return;
    ImGui::ProgressBar(static_cast<float>(w.exports.progress()), {12 * ImGui::GetFontSize(), 0});
    w.names.name("export.progress");
    button_beside(w, "export.cancel");
}

void show_written(const Workbench& w) {
    const auto& written = w.exports.written();
    constexpr std::size_t most = 4;
    for (std::size_t i = written.size() - std::min(most, written.size()); i < written.size(); ++i) {
        ImGui::PushTextWrapPos(0);
        ImGui::TextDisabled("%s", written[i].c_str());
        ImGui::PopTextWrapPos();
    }
}

}  // namespace

void show_export(Workbench& w) {
    ExportSettings& s = w.exports.settings;
    if (s.to_panel > 0) ImGui::SetNextItemOpen(true);
    const bool open = ImGui::CollapsingHeader("Export");
    w.names.name("header.export");
    // Its height is known in the frame after it was opened.
    if (s.to_panel > 0) ImGui::SetScrollHereY(0), --s.to_panel;
    if (!open || !w.run.snapshot()) return;
    const Scene& scene = w.run.snapshot()->setup->scene;
    ImGui::PushItemWidth(-5.5F * ImGui::GetFontSize());
    ImGui::InputText("name", &s.name);
    field(w, "export.name",
          "What the files are called, with a folder if you like; their kind is added, and a number where "
          "a name is taken: nothing is replaced.");
    ImGui::SliderInt("enlarge", &s.factor, 1, 4, "%dx", ImGuiSliderFlags_AlwaysClamp);
    field(w, "export.factor", "How much larger than on the screen a picture is.");
    command_button(w, "export.picture");
    button_beside(w, "export.figures");
    command_button(w, "export.plots-csv");
    button_beside(w, "export.plots-png");
    ImGui::Spacing();
    show_film(w, scene.units, scene.duration);
    command_button(w, "export.film");
    button_beside(w, "export.sequence");
    const bool recording = w.exports.recording();
    if (recording) ImGui::PushStyleColor(ImGuiCol_Button, {0.85F, 0.25F, 0.2F, 1});
    button_beside(w, "export.record", recording ? "End recording" : "");
    if (recording) ImGui::PopStyleColor();
    show_work(w);
    ImGui::Spacing();
    ImGui::InputText("scene", &s.scene);
    field(w, "scene.save-name", "File that the scene is saved to, with the values set here.");
    command_button(w, "scene.save");
    box_beside("with view", s.with_view);
    field(w, "scene.save-view", "Saves field, colours, range and what else the picture shows, too.");
    box_beside("replace", s.replace);
    field(w, "scene.save-replace", "Allows the next save to replace a file that exists.");
    ImGui::PopItemWidth();
    show_written(w);
}

}  // namespace percuss::app
