#include <algorithm>
#include <cctype>
#include <cstdint>
#include <set>

#include <imgui.h>
#include <imgui_stdlib.h>

#include "live/fuzzy.hpp"
#include "workbench/panels/panel.hpp"

namespace percuss::app {
namespace {

namespace fs = std::filesystem;

/// A path as one would type it here.
std::string short_name(const fs::path& file) {
    std::error_code ignored;
    const fs::path here = fs::current_path(ignored), whole = fs::absolute(file, ignored).lexically_normal();
    const fs::path near = whole.lexically_proximate(here);
    return !near.empty() && *near.begin() != ".." ? near.string() : whole.string();
}

/// Those that were opened last, then those below scenes/ and beside the present one, and the recorded runs in
/// out/.
std::vector<std::string> find_scenes(const std::vector<fs::path>& recent, const fs::path& present) {
    std::set<std::string> found;
    std::error_code unreadable;
    const auto add = [&](const fs::directory_entry& entry) {
        if (entry.path().extension() == ".toml") found.insert(short_name(entry.path()));
    };
    for (fs::recursive_directory_iterator entry("scenes", unreadable), end; !unreadable && entry != end;
         entry.increment(unreadable))
        add(*entry);
    const fs::path beside = present.has_parent_path() ? present.parent_path() : fs::path(".");
    for (fs::directory_iterator entry(beside, unreadable), end; !unreadable && entry != end;
         entry.increment(unreadable))
        add(*entry);
    // Recorded runs: OUT/NAME/run.h5, as `percuss run` leaves them.
    for (fs::directory_iterator entry("out", unreadable), end; !unreadable && entry != end;
         entry.increment(unreadable)) {
        std::error_code none;
        if (fs::is_regular_file(entry->path() / "run.h5", none))
            found.insert(short_name(entry->path() / "run.h5"));
    }
    std::vector<std::string> scenes;
    for (const fs::path& file : recent) {
        if (!fs::is_regular_file(file, unreadable)) continue;
        scenes.push_back(short_name(file));
        found.erase(scenes.back());
    }
    scenes.insert(scenes.end(), found.begin(), found.end());
    return scenes;
}

/// A scene of the list: picture, title, file. @returns whether it was clicked.
bool show_card(Workbench& w, const std::string& scene, bool chosen) {
    const float em = ImGui::GetFontSize(), gap = 0.35F * em, height = 5.2F * em;
    const float width = height * Thumbnails::width / Thumbnails::height;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const bool clicked = ImGui::Selectable(("##" + scene).c_str(), chosen, 0, {0, height + 2 * gap});
    w.names.name("picker." + scene);
    if (!ImGui::IsItemVisible()) return clicked;
    ImDrawList& ink = *ImGui::GetWindowDrawList();
    const ImVec2 low{at.x + gap, at.y + gap}, high{low.x + width, low.y + height};
    const SceneCard* card = w.thumbnails.find(scene);
    if (card != nullptr && card->picture)
        ink.AddImage(reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(card->picture->name())), low,
                     high);
    ink.AddRect(low, high, ImGui::GetColorU32(ImGuiCol_Border));
    const bool usable = card == nullptr || card->fault.empty();
    const float x = high.x + em;
    ImFont* bold = w.screen.fonts().bold;
    const std::string title = card == nullptr ? "" : usable ? card->title : "cannot be used";
    // On the coloured ground of the chosen one pale letters could not be read.
    const ImU32 text = ImGui::GetColorU32(ImGuiCol_Text);
    const bool grounded = chosen || ImGui::IsItemHovered();
    const ImU32 soft = grounded ? text : ImGui::GetColorU32(ImGuiCol_TextDisabled);
    ink.PushClipRect({x, at.y}, {ImGui::GetItemRectMax().x, at.y + height + 2 * gap}, true);
    ink.AddText(bold, bold->FontSize, {x, at.y + gap + 0.4F * em}, usable ? text : soft, title.c_str());
    ink.AddText({x, at.y + gap + 2 * em}, soft, scene.c_str());
    ink.PopClipRect();
    if (!usable) tooltip(card->fault);
    return clicked;
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
    if (fresh) {
        picker = {find_scenes(w.layout.recent, w.run.file()), std::exchange(w.pick_typed, ""), 0, true};
        w.thumbnails.want(picker.scenes);
    }
    w.thumbnails.advance(w.screen.context());
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    const float em = ImGui::GetFontSize();
    ImGui::SetNextWindowPos({0.5F * display.x, 0.1F * display.y}, ImGuiCond_Always, {0.5F, 0});
    ImGui::SetNextWindowSize({std::min(42 * em, 0.94F * display.x), std::min(40 * em, 0.8F * display.y)});
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
    const std::size_t before = picker.chosen;
    if (pressed(ImGuiKey_DownArrow) && picker.chosen + 1 < matches.size()) ++picker.chosen;
    if (pressed(ImGuiKey_UpArrow) && picker.chosen > 0) --picker.chosen;
    std::string open;
    if (entered) open = picker.chosen < matches.size() ? matches[picker.chosen] : picker.typed;
    ImGui::BeginChild("scenes");  // the field stays while the list scrolls
    for (std::size_t i = 0; i < matches.size(); ++i) {
        if (show_card(w, matches[i], i == picker.chosen)) open = matches[i];
        if (i == picker.chosen && i != before) ImGui::SetScrollHereY();
    }
    if (matches.empty())
        ImGui::TextDisabled("no scene of that name in scenes/, beside the present one or recorded in out/");
    ImGui::EndChild();
    if (pressed(ImGuiKey_Escape)) w.pick_scene = false;
    ImGui::End();
    if (open.empty()) return;
    w.open(open);
    w.pick_scene = false;
}

}  // namespace percuss::app
