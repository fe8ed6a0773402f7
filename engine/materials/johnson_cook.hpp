#pragma once

#include "materials/j2.hpp"
#include "materials/johnson_cook_yield.hpp"

namespace percuss::PERCUSS_ISA {

/// Rate and temperature at the end of the step (implicit), see JohnsonCook. State: plastic strain, static
/// yield stress, temperature. Above the reference rate the stress exceeds the static yield stress
/// (overstress), and relaxes to it at rest.
struct JohnsonCookFlow {
    using Parameters = JohnsonCook;
    static constexpr int state_size = 3;
    static constexpr bool on_lanes = false;

    [[gnu::noinline]] static Flow<double> flow(const Parameters& law, const Trial<double>& trial,
                                               double* state) {
        double& plastic_strain = state[0];
        double& yield = state[block_lanes];
        double& temperature = state[2 * block_lanes];
        // Temperature per plastic work and present volume; mass per present volume is density / volume_ratio.
        const double heating =
            law.heat_capacity ? law.heat_fraction * trial.volume_ratio / (trial.density * *law.heat_capacity)
                              : 0;
        const auto temperature_after = [&](double x) {
            return temperature + heating * trial.work(x, trial.equivalent - trial.triple_shear * x);
        };

        // Newton within a bracket: ep^n and T*^m have infinite slopes at 0 where exponents are below 1.
        double low = 0, high = trial.equivalent / trial.triple_shear;
        double x = (trial.equivalent - yield) / trial.triple_shear;
        for (int iteration = 0; iteration < 100; ++iteration) {
            const double strain = plastic_strain + x, t = temperature_after(x);
            const double hardened = law.yield + law.hardening * std::pow(strain, law.exponent);
            const double over_rate = x / (trial.dt * law.reference_rate);
            const double rate = over_rate > 1 ? 1 + law.rate_factor * std::log(over_rate) : 1;
            const double softening = thermal_softening(law, t), remaining = 1 - softening;
            const double residual = trial.equivalent - trial.triple_shear * x - hardened * rate * remaining;
            if (std::abs(residual) <= 4e-16 * trial.equivalent) break;
            (residual > 0 ? low : high) = x;
            if (high - low <= 2e-16 * high) break;

            double slope = trial.triple_shear + law.hardening * law.exponent *
                                                    std::pow(strain, law.exponent - 1) * rate * remaining;
            if (over_rate > 1) slope += hardened * law.rate_factor / x * remaining;
            if (softening > 0 && softening < 1)
                slope -= hardened * rate * law.softening_exponent * softening / (t - law.room_temperature) *
                         heating * 0.5 * (trial.old_along + trial.equivalent - 2 * trial.triple_shear * x);
            const double newton = x + residual / slope;
            x = newton > low && newton < high ? newton : 0.5 * (low + high);
        }
        temperature = temperature_after(x);
        plastic_strain += x;
        yield = static_yield_stress(law, plastic_strain, temperature);
        return {x, trial.equivalent - trial.triple_shear * x};
    }
};

}  // namespace percuss::PERCUSS_ISA
