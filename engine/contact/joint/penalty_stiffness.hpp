#pragma once

#include <span>
#include <vector>

#include "contact/row.hpp"
#include "mesh/mesh.hpp"
#include "scene/scene.hpp"

namespace percuss {

/// The usual scale of contact springs: a side of a solid element has K A^2 / V, K its bulk modulus, A the
/// area of the side, V the volume of the element (Hallquist, Goudreau & Benson 1985,
/// Comput. Methods Appl. Mech. Engrg. 51, 107-137; LS-DYNA Theory Manual, contact-impact algorithm). Here for
/// the undeformed mesh and per radian or unit thickness, like all forces. A node has the mean of the sides
/// beside it.
class PenaltyStiffness {
  public:
    PenaltyStiffness(const Scene& scene, const Mesh& mesh);

    /// Of a row, for a factor of 1: the softer of its two surfaces, each the mean of its nodes by their parts
    /// in the row; walls are stiffer than any [force/length].
    [[nodiscard]] double of(std::span<const RowTerm> terms, std::int32_t master_terms) const;

  private:
    std::vector<double> of_node_;  ///< per node of the mesh; infinite on walls
};

}  // namespace percuss
