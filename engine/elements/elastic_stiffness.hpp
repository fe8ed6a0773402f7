#pragma once

#include <Eigen/Core>

#include "dynamics/node.hpp"
#include "elements/batch.hpp"

namespace percuss {

/// Stiffness of an element's corners, unknowns in the order x0 y0 x1 y1 ...; a triangle's last two are zero.
using CellStiffness = Eigen::Matrix<double, 8, 8>;

/// Elastic stiffness of a cell as its kernel has it, per radian or unit thickness [force/length]: one-point
/// quads with their hourglass stiffness, quads of mean dilatation by B-bar, triangles. What flow takes off is
/// left out, and what stresses add (a thousandth of the whole where they are a thousandth of the moduli).
/// @pre no averaged triangle: its volumes are those of its neighbours, too
/// @param dt the positions are those of the nodes less dt times their velocities
[[nodiscard]] CellStiffness elastic_stiffness(const Cell& cell, ElementKind kind, const Node* nodes, double dt,
                                              const ElasticConstants& material, Geometry geometry);

}  // namespace percuss
