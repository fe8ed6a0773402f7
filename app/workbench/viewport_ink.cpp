#include "workbench/viewport_ink.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "view/outline.hpp"

namespace percuss::app {
namespace {

constexpr render::Colour reference_colour = 0x3aa0ff;  // told from arrows and from viridis

}  // namespace

void paint_beneath(const Workbench& w, const render::LiveView& view,
                   const std::shared_ptr<const Snapshot>& shown, double scale, render::Canvas& canvas) {
    if (w.reference && w.reference->last != shown)
        render::paint_outline(canvas, *w.reference->last, view.plane(), view.fit(), view.model(),
                              reference_colour, 1.5 * scale);
}

void paint_above(const render::LiveView& view, const Snapshot& shown, double scale, render::Canvas& canvas) {
    const Scene& scene = shown.setup->scene;
    const DisplayUnit unit = scene.units.display(Quantity::time, scene.duration);
    const double largest = unit.scale * scene.duration;
    const int decimals =
        largest > 0 ? std::clamp(3 - static_cast<int>(std::floor(std::log10(largest))), 0, 6) : 1;
    const std::string time = fmt::format("t = {:.{}f} {}", unit.scale * shown.time, decimals, unit.label);
    const double pad = 10.5 * scale;
    canvas.text(view.model().right() - pad, view.model().top() - pad, time,
                {15 * scale, render::ink::text, render::Align::right, render::VerticalAlign::top, true});
}

}  // namespace percuss::app
