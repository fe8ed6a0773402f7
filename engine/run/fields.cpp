#include "run/fields.hpp"

#include <cmath>
#include <stdexcept>

#include "nearest_name.hpp"

namespace percuss {

namespace {

/// Components of StressMean as scenes of this geometry name them.
std::array<std::string, 4> stress_names(Geometry geometry) {
    if (geometry == Geometry::axisymmetric) return {"radial", "axial", "hoop", "shear"};
    return {"x", "y", "z", "xy"};
}

double pressure(const StressMean& s) { return -(s[0] + s[1] + s[2]) / 3; }

/// sqrt(3 J2) of a stress whose only shear is in the plane.
double von_mises(const StressMean& s) {
    const double a = s[0] - s[1], b = s[1] - s[2], c = s[2] - s[0];
    return std::sqrt(0.5 * (a * a + b * b + c * c) + 3 * s[3] * s[3]);
}

template <std::size_t component>
double stress_component(const StressMean& s) {
    return s[component];
}

/// One component (0, 1) of a node's velocity or displacement, or the vector's length (2).
template <bool velocity, int component>
double motion(const double* position, const double* v, const double* start) {
    const double x = velocity ? v[0] : position[0] - start[0], y = velocity ? v[1] : position[1] - start[1];
    if constexpr (component == 2) return std::hypot(x, y);
    return component == 0 ? x : y;
}

}  // namespace

std::array<std::string, 2> direction_names(Geometry geometry) {
    if (geometry == Geometry::axisymmetric) return {"radial", "axial"};
    return {"x", "y"};
}

std::vector<FieldInfo> available_fields(Geometry geometry) {
    const bool axisymmetric = geometry == Geometry::axisymmetric;
    std::vector<FieldInfo> fields{
        {"von_mises", "von Mises stress", Quantity::stress, true, &von_mises, nullptr},
        {"pressure", "pressure", Quantity::stress, true, &pressure, nullptr}};
    constexpr std::array stresses{&stress_component<0>, &stress_component<1>, &stress_component<2>,
                                  &stress_component<3>};
    const auto components = stress_names(geometry);
    for (std::size_t i = 0; i < components.size(); ++i) {
        const std::string title = axisymmetric ? components[i] + " stress" : "stress " + components[i];
        fields.push_back({"stress." + components[i], title, Quantity::stress, true, stresses[i], nullptr});
    }
    const auto directions = direction_names(geometry);
    const auto add_motion = [&](const std::string& kind, const std::string& length, Quantity quantity,
                                const auto& functions) {
        for (std::size_t i = 0; i < 2; ++i) {
            const std::string title = axisymmetric ? directions[i] + " " + kind : kind + " " + directions[i];
            fields.push_back({kind + "." + directions[i], title, quantity, false, nullptr, functions[i]});
        }
        fields.push_back({kind + ".magnitude", length, quantity, false, nullptr, functions[2]});
    };
    add_motion("velocity", "speed", Quantity::velocity,
               std::array{&motion<true, 0>, &motion<true, 1>, &motion<true, 2>});
    add_motion("displacement", "displacement", Quantity::length,
               std::array{&motion<false, 0>, &motion<false, 1>, &motion<false, 2>});
    return fields;
}

FieldInfo find_field(Geometry geometry, std::string_view name) {
    std::vector<std::string> names;
    for (FieldInfo& field : available_fields(geometry)) {
        if (field.name == name) return std::move(field);
        names.push_back(std::move(field.name));
    }
    throw std::invalid_argument("unknown field '" + std::string(name) + "'" + suggest_name(name, names));
}

std::vector<double> field_values(const Snapshot& snapshot, const FieldInfo& field) {
    std::vector<double> values;
    if (field.per_cell) {
        values.reserve(snapshot.stress.size());
        for (const StressMean& stress : snapshot.stress) values.push_back(field.of_cell(stress));
        return values;
    }
    const auto& start = snapshot.setup->mesh.nodes;
    values.reserve(start.size());
    for (std::size_t i = 0; i < start.size(); ++i)
        values.push_back(
            field.of_node(&snapshot.position[2 * i], &snapshot.velocity[2 * i], start[i].data()));
    return values;
}

std::vector<std::string> colour_map_names() {
    return {"viridis", "plasma", "cividis", "magma", "inferno", "grey", "coolwarm"};
}

}  // namespace percuss
