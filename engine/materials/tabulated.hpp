#pragma once

#include <algorithm>

#include "materials/j2.hpp"

namespace percuss::PERCUSS_ISA {

/// Piecewise linear hardening, see TabulatedHardening. State: plastic strain, yield stress.
struct Tabulated {
    using Parameters = TabulatedHardening;
    static constexpr int state_size = 2;
    static constexpr bool on_lanes = false;

    [[gnu::noinline]] static Flow<double> flow(const Parameters& law, const Trial<double>& trial,
                                               double* state) {
        double& plastic_strain = state[0];
        double& yield = state[block_lanes];
        const auto& points = law.points;
        auto next = std::upper_bound(points.begin(), points.end(), plastic_strain,
                                     [](double strain, const auto& point) { return strain < point.first; });
        // Each piece in closed form, until the root lies within one.
        double strain = plastic_strain, after = yield, q = trial.equivalent;
        for (; next != points.end(); ++next) {
            const double slope = (next->second - after) / (next->first - strain);
            const double x = (q - after) / (trial.triple_shear + slope);
            if (strain + x < next->first) {
                strain += x;
                after += slope * x;
                break;
            }
            q -= trial.triple_shear * (next->first - strain);
            strain = next->first;
            after = next->second;
        }
        if (next == points.end()) strain += (q - after) / trial.triple_shear;
        const double x = strain - plastic_strain;
        plastic_strain = strain;
        yield = after;
        return {x, after};
    }
};

}  // namespace percuss::PERCUSS_ISA
