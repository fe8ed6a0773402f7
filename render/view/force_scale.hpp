#pragma once

#include <optional>

#include "scene/scene.hpp"

namespace percuss::render {

/// How long a force is drawn.
struct ForceScaling {
    ForceScale kind = ForceScale::automatic;
    double reference = 0;         ///< force of the reference arrow [force]; 0: nothing to draw
    double reference_length = 0;  ///< its length [pixels]

    double cut_off = 0.01;  ///< fraction of the reference below which no arrow is drawn

    /// Decades that logarithmic arrows show, down from the reference.
    [[nodiscard]] double decades() const;

    /// Pixels for a force of this magnitude; 0 when it is negligible.
    [[nodiscard]] double length(double force) const;
};

/// @param largest force on one node in the run so far [force]. @param longest pixels given to the largest
/// force. The reference is a round number, or the scene's; a fixed one keeps its length whatever the forces
/// do.
[[nodiscard]] ForceScaling make_force_scaling(const ViewOptions& options, double largest, double longest);

}  // namespace percuss::render
