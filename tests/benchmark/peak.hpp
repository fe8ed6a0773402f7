#pragma once

#include <cstddef>
#include <cstdint>

namespace percuss::benchmarks {

/// Floating-point operations per second of one core with one instruction set, kept busy with independent
/// chains.
struct Peak {
    double multiply_add = 0;  ///< fused multiply-adds, 2 flops each; without such an instruction as below
    double separate = 0;  ///< as many multiplications as additions, not fused: what the kernels are made of
};

[[nodiscard]] Peak measure_peak_baseline();
[[nodiscard]] Peak measure_peak_avx2();
[[nodiscard]] Peak measure_peak_avx512();

}  // namespace percuss::benchmarks
