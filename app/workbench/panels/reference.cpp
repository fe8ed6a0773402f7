#include <cmath>

#include <fmt/format.h>
#include <imgui.h>

#include "workbench/panels/panel.hpp"

namespace percuss::app {

void show_reference(Workbench& w) {
    const bool open = ImGui::CollapsingHeader("Reference");
    w.names.name("header.reference");
    explain_tooltip("reference");
    if (!open || !w.run.snapshot()) return;
    command_box(w, "reference.toggle");
    if (!w.reference) return;
    if (w.reference->history == w.run.history()) {
        ImGui::TextDisabled("this run; change the design to compare");
        return;
    }
    const Units& units = w.run.snapshot()->setup->scene.units;
    const auto differences = peak_differences(w.plots.plots, w.plots.columns, w.plots.curves, *w.reference);
    ImGui::TextDisabled("peaks up to the time that both have");
    if (!ImGui::BeginTable("peaks", 4, ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingFixedFit)) return;
    // In a narrow panel it is the name that is cut off.
    ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthStretch);
    for (const char* heading : {"now", "reference", "%"}) ImGui::TableSetupColumn(heading);
    ImGui::TableHeadersRow();
    for (const PeakDifference& peak : differences) {
        // Of the magnitude: a force of compression that grows, grows.
        const double change = 100 * (std::abs(peak.present) / std::abs(peak.reference) - 1);
        ImGui::TableNextRow();
        for (const std::string& text :
             {peak.label, quantity_text(units, peak.quantity, peak.present),
              quantity_text(units, peak.quantity, peak.reference),
              std::isfinite(change) ? fmt::format("{:+.{}f}", change, std::abs(change) < 10 ? 1 : 0)
                                    : std::string()}) {
            ImGui::TableNextColumn();
            ImGui::TextUnformatted(text.c_str());
            if (text == peak.label) explain_tooltip(text);
        }
    }
    ImGui::EndTable();
}

}  // namespace percuss::app
