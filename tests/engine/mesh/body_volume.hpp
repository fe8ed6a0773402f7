#pragma once

#include <numbers>

#include "elements/batch.hpp"

namespace percuss::testing {

/// Volume of a body from the row sums of its cells at density 1: of the full ring, or of the thickness when plane.
inline double body_volume(const Mesh& mesh, const MeshBody& body, Geometry geometry, double thickness) {
    double sum = 0;
    for (std::int32_t cell = body.cell_begin; cell < body.cell_end; ++cell)
        for (const double share : corner_masses(mesh.cells[static_cast<std::size_t>(cell)], mesh.nodes, 1, geometry))
            sum += share;
    return sum * (geometry == Geometry::axisymmetric ? 2 * std::numbers::pi : thickness);
}

}  // namespace percuss::testing
