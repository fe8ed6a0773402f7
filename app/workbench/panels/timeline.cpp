#include <algorithm>
#include <charconv>
#include <cmath>

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include "figures/ticks.hpp"
#include "workbench/panels/panel.hpp"

namespace percuss::app {
namespace {

/// Decimals that tell a thousand moments of the run apart.
int decimals_for(double shown_duration) {
    return shown_duration > 0 ? std::clamp(3 - static_cast<int>(std::floor(std::log10(shown_duration))), 0, 6)
                              : 1;
}

void show_slider(Workbench& w, const DisplayUnit& unit, double duration) {
    TimelineState& state = w.timeline;
    const bool live = w.run.live();
    // The newest moment that there is a picture of; the run is some steps ahead of it.
    const double newest = live ? w.run.newest()->time : w.run.timeline().end;
    const double end = state.held_end.value_or(newest);
    // While a recorded frame is being read, the slider stays where it was put.
    const double at = live ? end : w.run.looked_time();
    const double low = 0, high = unit.scale * std::max(end, 1e-9 * duration);
    double shown = std::min(unit.scale * at, high);
    const int decimals = decimals_for(unit.scale * duration);
    const std::string of_all = live ? "" : fmt::format(" of {:.{}f}", unit.scale * newest, decimals);
    const std::string format = fmt::format("%.{}f{} {}", decimals, of_all, unit.label);
    const bool moved = ImGui::SliderScalar("##time", ImGuiDataType_Double, &shown, &low, &high,
                                           format.c_str(), ImGuiSliderFlags_AlwaysClamp);
    w.names.name("time.slider");
    if (ImGui::IsItemActivated()) {
        state.held_end = newest;
        w.run.stop_playing();
    }
    if (moved) w.run.look_at(shown >= high ? end : shown / unit.scale);
    if (ImGui::IsItemDeactivated()) {
        state.held_end.reset();
        w.run.settle();
    }
    if (ImGui::IsItemActive()) return;
    tooltip(w.run.recorded()
                ? "The moment that is shown; [Left] and [Right]: one frame on. Ctrl and a click: type it."
                : "Looks back over the run, which goes on or waits undisturbed. A run that waits shows "
                  "the very moment, one that goes on those that were kept. Ctrl and a click: type it.");
}

void show_question(Workbench& w, const DisplayUnit& unit) {
    ImGui::AlignTextToFramePadding();
    const auto drops = w.run.branch_drops();
    if (drops)
        ImGui::TextUnformatted(fmt::format("This drops {:.4g} to {:.4g} {}:", unit.scale * (*drops)[0],
                                           unit.scale * (*drops)[1], unit.label)
                                   .c_str());
    else
        ImGui::TextDisabled("going there ...");
    w.names.name("time.question");
    if (drops) {
        ImGui::SameLine();
        command_button(w, "time.branch-confirm", "Go on");
    }
    ImGui::SameLine();
    command_button(w, "time.branch-cancel");
}

std::optional<double> positive(const std::string& text) {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
    return value > 0 && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

void take_speed(Workbench& w, const DisplayUnit& unit) {
    const std::string& text = w.timeline.speed;
    if (const auto value = positive(text))
        w.run.set_speed(*value / unit.scale);
    else if (text.empty())
        w.run.set_speed(std::nullopt);
    else
        w.tell(fmt::format("{}: a speed is a number above 0", text));
}

void show_speed(Workbench& w, const DisplayUnit& unit, double duration) {
    TimelineState& state = w.timeline;
    const float em = ImGui::GetFontSize(), room = ImGui::GetContentRegionAvail().x;
    const auto wanted = w.run.wanted_speed();
    const bool played = w.run.recorded() || w.run.playing();
    if (!state.typing_speed)
        state.speed = wanted ? fmt::format("{:.4g}", unit.scale * *wanted) : std::string();
    const std::string of = fmt::format("{}/s", unit.label);
    const float width =
        std::max(std::min(8.2F * em, room - 0.3F * em - ImGui::CalcTextSize(of.c_str()).x), 2 * em);
    const std::string hint = shortened(played ? "whole run in 10 s" : "as fast as can be",
                                       width - 2 * ImGui::GetStyle().FramePadding.x);
    ImGui::SetNextItemWidth(width);
    const bool entered =
        ImGui::InputTextWithHint("##speed", hint.c_str(), &state.speed,
                                 ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_CharsScientific |
                                     ImGuiInputTextFlags_AutoSelectAll);
    w.names.name("run.speed");
    if (entered || ImGui::IsItemDeactivatedAfterEdit()) take_speed(w, unit);
    state.typing_speed = ImGui::IsItemActive();
    const std::string help = fmt::format(
        "Simulated time for each second of yours [{}/s]; empty: as fast as can be, and what is looked back "
        "at is "
        "played in ten seconds.",
        unit.label);
    tooltip(help);
    ImGui::SameLine(0, 0.3F * em);
    ImGui::TextUnformatted(of.c_str());
    const std::string reached =
        w.run.speed() > 0 ? fmt::format("reached: {}/s", quantity_text(w.run.snapshot()->setup->scene.units,
                                                                       Quantity::time, w.run.speed()))
                          : std::string();
    const float told = 10 * em;
    ImGui::SameLine(0, 0.5F * em);
    if (const float left = ImGui::GetContentRegionAvail().x; left > 5 * em) {
        // Four powers of ten, around a run that takes some seconds.
        const double low = std::pow(10, std::floor(std::log10(unit.scale * duration * 1e-3))),
                     high = 1e4 * low;
        double value = wanted ? unit.scale * *wanted : high;
        ImGui::SetNextItemWidth(std::min(left > told + 5 * em ? left - told : left, 14 * em));
        const bool moved =
            ImGui::SliderScalar("##speeds", ImGuiDataType_Double, &value, &low, &high, wanted ? "%.3g" : "",
                                ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_NoRoundToFormat);
        w.names.name("run.speeds");
        tooltip(help);
        if (moved) w.run.set_speed(value / unit.scale);
        ImGui::SameLine(0, 0.5F * em);
    }
    if (ImGui::GetContentRegionAvail().x > ImGui::CalcTextSize(reached.c_str()).x)
        ImGui::TextUnformatted(reached.c_str());
    else
        ImGui::NewLine();
}

}  // namespace

float timeline_height(const Workbench& w) {
    if (!w.run.snapshot()) return 0;
    const ImGuiStyle& style = ImGui::GetStyle();
    return 2 * ImGui::GetFrameHeight() + style.ItemSpacing.y + 2 * style.WindowPadding.y;
}

void show_timeline(Workbench& w, const PanelArea& area) {
    if (!w.run.snapshot()) return;
    const Panel panel("time", area, true, false);
    const Scene& scene = w.run.snapshot()->setup->scene;
    const DisplayUnit unit = scene.units.display(Quantity::time, scene.duration);
    const ImGuiStyle& style = ImGui::GetStyle();
    const char* newest = w.run.recorded() ? "Last" : "Live";
    const float button = ImGui::CalcTextSize(newest).x + 2 * style.FramePadding.x;
    ImGui::SetNextItemWidth(-(button + style.ItemSpacing.x));
    show_slider(w, unit, scene.duration);
    ImGui::SameLine();
    const bool live = w.run.live();
    if (live) ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_ButtonActive));
    command_button(w, "time.live", newest);
    if (live) ImGui::PopStyleColor();
    if (w.run.branch_asked()) {
        show_question(w, unit);
        return;
    }
    if (!w.run.recorded()) {
        ImGui::BeginDisabled(live);
        command_button(w, "time.branch");
        ImGui::EndDisabled();
        ImGui::SameLine();
    }
    show_speed(w, unit, scene.duration);
}

}  // namespace percuss::app
