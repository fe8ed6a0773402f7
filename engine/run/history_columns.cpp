#include "run/history_columns.hpp"

#include <algorithm>
#include <array>

#include "run/fields.hpp"

namespace percuss {

bool is_prescribed(const Body& body, std::size_t direction) {
    return std::any_of(body.prescribed.begin(), body.prescribed.end(), [&](const PrescribedVelocity& p) {
        return (p.direction == Direction::first ? 0U : 1U) == direction;
    });
}

std::vector<HistoryColumn> history_columns(const Scene& scene) {
    const auto direction = direction_names(scene.geometry);
    // The axis of an axisymmetric scene is its main direction, so it is named first.
    const std::array<std::size_t, 2> order = scene.geometry == Geometry::axisymmetric
                                                 ? std::array<std::size_t, 2>{1, 0}
                                                 : std::array<std::size_t, 2>{0, 1};
    std::vector<HistoryColumn> columns{{"time", Quantity::time}};
    for (const ContactPair& pair : scene.contacts) {
        for (const std::size_t d : order)
            columns.push_back({"contact." + pair.name + "." + direction[d], Quantity::force});
        columns.push_back({"contact." + pair.name + ".active", Quantity::dimensionless});
        columns.push_back({"contact." + pair.name + ".penetration", Quantity::length});
        columns.push_back({"contact." + pair.name + ".changes", Quantity::dimensionless});
        if (pair.friction == 0) continue;
        for (const std::size_t d : order)
            columns.push_back({"contact." + pair.name + ".friction." + direction[d], Quantity::force});
        columns.push_back({"contact." + pair.name + ".sticking", Quantity::dimensionless});
    }
    for (const Body& body : scene.bodies)
        for (const std::size_t d : order)
            columns.push_back({"body." + body.name + ".velocity." + direction[d], Quantity::velocity});
    for (const Body& body : scene.bodies)
        for (const std::size_t d : order)
            if (is_prescribed(body, d))
                columns.push_back({"body." + body.name + ".drive." + direction[d], Quantity::force});
    for (const char* energy :
         {"kinetic", "internal", "hourglass", "viscous", "plastic", "contact", "external", "balance"})
        columns.push_back({std::string("energy.") + energy, Quantity::energy});
    if (has_friction(scene)) columns.push_back({"energy.friction", Quantity::energy});
    columns.push_back({"step.dt", Quantity::time});
    columns.push_back({"step.critical", Quantity::time});
    for (const Probe& probe : scene.probes)
        for (const std::string& quantity : probe.record)
            columns.push_back({"probe." + probe.name + "." + quantity, find_field(scene, quantity).quantity});
    return columns;
}

}  // namespace percuss
