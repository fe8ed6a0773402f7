#pragma once

#include <array>
#include <span>
#include <string_view>

#include "units.hpp"

/// What writer and reader of run.h5 agree on; FORMAT.md describes it for people. Private to engine/record.
namespace percuss::layout {

inline constexpr int format_version = 2;

/// Stable names of quantities, as run.h5 stores them for history columns.
[[nodiscard]] std::string_view quantity_name(Quantity quantity);
/// @throws RecordError for a name that this version does not know.
[[nodiscard]] Quantity quantity_of(std::string_view name);

inline constexpr std::array<std::string_view, 7> energy_columns{"kinetic", "internal", "hourglass", "viscous",
                                                                "contact", "external", "plastic"};
inline constexpr std::array<std::string_view, 5> body_energy_columns{"kinetic", "elastic", "plastic", "hourglass",
                                                                     "viscous"};

}  // namespace percuss::layout
