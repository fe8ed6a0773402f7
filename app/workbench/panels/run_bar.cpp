#include <algorithm>

#include <fmt/format.h>
#include <imgui.h>

#include "effects.hpp"
#include "figures/ticks.hpp"
#include "workbench/command_table.hpp"
#include "workbench/glossary.hpp"
#include "workbench/panels/panel.hpp"

namespace percuss::app {
namespace {

/// "830", "4.87 k", "1.2 M"
std::string count_text(double count) {
    const double scale = count >= 1e6 ? 1e6 : count >= 1e3 ? 1e3 : 1;
    return render::format_number(count / scale) + (scale == 1e6 ? " M" : scale == 1e3 ? " k" : "");
}

/// A command's button in the same line, where that has room; else the menu has it.
void button_where_room(Workbench& w, const char* command, float gap, const char* label = "") {
    const ImGuiStyle& style = ImGui::GetStyle();
    const std::string words = *label != '\0' ? label : find_command(command)->title;
    const float apart = gap > 0 ? gap : style.ItemSpacing.x;
    const float right =
        ImGui::GetItemRectMax().x + apart + ImGui::CalcTextSize(words.c_str()).x + 2 * style.FramePadding.x;
    if (right > ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x) return;
    ImGui::SameLine(0, apart);
    command_button(w, command, label);
}

void show_buttons(Workbench& w, const Units& units, double duration) {
    const float em = ImGui::GetFontSize();
    const bool narrow = ImGui::GetWindowWidth() < 56 * em;
    const float gap = narrow ? 0.6F * em : 1.4F * em, field = narrow ? 3.6F * em : 5 * em;
    const bool ended = w.run.status() == RunStatus::finished || w.run.status() == RunStatus::diverged;
    const char* label = "Run";
    if (!w.run.live())
        label = w.run.playing() ? "Pause" : "Play";
    else if (w.run.status() == RunStatus::running)
        label = "Pause";
    else if (ended)
        label = "Run again";
    command_button(w, "run.toggle", label, (narrow ? 5.2F : 6.0F) * em);
    ImGui::SameLine();
    command_button(w, "run.step", "Step");
    ImGui::SameLine(0, gap);
    ImGui::SetNextItemWidth(field);
    ImGui::InputInt("##step-count", &w.step_count, 0);
    w.names.name("run.step-count");
    tooltip("How many steps the next button makes.");
    ImGui::SameLine();
    command_button(w, "run.steps", "steps");
    ImGui::SameLine(0, gap);
    // In the unit of the time beside it, not in that of the scene.
    const DisplayUnit unit = units.display(Quantity::time, duration);
    double until = unit.scale * w.until;
    ImGui::SetNextItemWidth(field);
    if (ImGui::InputDouble("##until", &until, 0, 0, "%.6g")) w.until = until / unit.scale;
    w.names.name("run.until-time");
    tooltip(fmt::format("Simulated time at which the next button pauses [{}].", unit.label));
    ImGui::SameLine();
    command_button(w, "run.until", fmt::format("Run until [{}]", unit.label).c_str());
    button_where_room(w, "run.reset", gap);
    button_where_room(w, "scene.reload", 0);
    button_where_room(w, "view.fit", gap);
    const bool kept = w.reference.has_value();
    if (kept) ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_ButtonActive));
    button_where_room(w, "reference.toggle", 0, kept ? "Drop reference" : "Keep as reference");
    if (kept) ImGui::PopStyleColor();
    if (!w.run.building()) return;
    ImGui::SameLine(0, gap);
    ImGui::AlignTextToFramePadding();
    ImGui::TextColored({0.83F, 0.37F, 0, 1}, "building the scene ...");
}

/// Whether a name begins with one of the words between bars.
bool is_among(const std::string& name, std::string_view words) {
    while (!words.empty()) {
        const std::string_view word = words.substr(0, words.find('|'));
        if (name.starts_with(word)) return true;
        words.remove_prefix(std::min(words.size(), word.size() + 1));
    }
    return false;
}

