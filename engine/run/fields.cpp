#include "run/fields.hpp"

#include <algorithm>
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

double pressure(const CellValues& cell) { return -(cell.stress[0] + cell.stress[1] + cell.stress[2]) / 3; }

/// sqrt(3 J2) of a stress whose only shear is in the plane.
double von_mises(const CellValues& cell) {
    const StressMean& s = cell.stress;
    const double a = s[0] - s[1], b = s[1] - s[2], c = s[2] - s[0];
    return std::sqrt(0.5 * (a * a + b * b + c * c) + 3 * s[3] * s[3]);
}

template <std::size_t component>
double stress_component(const CellValues& cell) {
    return cell.stress[component];
}

double plastic_strain(const CellValues& cell) { return cell.plastic_strain; }
double yield_margin(const CellValues& cell) { return 1 - von_mises(cell) / cell.yield_stress; }
double temperature(const CellValues& cell) { return cell.temperature; }

const Plasticity* plasticity_of(const Scene& scene, const Body& body) {
    const auto material = std::find_if(scene.materials.begin(), scene.materials.end(),
                                       [&](const Material& m) { return m.name == body.material; });
    return material == scene.materials.end() ? nullptr : &material->plasticity;
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

bool has_plasticity(const Scene& scene) {
    return std::any_of(scene.bodies.begin(), scene.bodies.end(), [&](const Body& body) {
        const Plasticity* law = plasticity_of(scene, body);
        return law && !std::holds_alternative<std::monostate>(*law);
    });
}

std::optional<double> ambient_temperature(const Scene& scene) {
    for (const Body& body : scene.bodies) {
        const Plasticity* law = plasticity_of(scene, body);
        const auto* johnson_cook = law ? std::get_if<JohnsonCook>(law) : nullptr;
        if (johnson_cook && johnson_cook->heat_capacity) return johnson_cook->initial_temperature;
    }
    return std::nullopt;
}

std::vector<FieldInfo> available_fields(const Scene& scene) {
    const Geometry geometry = scene.geometry;
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
    if (has_plasticity(scene)) {
        fields.push_back({"plastic_strain", "plastic strain", Quantity::dimensionless, true, &plastic_strain, nullptr});
        fields.push_back({"yield_margin", "yield margin", Quantity::dimensionless, true, &yield_margin, nullptr});
    }
    if (ambient_temperature(scene))
        fields.push_back({"temperature", "temperature", Quantity::temperature, true, &temperature, nullptr});
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

std::string fault_of_field(const Scene& scene, std::string_view noun, std::string_view name) {
    std::vector<std::string> names;
    for (FieldInfo& field : available_fields(scene)) {
        if (field.name == name) return "";
        names.push_back(std::move(field.name));
    }
    const auto needs = [&](std::string_view what) {
        return std::string(noun) + " '" + std::string(name) + "' needs a body whose material has " + std::string(what);
    };
    if (name == "plastic_strain" || name == "yield_margin") return needs("[material.plastic] or [material.johnson_cook]");
    if (name == "temperature") return needs("[material.johnson_cook] with heat_capacity");
    return "unknown " + std::string(noun) + " '" + std::string(name) + "'" + suggest_name(name, names);
}

FieldInfo find_field(const Scene& scene, std::string_view name) {
    for (FieldInfo& field : available_fields(scene))
        if (field.name == name) return std::move(field);
    throw std::invalid_argument(fault_of_field(scene, "field", name));
}

double field_value(const Snapshot& snapshot, const FieldInfo& field, std::size_t index) {
    if (!field.per_cell)
        return field.of_node(&snapshot.position[2 * index], &snapshot.velocity[2 * index],
                             snapshot.setup->mesh.nodes[index].data());
    CellValues cell{snapshot.stress[index], 0, 0, 0};
    if (!snapshot.plastic_strain.empty()) cell.plastic_strain = snapshot.plastic_strain[index];
    if (!snapshot.yield_stress.empty()) cell.yield_stress = snapshot.yield_stress[index];
    if (!snapshot.temperature.empty()) cell.temperature = snapshot.temperature[index];
    return field.of_cell(cell);
}

std::vector<double> field_values(const Snapshot& snapshot, const FieldInfo& field) {
    const std::size_t count = field.per_cell ? snapshot.stress.size() : snapshot.setup->mesh.nodes.size();
    std::vector<double> values;
    values.reserve(count);
    for (std::size_t i = 0; i < count; ++i) values.push_back(field_value(snapshot, field, i));
    return values;
}

std::vector<std::string> colour_map_names() {
    return {"viridis", "plasma", "cividis", "magma", "inferno", "grey", "coolwarm"};
}

}  // namespace percuss
