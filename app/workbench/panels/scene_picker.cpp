#include <algorithm>
#include <cctype>
#include <set>

#include <imgui.h>
#include <imgui_stdlib.h>

#include "live/fuzzy.hpp"
#include "workbench/panels/panel.hpp"

namespace percuss::app {
namespace {

namespace fs = std::filesystem;

/// Scenes below scenes/ and beside the present one.
std::vector<std::string> find_scenes(const fs::path& present) {
    std::set<std::string> found;
    std::error_code unreadable;
    const auto add = [&](const fs::directory_entry& entry) {
        if (entry.path().extension() == ".toml") found.insert(entry.path().lexically_normal().string());
    };
    for (fs::recursive_directory_iterator entry("scenes", unreadable), end; !unreadable && entry != end;
         entry.increment(unreadable))
        add(*entry);
    const fs::path beside = present.has_parent_path() ? present.parent_path() : fs::path(".");
    for (fs::directory_iterator entry(beside, unreadable), end; !unreadable && entry != end;
         entry.increment(unreadable))
        add(*entry);
    return {found.begin(), found.end()};
}

struct PickerState {
    std::vector<std::string> scenes;
    std::string typed;
    std::size_t chosen = 0;
    bool open = false;
};

}  // namespace

void show_scene_picker(Workbench& w) {
    static PickerState picker;
    if (!w.pick_scene) {
        picker.open = false;
        return;
    }
    const bool fresh = !std::exchange(picker.open, true);
    if (fresh) picker = {find_scenes(w.run.file()), "", 0, true};
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    const float em = ImGui::GetFontSize();
    ImGui::SetNextWindowPos({0.5F * display.x, 0.12F * display.y}, ImGuiCond_Always, {0.5F, 0});
    ImGui::SetNextWindowSize({std::min(38 * em, 0.9F * display.x), std::min(26 * em, 0.7F * display.y)});
    ImGui::Begin("Open a scene", &w.pick_scene,
                 ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse |
                     ImGuiWindowFlags_NoSavedSettings);
    if (fresh) ImGui::SetKeyboardFocusHere();
    ImGui::SetNextItemWidth(-1);
    const bool entered = ImGui::InputTextWithHint("##name", "some letters of its name, or a path",
                                                  &picker.typed, ImGuiInputTextFlags_EnterReturnsTrue);
    w.names.name("picker.name");
    const std::vector<std::string> matches = fuzzy_matches(picker.typed, picker.scenes);
    const auto pressed = [](ImGuiKey key) { return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key)); };
    if (ImGui::IsItemEdited()) picker.chosen = 0;
    if (pressed(ImGuiKey_DownArrow) && picker.chosen + 1 < matches.size()) ++picker.chosen;
    if (pressed(ImGuiKey_UpArrow) && picker.chosen > 0) --picker.chosen;
    std::string open;
    if (entered) open = picker.chosen < matches.size() ? matches[picker.chosen] : picker.typed;
    for (std::size_t i = 0; i < matches.size(); ++i) {
        if (ImGui::Selectable(matches[i].c_str(), i == picker.chosen)) open = matches[i];
        w.names.name("picker." + matches[i]);
    }
    if (matches.empty()) ImGui::TextDisabled("no scene of that name in scenes/ or beside the present one");
    if (pressed(ImGuiKey_Escape)) w.pick_scene = false;
    ImGui::End();
    if (open.empty()) return;
    w.open(open);
    w.pick_scene = false;
}

}  // namespace percuss::app
