#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

namespace percuss::app {

/// Where the widgets of the last frame lie, by name, so that scripts find them.
class WidgetNames {
  public:
    using Rect = std::array<float, 4>;  ///< left, top, right, bottom [pixels]

    void begin_frame() { places_.clear(); }
    /// Names the widget that ImGui has just placed.
    void name(const std::string& name);
    void place(const std::string& name, const Rect& rect) { places_[name] = rect; }
    /// Null when no widget of that name is there.
    [[nodiscard]] const Rect* find(const std::string& name) const {
        const auto found = places_.find(name);
        return found == places_.end() ? nullptr : &found->second;
    }
    [[nodiscard]] std::vector<std::string> all() const;

  private:
    std::map<std::string, Rect> places_;
};

}  // namespace percuss::app
