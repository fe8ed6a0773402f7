#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace percuss {

/// The text of a scene with values set in it, so that it says without overrides what it said with them. Only
/// those values change, where they stand; comments and layout stay. Keys that the text lacks are put at the
/// end of their table, tables that it lacks at the end of the text. @param name stands for the file in
/// messages.
/// @param overrides "key=value", as in parse_scene. @throws SceneError when one leads nowhere or has no place
/// in the text.
[[nodiscard]] std::string edit_scene_text(std::string_view text, const std::string& name,
                                          const std::vector<std::string>& overrides);

}  // namespace percuss
