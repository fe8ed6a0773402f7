#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <imgui.h>

#include "image.hpp"
#include "ui/draw_list_canvas.hpp"
#include "view/bodies.hpp"
#include "workbench/panels/panel.hpp"
#include "workbench/panels/viewport_parts.hpp"
#include "workbench/viewport_actions.hpp"
#include "workbench/viewport_ink.hpp"

namespace percuss::app {
namespace {

/// A run was opened, built anew or changed: the picture goes on with its setup.
void follow_setup(Workbench& w) {
    ViewportState& v = w.viewport;
    const auto& setup = w.run.snapshot()->setup;
    if (setup == v.setup) return;
    if (v.file != w.run.file()) {  // another scene has its own view
        v.file = w.run.file();
        v.options = setup->scene.view;
        v.framing = Framing::scene;
        v.range_mode = render::RangeMode::frame;
        v.fixed_range = v.options.range.has_value();
        v.fixed = v.options.range.value_or(std::array{0.0, 1.0});
        v.camera.reset();
        w.until = setup->scene.duration;
    } else if (!fault_of_field(setup->scene, "field", v.options.field).empty()) {
        v.options.field = setup->scene.view.field;
    }
    if (v.view)
        v.view->show(setup, v.options);
    else
        v.view = std::make_unique<render::LiveView>(w.screen.context(), setup, v.options);
    v.setup = setup;
    v.dirty = true;
}

std::optional<render::LiveCamera> wanted_camera(const ViewportState& v) {
    if (v.framing == Framing::chosen) return v.camera;
    if (v.framing == Framing::all || !v.setup->scene.view.window) return std::nullopt;
    const auto& window = *v.setup->scene.view.window;
    const auto a = v.view->plane()(window[0], window[1]), b = v.view->plane()(window[2], window[3]);
    return v.view->around({a[0], a[1], b[0], b[1]});
}

void draw_model(Workbench& w, std::array<int, 2> size) {
    ViewportState& v = w.viewport;
    const auto& snapshot = w.run.snapshot();
    if (!v.dirty && v.drawn == snapshot && v.drawn_size == size) return;
    const bool first = v.drawn_size != size || v.drawn == nullptr;
    v.view->set_options(v.options, v.range_mode);
    move_after_node(w, *snapshot);
    v.view->set_camera(wanted_camera(v));
    v.texture = v.view->draw(snapshot, size, w.screen.scale());
    if (first && v.framing == Framing::scene) {  // the window was fitted into the picture before
        v.view->set_camera(wanted_camera(v));
        v.texture = v.view->draw(snapshot, size, w.screen.scale());
    }
    v.drawn = snapshot;
    ++v.draws;
    v.drawn_size = size;
    v.dirty = false;
}

/// The mouse in the picture's coordinates.
std::array<double, 2> model_point(const ViewportState& v, const PanelArea& area) {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const render::Fit& fit = v.view->fit();
    return {(mouse.x - area.x - fit.offset[0]) / fit.pixels_per_unit,
            (area.y + area.height - mouse.y - fit.offset[1]) / fit.pixels_per_unit};
}

void navigate(Workbench& w, const PanelArea& area) {
    ViewportState& v = w.viewport;
    const ImGuiIO& io = ImGui::GetIO();
    const bool hovered = ImGui::IsItemHovered();
    v.hovered = {};
    if (ImGui::IsItemActive() && ImGui::IsMouseDragging(ImGuiMouseButton_Left, 2)) {
        render::LiveCamera camera = v.view->camera();
        camera.centre[0] -= io.MouseDelta.x / camera.pixels_per_unit;
        camera.centre[1] += io.MouseDelta.y / camera.pixels_per_unit;
        if (io.MouseDelta.x != 0 || io.MouseDelta.y != 0) move_camera(w, camera);
        return;
    }
    if (!hovered) return;
    const auto point = model_point(v, area);
    if (io.MouseWheel != 0) {
        render::LiveCamera camera = v.view->camera();
        const double factor = std::pow(1.2, io.MouseWheel);
        // The point under the cursor stays where it is.
        for (std::size_t k = 0; k < 2; ++k)
            camera.centre[k] = point[k] + (camera.centre[k] - point[k]) / factor;
        camera.pixels_per_unit *= factor;
        move_camera(w, camera);
    }
    v.hovered = render::pick(*v.drawn, v.view->plane(), point);
    if (!ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) return;
    w.marks.clicked.reset();
    if (v.hovered.body < 0) {
        w.do_command("view.fit");
    } else {
        zoom_to(w, static_cast<std::size_t>(v.hovered.body));
    }
}

/// The button that opens the menu: the right one, or the left one when no second click follows.
void open_menu(Workbench& w) {
    ViewportMarks& m = w.marks;
    const ImGuiIO& io = ImGui::GetIO();
    const bool still = io.MouseDragMaxDistanceSqr[0] < 9 && !ImGui::IsMouseDown(ImGuiMouseButton_Left);
    bool open = false;
    if (ImGui::IsItemHovered()) {
        if (ImGui::IsMouseReleased(ImGuiMouseButton_Right)) {
            m.menu = w.viewport.hovered;
            open = true;
            m.clicked.reset();
        } else if (ImGui::IsItemDeactivated() && still && w.viewport.hovered.body >= 0 &&
                   !io.MouseDoubleClicked[0] && io.MouseClickedLastCount[0] < 2) {
            m.menu = w.viewport.hovered;
            m.clicked = ImGui::GetTime();
            m.click_at = {io.MousePos.x, io.MousePos.y};
        }
    }
    if (m.clicked &&
        (ImGui::IsMouseDown(ImGuiMouseButton_Left) || ImGui::IsMouseDown(ImGuiMouseButton_Right)))
        m.clicked.reset();
    if (m.clicked && ImGui::GetTime() > *m.clicked + io.MouseDoubleClickTime) {
        m.clicked.reset();
        open = true;
        ImGui::SetNextWindowPos({m.click_at[0], m.click_at[1]});
    }
    if (open) ImGui::OpenPopup("viewport.menu");
}

/// The surfaces of pairs are looked up when they are first to be seen.
void choose_sides(Workbench& w) {
    ViewportMarks& m = w.marks;
    const bool wanted = m.pairs != ViewportMarks::Pairs::none || m.hovered_pair;
    if (wanted && m.sides.empty() && m.setup) m.sides = render::contact_sides(*m.setup);
}

/// The run whose design is moved, in its part of the viewport.
void show_own_run(Workbench& w, const PanelArea& area) {
    const Panel panel("viewport", area, false, false);
    if (!w.run.snapshot()) {
        const char* words =
            w.run.building() ? "building the scene ..." : "Ctrl+O opens a scene; a file can be dropped here";
        ImGui::SetCursorPos({0.5F * (area.width - ImGui::CalcTextSize(words).x), 0.45F * area.height});
        ImGui::TextDisabled("%s", words);
        return;
    }
    ViewportState& v = w.viewport;
    try {
        follow_setup(w);
        draw_model(w, {static_cast<int>(area.width), static_cast<int>(area.height)});
    } catch (const render::RenderError& error) {
        ImGui::TextUnformatted(error.what());
        return;
    }
    const ImVec2 low{area.x, area.y}, high{area.x + area.width, area.y + area.height};
    ImDrawList& ink = *ImGui::GetWindowDrawList();
    ink.PushClipRect(low, high, true);
    draw_picture(*v.view, v.texture, area, ink);
    render::DrawListCanvas canvas(ink, w.screen.fonts(), area.x, area.y + area.height);
    paint_beneath(w, *v.view, v.drawn, w.screen.scale(), canvas);
    v.view->paint(canvas, places_of_words(w, *v.view, v.drawn, w.screen.scale(), canvas));
    choose_sides(w);
    paint_above(w, *v.view, v.drawn, w.screen.scale(), canvas);
    ink.PopClipRect();
    ImGui::SetCursorScreenPos(low);
    ImGui::InvisibleButton("viewport", {area.width, area.height});
    w.names.name("viewport");
    navigate(w, area);
    open_menu(w);
    show_place_menu(w);
    show_values_under_mouse(w);
}

}  // namespace

void show_viewport(Workbench& w, const PanelArea& area) {
    const std::vector<PanelArea> parts = viewport_parts(area, 1 + w.beside.size());
    show_own_run(w, parts.front());
    if (w.viewport.view && w.viewport.drawn) show_beside(w, {parts.begin() + 1, parts.end()});
}

}  // namespace percuss::app