void show_progress(Workbench& w, const Snapshot& now) {
    const Units& units = now.setup->scene.units;
    const double duration = now.setup->scene.duration;
    const DisplayUnit unit = units.display(Quantity::time, duration);
    const char* status = w.run.recorded() && !w.run.playing() ? "recorded" : status_word(w.run.status());
    const std::string text = fmt::format("{}  t = {:.4g} of {:.4g} {}", w.run.playing() ? "playing" : status,
                                         unit.scale * now.time, unit.scale * duration, unit.label);
    ImGui::ProgressBar(static_cast<float>(std::clamp(now.time / duration, 0.0, 1.0)),
                       {std::min(22 * ImGui::GetFontSize(), 0.45F * ImGui::GetWindowWidth()), 0},
                       text.c_str());
    w.names.name("run.progress");
    tooltip("Simulated time of the scene's duration.");
    ImGui::SameLine(0, 1.4F * ImGui::GetFontSize());
    ImGui::AlignTextToFramePadding();
    std::string facts = fmt::format("step {}", now.step);
    if (now.dt > 0)
        facts += fmt::format("  of {}, {:.2f} critical", quantity_text(units, Quantity::time, now.dt),
                             now.dt / now.critical_step);
    if (w.run.speed() > 0 && now.dt > 0 && !w.run.recorded())
        facts += fmt::format("     {} a second, {} steps a second",
                             quantity_text(units, Quantity::time, w.run.speed()),
                             count_text(w.run.speed() / now.dt));
    line_of_text(
        facts, false,
        "Number and size of the last step, its fraction of the critical one, and how fast the run goes: "
        "simulated time and steps for each second of yours.\n" +
            explain("time step, critical"));
}

}  // namespace

void show_run_bar(Workbench& w, const PanelArea& area) {
    const Panel panel("run", area, true, false);
    const auto& snapshot = w.run.snapshot();
    if (!snapshot) {
        ImGui::TextUnformatted(w.run.building() ? "building the scene ..." : "no scene yet");
        return;
    }
    show_buttons(w, snapshot->setup->scene.units, snapshot->setup->scene.duration);
    show_progress(w, *w.run.newest());
}

void show_time_spent(Workbench& w) {
    if (!ImGui::CollapsingHeader("Time spent by the engine")) {
        w.names.name("header.time-spent");
        return;
    }
    w.names.name("header.time-spent");
    if (!w.run.snapshot()) return;
    const RunStatistics& s = w.run.statistics();
    const std::vector<EffectInfo> effects = effects_of(w.run.snapshot()->setup->scene);
    struct Part {
        const char* name;
        double seconds;
        std::string_view effects;  // beginnings of the names of those that it takes
        bool always = true;        // else only where it took time
    };
    const Part parts[] = {
        {"elements", s.seconds.elements,
         "one-point quads|hourglass|mean-dilatation|triangles|averaged|bulk viscosity|plasticity|lagged"},
        {"contact search", s.seconds.contact_search, ""},
        {"contact solve", s.seconds.contact_solve, "contact|friction"},
        {"integration", s.seconds.integrate, "prescribed velocity"},
        {"critical step", s.seconds.critical_step, ""},
        {"loads", s.seconds.loads, "body force|pressure", false},
        {"probes", s.seconds.probes, "probes", false},
        {"histories", s.seconds.history, ""}};
    double total = 0;
    for (const Part& part : parts) total += part.seconds;
    for (const Part& part : parts) {
        if (!part.always && part.seconds == 0) continue;
        const double share = total > 0 ? part.seconds / total : 0;
        ImGui::ProgressBar(static_cast<float>(share), {7 * ImGui::GetFontSize(), 0},
                           fmt::format("{:.1f} %", 100 * share).c_str());
        ImGui::SameLine();
        ImGui::TextUnformatted(part.name);
        w.names.name(fmt::format("time-spent.{}", part.name));
        explain_tooltip(part.name);
        for (const EffectInfo& effect : effects) {
            if (!effect.on || !is_among(effect.name, part.effects)) continue;
            ImGui::Indent();
            ImGui::TextDisabled("%s", effect.name.c_str());
            w.names.name("time-spent." + effect.name);
            tooltip("On, and part of the time above it: " + effect.cost + ".");
            ImGui::Unindent();
        }
    }
    if (s.step_seconds > 0)
        ImGui::TextDisabled(
            "%s element-steps a second",
            count_text(static_cast<double>(s.cells) * static_cast<double>(s.steps) / s.step_seconds).c_str());
}

}  // namespace percuss::app
