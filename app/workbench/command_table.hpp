#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace percuss::app {

class Workbench;

/// Something the workbench can do. Buttons, keys, menus, the help page and scripts all use this table.
struct WorkbenchCommand {
    std::string name;   ///< "run.toggle"
    std::string title;  ///< "Run or pause", as menus have it
    std::string key;    ///< "Space", "Ctrl+L"; "" when it has none
    std::string help;   ///< one sentence
    void (*act)(Workbench& workbench) = nullptr;
    /// Whether it is on, for what can be on or off; null for others.
    bool (*on)(const Workbench& workbench) = nullptr;
};

[[nodiscard]] const std::vector<WorkbenchCommand>& workbench_commands();
/// Null when there is none of that name.
[[nodiscard]] const WorkbenchCommand* find_command(std::string_view name);

/// A key as written in the table, taken apart.
struct KeyChord {
    bool ctrl = false;
    int key = 0;  ///< GLFW's number; 0: no such key
};
[[nodiscard]] KeyChord parse_key(std::string_view text);

}  // namespace percuss::app
