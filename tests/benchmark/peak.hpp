#pragma once

#include <cstddef>
#include <cstdint>

namespace percuss::benchmarks {

/// Reads and writes an array once with this instruction set's registers.
using Sweep = void (*)(double* data, std::size_t count);

/// Floating-point operations per second of one core with one instruction set, kept busy with independent
/// chains.
struct Peak {
    double multiply_add = 0;  ///< fused multiply-adds, 2 flops each; without such an instruction as below
    double separate = 0;  ///< as many multiplications as additions, not fused: what the kernels are made of
    Sweep sweep = nullptr;
};

[[nodiscard]] Peak measure_peak_baseline();
[[nodiscard]] Peak measure_peak_avx2();
[[nodiscard]] Peak measure_peak_avx512();

}  // namespace percuss::benchmarks
