#pragma once

#include <cmath>

#include "materials/j2.hpp"

namespace percuss::PERCUSS_ISA {

/// Linear and Voce hardening, see VoceHardening. State: plastic strain, yield stress.
struct Voce {
    using Parameters = VoceHardening;
    static constexpr int state_size = 2;
    static constexpr bool on_lanes = true;

    /// @param excess positive where a point flows.
    template <class Real>
    [[gnu::always_inline]] static Flow<Real> flow(const Parameters& law, const Trial<Real>& trial,
                                                  double* state, Real excess) {
        const Real strain = load<Real>(state), yield = load<Real>(state + block_lanes);
        // What the exponential part still lacks follows from the yield stress: only the step's share of the
        // exponential is evaluated.
        const bool saturates = law.saturation > 0;
        const Real limit = (law.yield + law.saturation) + law.linear * strain;
        const Real lacking = saturates ? Real(limit - yield) : Real(0.0 * strain);
        // q - 3 mu x - yield(x) falls and is convex in x, so Newton from x = 0 comes up to the root without
        // passing it.
        Real x = 0.0 * strain, after = yield, left = lacking;
        for (int iteration = 0; iteration < 50; ++iteration) {
            const Real residual = trial.equivalent - trial.triple_shear * x - after;
            const Real open =
                excess > 0.0 ? Real(residual - rounding * trial.equivalent) : Real(0.0 * strain);
            if (!any_positive(open)) break;
            const Real next = x + residual / (trial.triple_shear + law.linear + law.rate * left);
            x = open > 0.0 ? next : x;
            if (saturates) left = lacking * decay(Real(law.rate * x));
            after = open > 0.0 ? Real(limit + law.linear * x - left) : after;
        }
        store(state, Real(strain + x));
        store(state + block_lanes, after);
        return {x, after};
    }

  private:
    static constexpr double rounding = 4e-16;

    /// exp(-y) of y >= 0: a step's y is small, and up to 1/32 the series to y^7 is exact to rounding
    /// (1/32^8 / 8! = 2e-17).
    template <class Real>
    [[gnu::always_inline]] static Real decay(Real y) {
        constexpr double most = 0.03125;
        const Real square = y * y;
        const Real high = (1.0 / 24 - (1.0 / 120) * y) + square * (1.0 / 720 - (1.0 / 5040) * y);
        const Real sum = (1.0 - y) + square * ((0.5 - (1.0 / 6) * y) + square * high);
        if (!any_positive(Real(y - most))) return sum;
        double ys[lanes_of<Real>], values[lanes_of<Real>];
        store(ys, y);
        store(values, sum);
        for (int lane = 0; lane < lanes_of<Real>; ++lane)
            if (ys[lane] > most) values[lane] = std::exp(-ys[lane]);
        return load<Real>(values);
    }
};

}  // namespace percuss::PERCUSS_ISA
