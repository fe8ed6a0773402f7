#pragma once

#include <string>

#include "units.hpp"
#include "workbench/workbench.hpp"

namespace percuss::app {

/// Where a panel goes on the screen [pixels from the top left corner].
struct PanelArea {
    float x = 0, y = 0, width = 0, height = 0;
};

/// A panel with a fixed place, from construction to destruction.
class Panel {
  public:
    /// @param padded whether its contents keep away from its rim
    Panel(const char* name, const PanelArea& area, bool padded = true, bool scrolls = true);
    ~Panel();
    Panel(const Panel&) = delete;
    Panel& operator=(const Panel&) = delete;
};

/// ImGui::SameLine where something so wide has room in it; else the next line [pixels].
void same_line_for(float width, float gap = -1);

/// A button for a command of the table, named like it, with its help and key as tooltip. @param label "": its
/// title
bool command_button(Workbench& workbench, const char* command, const char* label = "", float width = 0);
/// The same as a check box.
void command_box(Workbench& workbench, const char* command);
/// Width of a panel at the window's side [pixels]: as the user has it, within what the window gives room for.
[[nodiscard]] float panel_width(const std::optional<double>& chosen, float by_itself);
/// The rim of a panel, which drags its width. @param present width of that panel [pixels].
void show_splitter(Workbench& workbench, const char* name, const PanelArea& area, float present,
                   bool grows_rightwards, std::optional<double>& chosen);
/// As much of a text as is no wider than that, with an ellipsis where something is left out [pixels].
[[nodiscard]] std::string shortened(const std::string& text, float width);
/// Text that is shortened where the panel ends; then the tooltip begins with the whole of it.
void line_of_text(const std::string& text, bool soft = false, const std::string& help = "");
/// ImGui::BeginCombo whose choice is shortened where it has no room; then the tooltip begins with the whole
/// of it.
/// @returns whether the list is open. @param help tooltip of the closed one.
bool begin_choice(Workbench& workbench, const char* label, const std::string& chosen, const std::string& name,
                  const std::string& help = "");

/// What the last widget is about, shown when the mouse rests on it.
void tooltip(const std::string& text);

/// The terms of a text (glossary.hpp) as the tooltip of the last widget, beneath `first` if there is one.
void explain_tooltip(const std::string& text, const std::string& first = "");

/// "12.3 µs": three digits and the unit in which they read best.
[[nodiscard]] std::string quantity_text(const Units& units, Quantity quantity, double value);
[[nodiscard]] const char* status_word(RunStatus status);

// The panels, one file each.
void show_menu(Workbench& workbench);
void show_run_bar(Workbench& workbench, const PanelArea& area);
void show_viewport(Workbench& workbench, const PanelArea& area);
[[nodiscard]] float timeline_height(const Workbench& workbench);  ///< [pixels]
void show_timeline(Workbench& workbench, const PanelArea& area);
void show_view_settings(Workbench& workbench);  ///< within the panel on the left
void show_probes(Workbench& workbench);         ///< likewise
void show_design(Workbench& workbench);         ///< likewise
/// A value of the design panel, with its name, wherever it stands.
void show_design_value(Workbench& workbench, const DesignValue& value);
/// The named contact schemes, of which one is chosen.
void show_scheme_choice(Workbench& workbench);
/// What the scene teaches, and the control that it is about. @pre has_lesson
void show_lesson(Workbench& workbench, const PanelArea& area);
[[nodiscard]] bool has_lesson(const Workbench& workbench);
void show_reference(Workbench& workbench);   ///< likewise
void show_export(Workbench& workbench);      ///< likewise
void show_time_spent(Workbench& workbench);  ///< likewise
void show_plots(Workbench& workbench, const PanelArea& area);
void show_messages(Workbench& workbench, const PanelArea& viewport);
void show_help(Workbench& workbench);
void show_scene_picker(Workbench& workbench);

}  // namespace percuss::app
