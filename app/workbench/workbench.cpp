#include "workbench/workbench.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
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
        const bool repeats = command.name == "run.step" || command.name == "time.back";
        if (ImGui::IsKeyPressed(chord.key, repeats)) command.act(w);
    }
}

void watch_file(Workbench& w) {
    // Not each frame: the file may be on a slow disk. An editor may still be writing it.
    if (w.reload_by_itself && w.frames % 20 == 0 && w.run.file_changed()) w.run.reload();
}

/// Takes over what the run has come to, and what is shown beside it.
void update_run(Workbench& w) {
    const auto shown = w.run.snapshot();
    const auto history = w.run.history();
    const auto file = w.run.file();
    const int builds = w.run.builds();
    w.run.update();
    if (!w.run.snapshot()) return;
    if (w.run.builds() != builds) {
        if (!file.empty() && w.run.file() != file) w.beside.clear();
        // The reference's outline shows it already.
        const bool is_reference = w.reference && w.reference->history == history;
        if (w.run.file() != file || w.run.recorded())
            w.ghost = {};
        else if (!is_reference)
            w.ghost.replaced(shown);
    }
    w.ghost.follow(w.run.newest()->time, w.run.status() == RunStatus::finished);
    if (w.reference) w.reference->follow(w.run.snapshot()->time);
    for (BesideView& each : w.beside) each.run->follow(w.run.newest()->time, w.run.snapshot()->time);
}

/// Which sections of the panel on the left are open; only those are known that were ever clicked.
void follow_sections(Workbench& w) {
    ImGuiStorage& open = *ImGui::GetStateStorage();
    if (w.frames == 0)
        for (const auto& [id, on] : w.layout.sections) open.SetBool(id, on);
    for (const auto& pair : open.Data) w.layout.sections[pair.key] = pair.val_i != 0;
}

void follow_scene(Workbench& w) {
    if (!w.run.file().empty() && (w.layout.recent.empty() || w.opened != w.run.file())) {
        w.opened = w.run.file();
        w.layout.remember(w.opened);
    }
}

}  // namespace

void Workbench::use_layout(WindowLayout wanted) {
    layout = std::move(wanted);
    plots.toggled = layout.curves;
    if (layout.dark) screen.set_dark(*layout.dark);
}

void Workbench::frame() {
    names.begin_frame();
    for (const std::filesystem::path& file : screen.take_dropped_files()) open(file);
    watch_file(*this);
    if (std::chrono::steady_clock::now() > note_until_) note_.clear();
    update_run(*this);
    follow_scene(*this);
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
        const float left =
            panel_width(layout.left, std::min((has_lesson(*this) ? 26 : 21) * em, 0.3F * display.x));
        const float right = panel_width(layout.right, std::min(0.31F * display.x, 40 * em));
        const float grip = std::round(0.4F * em);
        // A lesson is read in the upper part of the panel on the left.
        const float read = has_lesson(*this) ? std::round((lesson.answered ? 0.85F : 0.62F) * height) : 0;
        if (read > 0) show_lesson(*this, {0, top, left, read});
        {
            const Panel panel("settings", {0, top + read, left, height - read});
            follow_sections(*this);
            show_view_settings(*this);
            show_probes(*this);
            show_design(*this);
            show_reference(*this);
            show_export(*this);
            show_time_spent(*this);
        }
        show_plots(*this, {display.x - right, top, right, height});
        const float strip = timeline_height(*this);
        show_splitter(*this, "splitter.left", {left, top, grip, height}, left, true, layout.left);
        show_splitter(*this, "splitter.right", {display.x - right - grip, top, grip, height}, right, false,
                      layout.right);
        middle = {left + grip, top, std::max(display.x - left - right - 2 * grip, 1.0F),
                  std::max(height - strip, 1.0F)};
        show_timeline(*this, {middle.x, top + middle.height, middle.width, strip});
    }
    show_viewport(*this, middle);
    show_messages(*this, middle);
    show_scene_picker(*this);
    show_help(*this);
    exports.advance(*this);

    ++frames;
}

void Workbench::add_beside(const std::filesystem::path& file, const std::vector<std::string>& overrides,
                           const std::string& label) {
    constexpr std::size_t most = 5;  // more would be stripes
    if (beside.size() == most)
        tell("no more than five runs fit beside this one");
    else
        beside.push_back({std::make_unique<BesideRun>(file, overrides, label, threads_)});
}

bool Workbench::at_rest() const {
    return !beside_busy() && run.status() != RunStatus::running && !run.playing() && !run.reading() &&
           !run.building() && !exports.busy() && !(pick_scene && thumbnails.busy()) && !viewport.dirty &&
           !marks.clicked && !run.branch_asked() && viewport.drawn == run.snapshot();
}

bool Workbench::beside_busy() const {
    return std::any_of(beside.begin(), beside.end(), [](const auto& b) { return b.run->busy(); });
}

void Workbench::tell(std::string words) {
    note_ = std::move(words);
    note_until_ = std::chrono::steady_clock::now() + std::chrono::seconds(5);
}

void Workbench::do_command(const std::string& name) {
    if (const WorkbenchCommand* command = find_command(name)) command->act(*this);
}

}  // namespace percuss::app
