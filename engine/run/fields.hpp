#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "run/snapshot.hpp"

namespace percuss {

/// A scalar that can colour a picture.
struct FieldInfo {
    std::string
        name;  ///< "stress.axial", "von_mises", "pressure", "velocity.radial", "displacement.magnitude", ...
    std::string title;  ///< "axial stress"
    Quantity quantity = Quantity::stress;
    bool per_cell = true;                                   ///< one value a cell, else one a node
    double (*of_cell)(const StressMean& stress) = nullptr;  ///< cell fields only
    /// Node fields only: from position, velocity and initial position, 2 numbers each.
    double (*of_node)(const double* position, const double* velocity, const double* start) = nullptr;
};

/// All fields that scenes of this geometry have; plane scenes say x, y, z, xy for radial, axial, hoop, shear.
[[nodiscard]] std::vector<FieldInfo> available_fields(Geometry geometry);

/// @throws std::invalid_argument naming the nearest valid name.
[[nodiscard]] FieldInfo find_field(Geometry geometry, std::string_view name);

/// Values of a field: cell_count or node_count numbers in scene units.
[[nodiscard]] std::vector<double> field_values(const Snapshot& snapshot, const FieldInfo& field);

/// Names of the two in-plane directions: {"radial", "axial"} or {"x", "y"}.
[[nodiscard]] std::array<std::string, 2> direction_names(Geometry geometry);

/// Colour maps that pictures can use (ViewOptions::colour_map). "coolwarm" is diverging: an automatic range
/// is then made symmetric about zero.
[[nodiscard]] std::vector<std::string> colour_map_names();

}  // namespace percuss
