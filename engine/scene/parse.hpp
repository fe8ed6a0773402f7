#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "scene/scene.hpp"

namespace percuss {

/// A scene that cannot be used. `what()` holds one line per fault:
/// "file:line:column: what is wrong; what would be right".
class SceneError : public std::runtime_error {
  public:
    explicit SceneError(std::vector<std::string> messages);
    [[nodiscard]] const std::vector<std::string>& messages() const { return messages_; }

  private:
    std::vector<std::string> messages_;
};

/// Reads and checks a scene file. @param overrides "model.step.courant=0.5": a dotted path (elements of
/// arrays of tables are named by their `name`) and a TOML value. @throws SceneError; also when the file
/// cannot be read.
[[nodiscard]] Scene load_scene(const std::filesystem::path& file,
                               const std::vector<std::string>& overrides = {});

/// As load_scene, from text; `name` stands for the file in messages.
[[nodiscard]] Scene parse_scene(std::string_view text, const std::string& name,
                                const std::vector<std::string>& overrides = {});

/// "file:line:column", or "--set key=value" for what an override gave: the beginning of every message.
[[nodiscard]] std::string describe_place(const Scene& scene, const Place& place);

}  // namespace percuss
