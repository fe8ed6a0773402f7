#pragma once

#include <string>

namespace percuss::app {

/// What the design panel remembers between frames.
struct DesignPanel {
    std::string typing;       ///< key of the slider that is a field to type in for the moment
    bool just_begun = false;  ///< typing, in this frame
};

}  // namespace percuss::app
