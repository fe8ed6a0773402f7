#pragma once

#include "elements/batch.hpp"

namespace percuss {

/// Volume of element `element` with corners at `nodes` (of the mesh) as its force kernel evaluates it, to the
/// bit: with it as initial volume an undeformed element has no stress at all, and bodies at rest stay so.
/// @returns volume per radian or unit thickness.
[[nodiscard]] double unstressed_volume(const Batch& batch, const std::vector<Vec2>& nodes,
                                       std::int32_t element);

}  // namespace percuss
