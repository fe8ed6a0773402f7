#include <cmath>

#include <fmt/format.h>
#include <imgui.h>

#include "workbench/panels/panel.hpp"
#include "workbench/panels/viewport_parts.hpp"

namespace percuss::app {
namespace {

void row(const std::string& name, const std::string& value) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(name.c_str());
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(value.c_str());
}

/// Both components in the unit that suits the larger one, then the length.
std::string vector_text(const Units& units, Quantity quantity, const std::array<double, 2>& vector) {
    const double length = std::hypot(vector[0], vector[1]);
    const DisplayUnit unit = units.display(quantity, length);
    return fmt::format("{:.4g}, {:.4g} {}  ({:.4g})", unit.scale * vector[0], unit.scale * vector[1],
                       unit.label, unit.scale * length);
}

void show_cell(const Snapshot& now, std::size_t cell, const std::string& shown) {
    const Scene& scene = now.setup->scene;
    for (const char* name : {"von_mises", "pressure", "plastic_strain", "yield_margin", "temperature"}) {
        if (shown == name || !fault_of_field(scene, "field", name).empty()) continue;
        const FieldInfo field = find_field(scene, name);
        row(field.title, quantity_text(scene.units, field.quantity, field_value(now, field, cell)));
    }
}

void show_node(const Snapshot& now, std::size_t node) {
    const Scene& scene = now.setup->scene;
    const Vec2& start = now.setup->mesh.nodes[node];
    const std::array position{now.position[2 * node], now.position[2 * node + 1]};
    const std::array velocity{now.velocity[2 * node], now.velocity[2 * node + 1]};
    const DisplayUnit unit = scene.units.display(Quantity::length, std::hypot(position[0], position[1]));
    row(scene.geometry == Geometry::axisymmetric ? "at r, z" : "at x, y",
        fmt::format("{:.6g}, {:.6g} {}", unit.scale * position[0], unit.scale * position[1], unit.label));
    row("displacement",
        vector_text(scene.units, Quantity::length, {position[0] - start.x(), position[1] - start.y()}));
    row("velocity", vector_text(scene.units, Quantity::velocity, velocity));
    for (const ContactForce& contact : now.contact_forces)
        if (contact.node == static_cast<std::int32_t>(node))
            row(fmt::format("contact {}, {}", scene.contacts[static_cast<std::size_t>(contact.pair)].name,
                            contact.master ? "master" : "slave"),
                vector_text(scene.units, Quantity::force, contact.force));
}

}  // namespace

void show_values_under_mouse(const Workbench& w) {
    const ViewportState& v = w.viewport;
    if (v.hovered.cell < 0 || ImGui::IsMouseDown(ImGuiMouseButton_Left)) return;
    const Snapshot& now = *v.drawn;
    const FieldInfo& field = v.view->field();
    const auto cell = static_cast<std::size_t>(v.hovered.cell),
               node = static_cast<std::size_t>(v.hovered.node);
    ImGui::BeginTooltip();
    ImGui::PushFont(w.screen.fonts().bold);
    ImGui::TextUnformatted(fmt::format("{}   {} {}",
                                       now.setup->mesh.bodies[static_cast<std::size_t>(v.hovered.body)].name,
                                       field.title,
                                       quantity_text(now.setup->scene.units, field.quantity,
                                                     v.view->value(field.per_cell ? cell : node)))
                               .c_str());
    ImGui::PopFont();
    if (ImGui::BeginTable("values", 2, ImGuiTableFlags_SizingFixedFit)) {
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        ImGui::TextDisabled("element %d", v.hovered.cell);
        show_cell(now, cell, field.name);
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        ImGui::TextDisabled("node %d", v.hovered.node);
        show_node(now, node);
        ImGui::EndTable();
    }
    ImGui::EndTooltip();
}

}  // namespace percuss::app
