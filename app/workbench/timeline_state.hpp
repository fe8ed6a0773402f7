#pragma once

#include <optional>
#include <string>

namespace percuss::app {

/// The strip under the viewport.
struct TimelineState {
    /// While the slider is held: what its right end means, so that a run that goes on does not move what is
    /// under the mouse [time].
    std::optional<double> held_end;
    std::string speed;  ///< as it is being written, in the unit beside the field
    bool typing_speed = false;
};

}  // namespace percuss::app
