#include <algorithm>
#include <utility>

#include <fmt/format.h>
#include <imgui.h>

#include "workbench/panels/panel.hpp"
#include "workbench/viewport_actions.hpp"

namespace percuss::app {
namespace {

/// Name, where it is, and what it shows now. @returns whether it is to be removed.
bool show_probe(Workbench& w, const ProbeCurve& probe, bool removable) {
    const Snapshot& now = *w.run.snapshot();
    bool remove = false;
    for (std::size_t k = 0; k < probe.readings.size(); ++k) {
        const ProbeReading& reading = probe.readings[k];
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        if (k == 0) {
            ImGui::Selectable(fmt::format("{}##{}", probe.probe.name, removable).c_str());
            w.names.name("probes." + probe.probe.name);
            if (ImGui::IsItemHovered()) w.marks.hovered_probe = probe.probe.name;
            tooltip(fmt::format("In body {}, {} {}, at {:.6g}, {:.6g} at the start.", probe.probe.body,
                                reading.cell >= 0 ? "element" : "node",
                                reading.cell >= 0 ? reading.cell : reading.node, probe.probe.at.x(),
                                probe.probe.at.y()));
        }
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(reading.field.title.c_str());
        explain_tooltip(reading.field.title);
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(
            quantity_text(now.setup->scene.units, reading.field.quantity, value_of(now, reading)).c_str());
        ImGui::TableNextColumn();
        if (!removable || k > 0) continue;
        remove = ImGui::SmallButton(fmt::format("x##{}", probe.probe.name).c_str());
        w.names.name("probes." + probe.probe.name + ".remove");
        tooltip("Removes this probe.");
    }
    return remove;
}

/// The file has no rows of these probes, only frames, which are read one after the other.
void show_frames_read(const Workbench& w) {
    const std::size_t frames = w.run.timeline().frames.size();
    std::size_t read = frames;
    for (const ProbeCurve& probe : w.marks.probes.all()) read = std::min(read, probe.curves->rows());
    const std::string words = w.run.reading_probes() ? fmt::format("reading {} of {} frames", read, frames)
                                                     : fmt::format("from {} recorded frames", read);
    line_of_text(words, true,
                 "The file has every step of the scene's own probes. Those put in here are read off its "
                 "frames: what came and went between two of them is not seen.");
}

}  // namespace

void show_probes(Workbench& w) {
    ViewportMarks& m = w.marks;
    if (std::exchange(m.list_probes, false)) ImGui::SetNextItemOpen(true);
    const bool open = ImGui::CollapsingHeader("Probes");
    w.names.name("header.probes");
    explain_tooltip("probe");
    if (!open || !w.run.snapshot()) return;
    if (m.scene_probes.empty() && m.probes.all().empty()) {
        ImGui::PushTextWrapPos(0);
        ImGui::TextDisabled("a click on a body puts one there");
        ImGui::PopTextWrapPos();
        return;
    }
    if (w.run.recorded() && !m.probes.all().empty()) show_frames_read(w);
    std::string removed;
    if (ImGui::BeginTable("probes", 4, ImGuiTableFlags_SizingFixedFit)) {
        ImGui::TableSetupColumn("name");
        ImGui::TableSetupColumn("field", ImGuiTableColumnFlags_WidthStretch);
        for (const ProbeCurve& probe : m.scene_probes) show_probe(w, probe, false);
        for (const ProbeCurve& probe : m.probes.all())
            if (show_probe(w, probe, true)) removed = probe.probe.name;
        ImGui::EndTable();
    }
    if (!removed.empty()) w.run.remove_probe(removed);
    if (w.run.probes().empty()) return;
    command_button(w, "probe.clear", "Remove all");
    ImGui::SameLine();
    command_button(w, "probe.copy", "Copy as scene text");
}

}  // namespace percuss::app
