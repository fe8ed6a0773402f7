#pragma once

#include <array>
#include <string>
#include <vector>

namespace percuss::render {

/// What a script does to a window in one frame; it takes the place of mouse and keyboard.
struct ScriptedInput {
    std::array<float, 2> mouse{-1, -1};  ///< pixels from the top left corner; -1: outside
    bool pressed = false;                ///< left button
    bool right_pressed = false;
    float wheel = 0;  ///< notches, positive away from the user
    bool ctrl = false, shift = false;
    std::vector<int> keys;  ///< held down, by GLFW's numbers
    std::string text;       ///< typed in this frame, UTF-8
};

/// GLFW's number of a key as people write it: "A", "7", "F1", "Space", "Right", "Enter". 0 when there is
/// none.
[[nodiscard]] int key_number(const std::string& name);

}  // namespace percuss::render
