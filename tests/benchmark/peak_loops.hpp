#pragma once

#include <algorithm>
#include <cstring>

#include "peak.hpp"
#include "thread_clock.hpp"

/// Included by one file an instruction set, in a namespace of its own.
namespace percuss::benchmarks::PERCUSS_ISA {

/// Enough independent chains to fill two pipes of four or five cycles latency. Each is a variable of its own:
/// elements of an array would be kept in memory, and its latency be measured instead.
/// @param first,second what the two halves of the chains do; @param flops of one operation on one lane.
template <class Real, class First, class Second>
double flops_per_second(First first, Second second, double flops) {
    constexpr int lanes = static_cast<int>(sizeof(Real) / sizeof(double)), chains = 12;
    constexpr long rounds = 4'000'000;
    double best = 0;
    for (int repeat = 0; repeat < 5; ++repeat) {
        const Real factor = Real{} + 0.999999, term = Real{} + 1e-6;
        Real a = term, b = term, c = term, d = term, e = term, f = term, g = term, h = term, i = term,
             j = term, k = term, l = term;
        const double start = thread_seconds();
        for (long round = 0; round < rounds; ++round) {
            a = first(a, factor, term), b = first(b, factor, term), c = first(c, factor, term);
            d = first(d, factor, term), e = first(e, factor, term), f = first(f, factor, term);
            g = second(g, factor, term), h = second(h, factor, term), i = second(i, factor, term);
            j = second(j, factor, term), k = second(k, factor, term), l = second(l, factor, term);
            // Keeps the chains alive, apart (no wider vectors of them) and in registers.
            asm volatile("" : "+v"(a), "+v"(b), "+v"(c), "+v"(d), "+v"(e), "+v"(f));
            asm volatile("" : "+v"(g), "+v"(h), "+v"(i), "+v"(j), "+v"(k), "+v"(l));
        }
        const double seconds = thread_seconds() - start;
        best = std::max(best, flops * lanes * chains * static_cast<double>(rounds) / seconds);
    }
    return best;
}

/// Reads and writes `count` doubles once; count is a multiple of the lanes.
template <class Real>
void sweep(double* data, std::size_t count) {
    for (std::size_t k = 0; k < count; k += sizeof(Real) / sizeof(double)) {
        Real value;
        std::memcpy(&value, data + k, sizeof(Real));
        value *= 1.0000001;
        std::memcpy(data + k, &value, sizeof(Real));
    }
}

template <class Real, class Operation>
double fused_rate(Operation multiply_add) {
    return flops_per_second<Real>(multiply_add, multiply_add, 2);
}

template <class Real>
double separate_rate() {
    return flops_per_second<Real>([](Real x, Real factor, Real) { return x * factor; },
                                  [](Real x, Real, Real term) { return x + term; }, 1);
}

}  // namespace percuss::benchmarks::PERCUSS_ISA
