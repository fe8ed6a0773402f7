#include "workbench/panels/viewport_parts.hpp"

#include <cmath>
#include <cstdint>

#include <imgui.h>

namespace percuss::app {

void draw_picture(const render::LiveView& view, unsigned texture, const PanelArea& area, ImDrawList& ink) {
    const auto name = reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(texture));
    const float bottom = area.y + area.height;
    // OpenGL's first row is the lowest, ImGui's the highest.
    for (const auto& [place, low, high] : view.parts())
        ink.AddImage(name, {area.x + static_cast<float>(place.x), bottom - static_cast<float>(place.top())},
                     {area.x + static_cast<float>(place.right()), bottom - static_cast<float>(place.y)},
                     {static_cast<float>(low[0]), static_cast<float>(high[1])},
                     {static_cast<float>(high[0]), static_cast<float>(low[1])});
}

std::vector<PanelArea> viewport_parts(const PanelArea& area, std::size_t count) {
    const auto parts = static_cast<float>(count);
    const bool side_by_side = area.width > 1.2F * area.height;
    constexpr float rim = 2;
    std::vector<PanelArea> result;
    for (std::size_t k = 0; k < count; ++k) {
        const auto at = static_cast<float>(k);
        // On whole pixels, as the textures are.
        const auto cut = [&](float length, float part) { return std::round(part * length / parts); };
        const float gap = k + 1 == count ? 0 : rim;
        const float length = side_by_side ? area.width : area.height;
        const float begin = cut(length, at), end = cut(length, at + 1) - gap;
        if (side_by_side)
            result.push_back({area.x + begin, area.y, end - begin, area.height});
        else
            result.push_back({area.x, area.y + begin, area.width, end - begin});
    }
    return result;
}

}  // namespace percuss::app
