#include "options.hpp"

#include <charconv>
#include <cmath>
#include <cstdio>

#include <fmt/format.h>

#include "exit_status.hpp"
#include "scene/parse.hpp"

namespace percuss::app {

void add_scene_options(CLI::App& command, SceneOptions& options) {
    command.add_option("SCENE", options.file, "scene file, e.g. scenes/rods.toml")->required();
    command
        .add_option("--set", options.overrides,
                    "override a value of the scene, e.g. model.step.courant=0.5; may be repeated")
        ->type_name("KEY=VALUE")
        ->expected(1)
        ->take_all();
}

Scene load(const SceneOptions& options) {
    Scene scene = load_scene(options.file, options.overrides);
    for (const std::string& warning : scene.warnings) fmt::print(stderr, "{}\n", warning);
    return scene;
}

std::array<int, 2> parse_size(const std::string& text) {
    std::array<int, 2> size{};
    const char* end = text.data() + text.size();
    const auto [middle, width_error] = std::from_chars(text.data(), end, size[0]);
    if (width_error == std::errc() && middle != end && *middle == 'x') {
        const auto [stop, height_error] = std::from_chars(middle + 1, end, size[1]);
        const auto usable = [](int pixels) { return pixels >= 16 && pixels <= 16384; };
        if (height_error == std::errc() && stop == end && usable(size[0]) && usable(size[1])) return size;
    }
    throw UsageError(
        fmt::format("--size {}: write WIDTHxHEIGHT in pixels (16 to 16384), e.g. 1280x720", text));
}

template <std::size_t N>
std::array<double, N> parse_numbers(const std::string& option, const std::string& text) {
    std::array<double, N> numbers{};
    const char* at = text.data();
    const char* end = at + text.size();
    for (std::size_t i = 0; i < N; ++i) {
        const auto [stop, error] = std::from_chars(at, end, numbers[i]);
        const bool separated = i + 1 == N ? stop == end : stop != end && *stop == ',';
        if (error != std::errc() || !separated || !std::isfinite(numbers[i])) {
            throw UsageError(
                fmt::format("{} {}: write {} numbers with commas between them", option, text, N));
        }
        at = stop + 1;
    }
    return numbers;
}

template std::array<double, 2> parse_numbers<2>(const std::string&, const std::string&);
template std::array<double, 4> parse_numbers<4>(const std::string&, const std::string&);

}  // namespace percuss::app
