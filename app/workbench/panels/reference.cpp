#include <cmath>

#include <fmt/format.h>
#include <imgui.h>

#include "workbench/glossary.hpp"
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
        ImGui::PushTextWrapPos(0);
        ImGui::TextDisabled("this run; change the design to compare");
        ImGui::PopTextWrapPos();
        return;
    }
    const Units& units = w.run.snapshot()->setup->scene.units;
    const auto differences = peak_differences(w.plots.plots, w.plots.columns, w.plots.curves, *w.reference);
    ImGui::PushTextWrapPos(0);
    ImGui::TextDisabled("peaks up to the time that both have");
    ImGui::PopTextWrapPos();
    // Where four columns have no room a tooltip tells the reference's.
    const bool narrow = ImGui::GetContentRegionAvail().x < 15 * ImGui::GetFontSize();
    const int columns = narrow ? 3 : 4;
    if (!ImGui::BeginTable("peaks", columns, ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingFixedFit)) return;
    ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthStretch);
    ImGui::TableSetupColumn("now");
    if (!narrow) ImGui::TableSetupColumn("reference");
    ImGui::TableSetupColumn("%");
    ImGui::TableHeadersRow();
    for (const PeakDifference& peak : differences) {
        // Of the magnitude: a force of compression that grows, grows.
        const double change = 100 * (std::abs(peak.present) / std::abs(peak.reference) - 1);
        const std::string reference = quantity_text(units, peak.quantity, peak.reference);
        std::string help = explain(peak.label);
        if (narrow) help = "reference: " + reference + (help.empty() ? "" : "\n" + help);
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        line_of_text(peak.label, false, help);
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(quantity_text(units, peak.quantity, peak.present).c_str());
        if (narrow) tooltip(help);
        ImGui::TableNextColumn();
        if (!narrow) {
            ImGui::TextUnformatted(reference.c_str());
            ImGui::TableNextColumn();
        }
        if (std::isfinite(change))
            ImGui::TextUnformatted(fmt::format("{:+.{}f}", change, std::abs(change) < 10 ? 1 : 0).c_str());
    }
    ImGui::EndTable();
}

}  // namespace percuss::app
