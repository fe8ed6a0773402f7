#pragma once

#include <cstddef>
#include <vector>

#include "run/history.hpp"
#include "scene/scene.hpp"

namespace percuss {

/// Whether some motion in this direction (0, 1) is prescribed for the body at some time: its history then has
/// the force that drives it.
[[nodiscard]] bool is_prescribed(const Body& body, std::size_t direction);

/// What a row of a scene's histories holds, in the order in which the solver writes it.
/// @throws std::invalid_argument when a probe records a field that the scene does not have.
[[nodiscard]] std::vector<HistoryColumn> history_columns(const Scene& scene);

}  // namespace percuss
