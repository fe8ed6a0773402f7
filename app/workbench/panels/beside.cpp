#include <fmt/format.h>
#include <imgui.h>

#include "ui/draw_list_canvas.hpp"
#include "workbench/panels/viewport_parts.hpp"
#include "workbench/viewport_ink.hpp"

namespace percuss::app {
namespace {

void draw_beside(Workbench& w, BesideView& beside, std::array<int, 2> size) {
    const ViewportState& v = w.viewport;
    const auto& moment = beside.run->moment();
    ViewOptions options = v.options;
    // One scale of colours for all.
    const render::ColourRange range = v.view->range();
    if (range[0] < range[1]) options.range = range;
    if (!beside.view)
        beside.view = std::make_unique<render::LiveView>(w.screen.context(), moment->setup, options);
    else if (beside.setup != moment->setup)
        beside.view->show(moment->setup, options);
    else if (beside.drawn == moment && beside.draws == v.draws)
        return;
    beside.setup = moment->setup;
    beside.view->set_options(options, render::RangeMode::frame);
    beside.view->take_scales(*v.view);
    beside.view->set_camera(v.view->camera());
    beside.texture = beside.view->draw(moment, size, w.screen.scale());
    beside.drawn = moment;
    beside.draws = v.draws;
}

void show_one(Workbench& w, BesideView& beside, const PanelArea& area, const std::string& name) {
    const Panel panel(name.c_str(), area, false, false);
    w.names.place(name, {area.x, area.y, area.x + area.width, area.y + area.height});
    const std::vector<std::string>& faults = beside.run->run().messages();
    if (!beside.run->moment()) {
        ImGui::TextWrapped("%s: %s", beside.run->label().c_str(),
                           faults.empty() ? "building the scene ..." : faults.front().c_str());
        return;
    }
    draw_beside(w, beside, {static_cast<int>(area.width), static_cast<int>(area.height)});
    const ImVec2 low{area.x, area.y}, high{area.x + area.width, area.y + area.height};
    ImDrawList& ink = *ImGui::GetWindowDrawList();
    ink.PushClipRect(low, high, true);
    draw_picture(*beside.view, beside.texture, area, ink);
    render::DrawListCanvas canvas(ink, w.screen.fonts(), area.x, area.y + area.height);
    beside.view->paint(canvas);
    write_time(*beside.view, *beside.drawn, w.screen.scale(), canvas);
    const bool diverged = beside.run->run().status() == RunStatus::diverged;
    write_label(*beside.view, beside.run->label() + (diverged ? ": diverged" : ""), w.screen.scale(), canvas);
    ink.PopClipRect();
}

}  // namespace

void show_beside(Workbench& w, const std::vector<PanelArea>& areas) {
    for (std::size_t k = 0; k < w.beside.size(); ++k) {
        try {
            show_one(w, w.beside[k], areas[k], fmt::format("viewport.beside.{}", k + 1));
        } catch (const render::RenderError& error) {
            w.tell(fmt::format("{}: {}", w.beside[k].run->label(), error.what()));
        }
    }
}

}  // namespace percuss::app
