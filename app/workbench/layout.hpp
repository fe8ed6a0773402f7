#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

namespace percuss::app {

/// A file of a layout that cannot be read.
class LayoutError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// How the user has arranged the window, remembered between sessions. What is absent is as the program
/// chooses.
struct WindowLayout {
    std::optional<double> left, right;         ///< widths of the panels [heights of text]
    std::optional<double> scale;               ///< of text, when chosen in the window
    std::optional<bool> dark;                  ///< likewise
    std::optional<std::array<int, 2>> window;  ///< its size [pixels]
    std::map<std::string, bool> plots;         ///< by name: open or folded
    std::set<std::string> curves;              ///< "PLOT/LABEL" whose visibility was changed
    std::map<unsigned, bool> sections;  ///< of the panel on the left, by ImGui's number: open or folded
    std::vector<std::filesystem::path> recent;  ///< scenes that were opened, newest first

    /// Puts a scene at the head of the recent ones. @param file made absolute.
    void remember(const std::filesystem::path& file);
};

/// JSON of a layout.
[[nodiscard]] std::string layout_text(const WindowLayout& layout);
/// @throws LayoutError saying what is wrong; unknown keys and numbers out of bounds are passed over.
[[nodiscard]] WindowLayout parse_layout(const std::string& text);
/// Of a file; a default one when there is no file. @throws LayoutError naming the file.
[[nodiscard]] WindowLayout read_layout(const std::filesystem::path& file);

/// Where the layout and the recent scenes are kept: $XDG_STATE_HOME/percuss/window.json. Nothing without a
/// home.
[[nodiscard]] std::optional<std::filesystem::path> layout_file();
/// Where thumbnails are kept: $XDG_CACHE_HOME/percuss/thumbnails. Nothing without a home.
[[nodiscard]] std::optional<std::filesystem::path> thumbnail_folder();

}  // namespace percuss::app
