#include "workbench/workbench.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

#include <imgui.h>

#include "workbench/command_table.hpp"
#include "workbench/panels/panel.hpp"
#include "workbench/viewport_actions.hpp"

namespace percuss::app {
namespace {

void obey_keys(Workbench& w) {
    const ImGuiIO& io = ImGui::GetIO();
    for (const WorkbenchCommand& command : workbench_commands()) {
        if (command.key.empty()) continue;
        const KeyChord chord = parse_key(command.key);
        // Keys that are letters of a text belong to the text.
        if (io.WantTextInput && !chord.ctrl && !command.key.starts_with("F")) continue;
        if (io.WantTextInput && chord.ctrl) continue;
        if (chord.ctrl != io.KeyCtrl || io.KeyAlt || io.KeySuper) continue;
        const bool repeats = command.name == "run.step";
        if (ImGui::IsKeyPressed(chord.key, repeats)) command.act(w);
    }
}

void watch_file(Workbench& w) {
    // Not each frame: the file may be on a slow disk. An editor may still be writing it.
    if (w.reload_by_itself && w.frames % 20 == 0 && w.run.file_changed()) w.run.reload();
}

}  // namespace

void Workbench::frame() {
    names.begin_frame();
    for (const std::filesystem::path& file : screen.take_dropped_files()) open(file);
    watch_file(*this);
    if (std::chrono::steady_clock::now() > note_until_) note_.clear();
    run.update();
    if (reference) reference->follow(run.history(), run.snapshot());
    follow_run(*this);
    obey_keys(*this);

    const ImVec2 display = ImGui::GetIO().DisplaySize;
    const ImGuiStyle& style = ImGui::GetStyle();
    const float em = ImGui::GetFontSize();
    PanelArea middle{0, 0, display.x, display.y};
    if (panels) {
        const float menu = ImGui::GetFrameHeight();
        const float bar = 2 * ImGui::GetFrameHeight() + style.ItemSpacing.y + 2 * style.WindowPadding.y;
        show_menu(*this);
        show_run_bar(*this, {0, menu, display.x, bar});
        const float top = menu + bar, height = std::max(display.y - top, 1.0F);
        const float left = std::min(21 * em, 0.3F * display.x), right = std::min(0.31F * display.x, 40 * em);
        {
            const Panel panel("settings", {0, top, left, height});
            show_view_settings(*this);
            show_probes(*this);
            show_design(*this);
            show_reference(*this);
            show_time_spent(*this);
        }
        show_plots(*this, {display.x - right, top, right, height});
        middle = {left, top, display.x - left - right, height};
    }
    show_viewport(*this, middle);
    show_messages(*this, middle);
    show_scene_picker(*this);
    show_help(*this);

    ++frames;
}

bool Workbench::at_rest() const {
    return run.status() != RunStatus::running && !run.building() && !viewport.dirty &&
           viewport.drawn == run.snapshot() && !marks.clicked;
}

void Workbench::tell(std::string words) {
    note_ = std::move(words);
    note_until_ = std::chrono::steady_clock::now() + std::chrono::seconds(5);
}

void Workbench::do_command(const std::string& name) {
    if (const WorkbenchCommand* command = find_command(name)) command->act(*this);
}

}  // namespace percuss::app
