#pragma once

#include <cstddef>

namespace percuss::testing {

/// Number of calls of operator new in this program so far, all threads together.
[[nodiscard]] std::size_t allocations();
/// Bytes that they asked for, freed or not.
[[nodiscard]] std::size_t allocated_bytes();

}  // namespace percuss::testing
