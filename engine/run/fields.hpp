#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "run/snapshot.hpp"

namespace percuss {

/// What cell fields are made of.
struct CellValues {
    StressMean stress{0, 0, 0, 0};
    double plastic_strain = 0;
    double yield_stress = 0;  ///< infinite where the material is elastic [stress]
    double temperature = 0;   ///< [temperature]
};

/// A scalar that can colour a picture.
struct FieldInfo {
    std::string
        name;  ///< "stress.axial", "von_mises", "pressure", "velocity.radial", "displacement.magnitude", ...
    std::string title;  ///< "axial stress"
    Quantity quantity = Quantity::stress;
    bool per_cell = true;                                   ///< one value a cell, else one a node
    double (*of_cell)(const CellValues& cell) = nullptr;    ///< cell fields only
    /// Node fields only: from position, velocity and initial position, 2 numbers each.
    double (*of_node)(const double* position, const double* velocity, const double* start) = nullptr;
};

/// All fields that the scene has; plane scenes say x, y, z, xy for radial, axial, hoop, shear. Plastic strain, yield margin
/// and temperature are there when a body's material has them; they are 0, 1 and the ambient temperature in the others.
[[nodiscard]] std::vector<FieldInfo> available_fields(const Scene& scene);

/// @throws std::invalid_argument with the text of fault_of_field.
[[nodiscard]] FieldInfo find_field(const Scene& scene, std::string_view name);

/// Why the scene has no field of that name and what it has instead; "" when it has it.
/// @param noun what the name was given as: "field", "quantity"
[[nodiscard]] std::string fault_of_field(const Scene& scene, std::string_view noun, std::string_view name);

/// Whether a body of the scene can yield.
[[nodiscard]] bool has_plasticity(const Scene& scene);
/// Initial temperature of the first body that heats, absent when none does: what the others are shown at [temperature].
[[nodiscard]] std::optional<double> ambient_temperature(const Scene& scene);

/// Values of a field: cell_count or node_count numbers in scene units.
[[nodiscard]] std::vector<double> field_values(const Snapshot& snapshot, const FieldInfo& field);

/// Of one cell or node.
[[nodiscard]] double field_value(const Snapshot& snapshot, const FieldInfo& field, std::size_t cell_or_node);

/// Names of the two in-plane directions: {"radial", "axial"} or {"x", "y"}.
[[nodiscard]] std::array<std::string, 2> direction_names(Geometry geometry);

/// Colour maps that pictures can use (ViewOptions::colour_map). "coolwarm" is diverging: an automatic range
/// is then made symmetric about zero.
[[nodiscard]] std::vector<std::string> colour_map_names();

}  // namespace percuss
