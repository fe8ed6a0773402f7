#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <imgui.h>

#include "image.hpp"
#include "ui/draw_list_canvas.hpp"
#include "view/bodies.hpp"
#include "workbench/panels/panel.hpp"
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

void move_camera(ViewportState& v, const render::LiveCamera& camera) {
    v.camera = camera;
    v.framing = Framing::chosen;
    v.dirty = true;
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
        if (io.MouseDelta.x != 0 || io.MouseDelta.y != 0) move_camera(v, camera);
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
        move_camera(v, camera);
    }
    v.hovered = render::pick(*v.drawn, v.view->plane(), point);
    if (!ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) return;
    if (v.hovered.body < 0) {
        v.framing = Framing::all;
        v.camera.reset();
        v.dirty = true;
    } else {
        const auto boxes = render::body_boxes(*v.drawn, v.view->plane());
        move_camera(v, v.view->around(boxes[static_cast<std::size_t>(v.hovered.body)]));
    }
}

void show_values(const Workbench& w) {
    const ViewportState& v = w.viewport;
    if (v.hovered.cell < 0 || ImGui::IsMouseDown(ImGuiMouseButton_Left)) return;
    const Snapshot& now = *v.drawn;
    const Scene& scene = now.setup->scene;
    const FieldInfo& field = v.view->field();
    const auto cell = static_cast<std::size_t>(v.hovered.cell),
               node = static_cast<std::size_t>(v.hovered.node);
    const auto directions = direction_names(scene.geometry);
    ImGui::BeginTooltip();
    ImGui::PushFont(w.screen.fonts().bold);
    ImGui::TextUnformatted(now.setup->mesh.bodies[static_cast<std::size_t>(v.hovered.body)].name.c_str());
    ImGui::PopFont();
    const auto line = [](const std::string& name, const std::string& value) {
        ImGui::TextUnformatted(fmt::format("{}  {}", name, value).c_str());
    };
    line(field.title,
         quantity_text(scene.units, field.quantity, v.view->value(field.per_cell ? cell : node)));
    const bool axisymmetric = scene.geometry == Geometry::axisymmetric;
    for (std::size_t d = 0; d < 2; ++d) {
        line(axisymmetric ? (d == 0 ? "r" : "z") : directions[d],
             quantity_text(scene.units, Quantity::length, now.position[2 * node + d]));
    }
    for (std::size_t d = 0; d < 2; ++d)
        line("velocity " + directions[d],
             quantity_text(scene.units, Quantity::velocity, now.velocity[2 * node + d]));
    for (const ContactForce& contact : now.contact_forces)
        if (contact.node == v.hovered.node)
            line("contact " + scene.contacts[static_cast<std::size_t>(contact.pair)].name,
                 quantity_text(scene.units, Quantity::force, std::hypot(contact.force[0], contact.force[1])));
    ImGui::TextDisabled("element %d, node %d", v.hovered.cell, v.hovered.node);
    ImGui::EndTooltip();
}

}  // namespace

void show_viewport(Workbench& w, const PanelArea& area) {
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
    // OpenGL's first row is the lowest.
    ink.AddImage(reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(v.texture)), low, high, {0, 1},
                 {1, 0});
    ink.PushClipRect(low, high, true);
    render::DrawListCanvas canvas(ink, w.screen.fonts(), area.x, area.y + area.height);
    paint_beneath(w, *v.view, v.drawn, w.screen.scale(), canvas);
    v.view->paint(canvas);
    paint_above(w, *v.view, v.drawn, w.screen.scale(), canvas);
    ink.PopClipRect();
    ImGui::SetCursorScreenPos(low);
    ImGui::InvisibleButton("viewport", {area.width, area.height});
    w.names.name("viewport");
    navigate(w, area);
    show_values(w);
}

}  // namespace percuss::app
