#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include <CLI/App.hpp>

#include "scene/scene.hpp"

namespace percuss::app {

/// The scene argument and --set, shared by run, check and info.
struct SceneOptions {
    std::string file;
    std::vector<std::string> overrides;
};
void add_scene_options(CLI::App& command, SceneOptions& options);
/// Loads it and tells its warnings on stderr. @throws SceneError.
[[nodiscard]] Scene load(const SceneOptions& options);

/// "1280x720". @throws UsageError.
[[nodiscard]] std::array<int, 2> parse_size(const std::string& text);

/// "0.3,0.5": exactly N numbers. @throws UsageError naming the option.
template <std::size_t N>
[[nodiscard]] std::array<double, N> parse_numbers(const std::string& option, const std::string& text);

}  // namespace percuss::app
