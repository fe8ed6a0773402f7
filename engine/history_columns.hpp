#pragma once

#include <cstddef>

#include "scene/scene.hpp"

namespace percuss {

/// Whether some motion in this direction (0, 1) is prescribed for the body at some time: its history then has
/// the force that drives it.
[[nodiscard]] bool is_prescribed(const Body& body, std::size_t direction);

}  // namespace percuss
