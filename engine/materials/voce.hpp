#pragma once

#include "materials/j2.hpp"

namespace percuss::PERCUSS_ISA {

/// Linear and Voce hardening, see VoceHardening. State: plastic strain, yield stress.
struct Voce {
    using Parameters = VoceHardening;
    static constexpr int state_size = 2;

    [[gnu::noinline]] static Flow flow(const Parameters& law, const Trial& trial, double* state) {
        double& plastic_strain = state[0];
        double& yield = state[block_lanes];
        // q - 3 mu x - yield(x) falls and is convex in x, so Newton from x = 0 comes up to the root without
        // passing it.
        double x = 0, after = yield;
        double left = law.saturation > 0 ? law.saturation * std::exp(-law.rate * plastic_strain) : 0;
        for (int iteration = 0; iteration < 50; ++iteration) {
            const double residual = trial.equivalent - trial.triple_shear * x - after;
            if (residual <= rounding * trial.equivalent) break;
            x += residual / (trial.triple_shear + law.linear + law.rate * left);
            const double strain = plastic_strain + x;
            if (law.saturation > 0) left = law.saturation * std::exp(-law.rate * strain);
            after = law.yield + law.linear * strain + (law.saturation - left);
        }
        plastic_strain += x;
        yield = after;
        return {x, after};
    }

  private:
    static constexpr double rounding = 4e-16;
};

}  // namespace percuss::PERCUSS_ISA
