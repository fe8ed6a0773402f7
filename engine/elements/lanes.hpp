#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "dynamics/node.hpp"
#include "elements/batch.hpp"

/// Arithmetic on several elements at once. `Real` is double (the scalar reference) or a GCC vector of
/// doubles; the same source serves both, and with contraction off both give the same bits. PERCUSS_ISA names
/// the namespace of the instruction set a file is compiled for, so that the linker cannot mix code of two
/// instruction sets.
#ifndef PERCUSS_ISA
#error "define PERCUSS_ISA before including kernel headers"
#endif

namespace percuss::PERCUSS_ISA {

using Double4 = double __attribute__((vector_size(32)));
using Double8 = double __attribute__((vector_size(64)));

template <class Real>
inline constexpr int lanes_of = static_cast<int>(sizeof(Real) / sizeof(double));

template <class Real>
[[gnu::always_inline]] inline Real load(const double* from) {
    Real value;
    std::memcpy(&value, from, sizeof(Real));
    return value;
}

template <class Real>
[[gnu::always_inline]] inline void store(double* to, Real value) {
    std::memcpy(to, &value, sizeof(Real));
}

template <class Real>
[[gnu::always_inline]] inline void add_to(double* to, Real value) {
    store(to, load<Real>(to) + value);
}

template <class Real>
[[gnu::always_inline]] inline Real square_root(Real value) {
    if constexpr (lanes_of<Real> == 1) {
        return std::sqrt(value);
    } else {
        Real root = value;
        for (int lane = 0; lane < lanes_of<Real>; ++lane) root[lane] = std::sqrt(value[lane]);
        return root;
    }
}

template <class Real>
[[gnu::always_inline]] inline Real larger_of(Real a, Real b) {
    return a > b ? a : b;
}

/// Whether any element's value is positive.
template <class Real>
[[gnu::always_inline]] inline bool any_positive(Real value) {
    if constexpr (lanes_of<Real> == 1) {
        return value > 0.0;
    } else if constexpr (lanes_of<Real> == 4) {
        const auto is = value > 0.0;
        const auto any = __builtin_shufflevector(is, is, 0, 1) | __builtin_shufflevector(is, is, 2, 3);
        return (any[0] | any[1]) != 0;
    } else {
        return any_positive(larger_of(Double4(__builtin_shufflevector(value, value, 0, 1, 2, 3)),
                                      Double4(__builtin_shufflevector(value, value, 4, 5, 6, 7))));
    }
}

/// Position and velocity of one corner of `lanes_of<Real>` elements.
template <class Real>
struct CornerMotion {
    Real x, y, vx, vy;
};

/// Rows of four doubles, base[4 (index - first)], one a lane.
template <class Real>
[[gnu::always_inline]] inline CornerMotion<Real> gather_rows(const double* base, const std::int32_t* index,
                                                             std::int32_t first) {
    if constexpr (lanes_of<Real> == 1) {
        const double* n = base + 4 * static_cast<std::size_t>(*index - first);
        return {n[0], n[1], n[2], n[3]};
    } else if constexpr (lanes_of<Real> == 4) {
        // One 32-byte load a node, then a 4 x 4 transposition.
        const auto node = [&](int lane) {
            return load<Double4>(base + 4 * static_cast<std::size_t>(index[lane] - first));
        };
        const Double4 n0 = node(0), n1 = node(1), n2 = node(2), n3 = node(3);
        const Double4 x01 = __builtin_shufflevector(n0, n1, 0, 4, 2, 6);
        const Double4 y01 = __builtin_shufflevector(n0, n1, 1, 5, 3, 7);
        const Double4 x23 = __builtin_shufflevector(n2, n3, 0, 4, 2, 6);
        const Double4 y23 = __builtin_shufflevector(n2, n3, 1, 5, 3, 7);
        return {__builtin_shufflevector(x01, x23, 0, 1, 4, 5), __builtin_shufflevector(y01, y23, 0, 1, 4, 5),
                __builtin_shufflevector(x01, x23, 2, 3, 6, 7), __builtin_shufflevector(y01, y23, 2, 3, 6, 7)};
    } else {
        const auto low = gather_rows<Double4>(base, index, first);
        const auto high = gather_rows<Double4>(base, index + 4, first);
        const auto join = [](Double4 a, Double4 b) {
            return __builtin_shufflevector(a, b, 0, 1, 2, 3, 4, 5, 6, 7);
        };
        return {join(low.x, high.x), join(low.y, high.y), join(low.vx, high.vx), join(low.vy, high.vy)};
    }
}

template <class Real>
[[gnu::always_inline]] inline CornerMotion<Real> gather(const Node* nodes, const std::int32_t* index) {
    static_assert(sizeof(Node) == sizeof(Double4));
    return gather_rows<Real>(reinterpret_cast<const double*>(nodes), index, 0);
}

/// NodalVolume of the three corners, mean over them.
template <class Real>
struct MeanNodalVolume {
    Real stress, viscous, damping;
    Real inverse_ratio_cubed;  ///< mean of 1/J^3, the slope of the bulk law over K
};

template <class Real>
[[gnu::always_inline]] inline MeanNodalVolume<Real> mean_nodal_volume(const NodalVolumes& shared,
                                                                      const std::int32_t* index) {
    static_assert(sizeof(NodalVolume) == sizeof(Double4));
    const auto* base = reinterpret_cast<const double*>(shared.nodes.data());
    const auto a = gather_rows<Real>(base, index, shared.node_begin);
    const auto b = gather_rows<Real>(base, index + block_lanes, shared.node_begin);
    const auto c = gather_rows<Real>(base, index + 2 * block_lanes, shared.node_begin);
    constexpr double third = 1.0 / 3.0;
    const auto slope = [](Real ratio) { return 1.0 / (ratio * ratio * ratio); };
    return {third * (a.y + b.y + c.y), third * (a.vx + b.vx + c.vx), third * (a.vy + b.vy + c.vy),
            third * (slope(a.x) + slope(b.x) + slope(c.x))};
}

/// Writes corner forces as (fx, fy) pairs, lane after lane, so that a node gathers each pair with one load.
template <class Real>
[[gnu::always_inline]] inline void store_pairs(double* to, Real fx, Real fy) {
    if constexpr (lanes_of<Real> == 1) {
        to[0] = fx;
        to[1] = fy;
    } else if constexpr (lanes_of<Real> == 4) {
        store(to, Double4(__builtin_shufflevector(fx, fy, 0, 4, 1, 5)));
        store(to + 4, Double4(__builtin_shufflevector(fx, fy, 2, 6, 3, 7)));
    } else {
        store(to, Double8(__builtin_shufflevector(fx, fy, 0, 8, 1, 9, 2, 10, 3, 11)));
        store(to + 8, Double8(__builtin_shufflevector(fx, fy, 4, 12, 5, 13, 6, 14, 7, 15)));
    }
}

}  // namespace percuss::PERCUSS_ISA
