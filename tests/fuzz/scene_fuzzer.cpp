#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "mesh/build.hpp"
#include "scene/parse.hpp"

namespace {

/// Lines "#set KEY=VALUE" of the input become overrides, so that one input reaches both parsers.
std::vector<std::string> overrides_in(std::string_view text) {
    constexpr std::string_view mark = "#set ";
    std::vector<std::string> overrides;
    for (auto at = text.find(mark); at != std::string_view::npos; at = text.find(mark, at + 1)) {
        const auto line = text.substr(at, text.find('\n', at) - at);
        overrides.emplace_back(line.substr(mark.size()));
    }
    return overrides;
}

double cells(const percuss::Scene& scene) {
    double sum = 0;
    for (const auto& body : scene.bodies)
        for (const auto& block : body.blocks) sum += 4.0 * block.divisions[0] * block.divisions[1];
    return sum;
}

}  // namespace

/// Any text must give a scene and mesh, or a SceneError: no crash, no other exception, no undefined
/// behaviour.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string text(data, data + size);
    try {
        const auto scene = percuss::parse_scene(text, "scene.toml", overrides_in(text));
        // The parser's own bound on cells is too generous for thousands of runs a second.
        if (cells(scene) > 20'000) return 0;
        percuss::check_mesh(scene, percuss::build_mesh(scene));
    } catch (const percuss::SceneError&) {
    }
    return 0;
}
