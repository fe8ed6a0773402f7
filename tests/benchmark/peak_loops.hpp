#pragma once

#include <algorithm>

#include "peak.hpp"
#include "thread_clock.hpp"

/// Included by one file an instruction set, in a namespace of its own.
namespace percuss::benchmarks::PERCUSS_ISA {

/// Enough independent chains to fill two pipes of four or five cycles latency.
inline constexpr int chains = 12;

template <class Real, class Operation>
double flops_per_second(Operation operation) {
    constexpr int lanes = static_cast<int>(sizeof(Real) / sizeof(double));
    constexpr long rounds = 4'000'000;
    double best = 0;
    for (int repeat = 0; repeat < 5; ++repeat) {
        Real sums[chains];
        for (int c = 0; c < chains; ++c) sums[c] = Real{} + (1.0 + 0.01 * c);
        const Real factor = Real{} + 0.999999, term = Real{} + 1e-6;
        const double start = thread_seconds();
        for (long round = 0; round < rounds; ++round) {
            for (int c = 0; c < chains; ++c) {
                sums[c] = operation(sums[c], factor, term);
                asm("" : "+v"(sums[c]));  // keeps each chain in a register and alive
            }
        }
        const double seconds = thread_seconds() - start;
        best = std::max(best, 2.0 * lanes * chains * static_cast<double>(rounds) / seconds);
    }
    return best;
}

template <class Real>
double separate_rate() {
    // -ffp-contract=off keeps the two operations apart.
    return flops_per_second<Real>([](Real a, Real b, Real c) { return a * b + c; });
}

}  // namespace percuss::benchmarks::PERCUSS_ISA
