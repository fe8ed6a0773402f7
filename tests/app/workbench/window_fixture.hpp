#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "app/program_test.hpp"
#include "image.hpp"

namespace percuss::test {

/// Whether a pixel has about this colour.
inline bool near(const std::uint8_t* p, unsigned colour, int tolerance = 12) {
    for (int c = 0; c < 3; ++c)
        if (std::abs(p[c] - static_cast<int>(colour >> (16 - 8 * c) & 255U)) > tolerance) return false;
    return true;
}

/// The program's window, driven by scripts on OSMesa: what is seen, and what the engine did.
class WindowTest : public ProgramTest {
  protected:
    using Place = std::array<int, 4>;  // left, top, right, bottom

    WindowTest() {
        std::string text = small_scene;
        text.insert(text.find("[units]"),
                    "[parameters]\nspeed = { value = 1, range = [0, 5], unit = \"m/s\", description = \"of "
                    "the striker\" }\n");
        text.replace(text.find("velocity = [0.0, -1.0]"), 22, "velocity = [0.0, \"= -speed\"]");
        write("scene.toml", text);
        text.replace(text.find("\"steel\""), 7, "steel");
        write("bad.toml", text);
    }

    /// Plays a script on the scene; the places of its `widgets` events are kept.
    void play(const std::string& script, std::vector<std::string> more = {}) {
        write("script.txt", script);
        std::vector<std::string> command{"view", "scene.toml", "--headless", "--script", "script.txt"};
        command.insert(command.end(), more.begin(), more.end());
        const Outcome outcome = run(command);
        EXPECT_EQ(outcome.status, 0) << outcome.err;
        std::istringstream lines(outcome.out);
        for (std::string line; std::getline(lines, line);) {
            std::istringstream words(line);
            std::string word, name;
            Place place{};
            words >> word >> place[0] >> place[1] >> place[2] >> place[3] >> std::ws;
            if (word == "widget" && std::getline(words, name)) widgets_[name] = place;
        }
    }
    /// Pixels of a screenshot within a widget that have about this colour.
    [[nodiscard]] int count(const std::string& file, const std::string& widget, unsigned colour) const {
        const render::Image image = render::read_png(path(file));
        const auto place = widgets_.find(widget);
        if (place == widgets_.end()) ADD_FAILURE() << "no widget " << widget;
        const auto [left, top, right, bottom] = place == widgets_.end() ? Place{} : place->second;
        int found = 0;
        for (int y = std::max(top, 0); y < std::min(bottom, image.height); ++y)
            for (int x = std::max(left, 0); x < std::min(right, image.width); ++x)
                found +=
                    near(image.pixels.data() + 3 * (static_cast<std::size_t>(y) * image.width + x), colour);
        return found;
    }

    std::map<std::string, Place> widgets_;
};

}  // namespace percuss::test
