#pragma once

#include <cstddef>

#include "elements/kernels.hpp"
#include "peak.hpp"

namespace percuss::benchmarks {

/// Peak of one core, measured once a run of the program and set.
[[nodiscard]] const Peak& peak_of(InstructionSet set);
/// Bytes read and written per second by one core over an array of this size, measured once a size.
[[nodiscard]] double bandwidth(std::size_t bytes);
/// Prints both, before the benchmarks.
void print_machine_limits();

}  // namespace percuss::benchmarks
