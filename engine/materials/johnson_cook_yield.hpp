#pragma once

#include <algorithm>
#include <cmath>

#include "scene/scene.hpp"

namespace percuss {

/// T*^m of the homologous temperature T* = (T - room) / (melting - room) within 0 and 1; 0 without a melting
/// temperature.
[[nodiscard]] inline double thermal_softening(const JohnsonCook& law, double temperature) {
    if (!law.melting_temperature) return 0;
    const double homologous =
        (temperature - law.room_temperature) / (*law.melting_temperature - law.room_temperature);
    return std::pow(std::clamp(homologous, 0.0, 1.0), law.softening_exponent);
}

/// (A + B ep^n) (1 - T*^m): the yield stress at rates up to the reference rate [stress].
[[nodiscard]] inline double static_yield_stress(const JohnsonCook& law, double plastic_strain,
                                                double temperature) {
    return (law.yield + law.hardening * std::pow(plastic_strain, law.exponent)) *
           (1 - thermal_softening(law, temperature));
}

}  // namespace percuss
