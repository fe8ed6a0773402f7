// Johnson-Cook: rate, heating and softening against the law's own differential equation.
#include <gtest/gtest.h>

#include "engine/materials/one_element.hpp"

namespace percuss::testing {
namespace {

/// Copper-like, mm, ms, kg; stiff, so that elastic strains are 1e-4 of the plastic ones.
constexpr OneElement::Options stiff{.geometry = Geometry::axisymmetric, .young = 1e4, .density = 8.96e-6};
const JohnsonCook copper{0.09, 0.292, 0.31, 0.025, 1e-3, 1.09, 298, 1356, 298, 383, 0.9};

double stress(const JohnsonCook& law, double strain, double rate, double temperature) {
    const double homologous =
        (temperature - law.room_temperature) / (*law.melting_temperature - law.room_temperature);
    return (law.yield + law.hardening * std::pow(strain, law.exponent)) *
           (1 + law.rate_factor * std::log(rate / law.reference_rate)) *
           (1 - std::pow(std::max(homologous, 0.0), law.softening_exponent));
}

/// Temperature after a plastic strain at a constant rate: Runge-Kutta on rho c dT/dep = fraction * stress.
double adiabatic_temperature(const JohnsonCook& law, double density, double strain, double rate) {
    constexpr int steps = 20'000;
    const double h = strain / steps, factor = law.heat_fraction / (density * *law.heat_capacity);
    double t = law.initial_temperature;
    for (int n = 0; n < steps; ++n) {
        const double e = n * h;
        const auto slope = [&](double at, double temperature) {
            return factor * stress(law, at, rate, temperature);
        };
        const double k1 = slope(e, t), k2 = slope(e + h / 2, t + h / 2 * k1),
                     k3 = slope(e + h / 2, t + h / 2 * k2);
        t += h / 6 * (k1 + 2 * k2 + 2 * k3 + slope(e + h, t + h * k3));
    }
    return t;
}

OneElement stretched(const JohnsonCook& law, double strain, double rate, int steps) {
    OneElement element(law, stiff);
    for (int n = 1; n <= steps; ++n)
        element.move_to(isochoric(Geometry::axisymmetric, strain * n / steps), strain / rate / steps);
    return element;
}

TEST(JohnsonCook, HeatsAndSoftensAsItsDifferentialEquation) {
    for (const double rate : {1.0, 100.0}) {
        const OneElement element = stretched(copper, 1, rate, 2000);
        const double temperature = adiabatic_temperature(copper, stiff.density, 1, rate);
        EXPECT_GT(temperature, 370);
        EXPECT_NEAR(element.plastic().temperature, temperature, 2e-3 * (temperature - 298))
            << "rate " << rate;
        const double expected = stress(copper, 1, rate, temperature);
        EXPECT_NEAR(element.von_mises(), expected, 2e-3 * expected) << "rate " << rate;
    }
}

TEST(JohnsonCook, StressIsThatOfStrainRateAndTemperatureAtTheEndOfEachStep) {
    OneElement element(copper, stiff);
    for (int n = 1; n <= 10; ++n) {
        const double before = element.plastic().strain;
        element.move_to(isochoric(Geometry::axisymmetric, 0.1 * n), 0.01);
        const PlasticState now = element.plastic();
        const double expected = stress(copper, now.strain, (now.strain - before) / 0.01, now.temperature);
        EXPECT_NEAR(element.von_mises(), expected, 1e-10 * expected) << "step " << n;
    }
}

TEST(JohnsonCook, HeatIsItsFractionOfThePlasticWork) {
    const OneElement element = stretched(copper, 0.5, 10, 37);
    const double mass = stiff.density * 0.5;  // of the ring from 0 to 1, per radian
    const double heat = mass * *copper.heat_capacity * (element.plastic().temperature - 298);
    EXPECT_NEAR(heat, 0.9 * element.plastic_work(), 1e-12 * heat);
}

TEST(JohnsonCook, RateRaisesTheStressByItsLogarithm) {
    JohnsonCook cold = copper;
    cold.heat_capacity.reset();
    const double slow = stretched(cold, 0.2, 1e-3, 400).von_mises(),
                 fast = stretched(cold, 0.2, 1, 400).von_mises();
    EXPECT_NEAR(fast / slow, 1 + 0.025 * std::log(1000.0), 2e-3);
    const double slower = stretched(cold, 0.2, 1e-6, 400).von_mises();
    EXPECT_NEAR(slower / slow, 1, 1e-3) << "below the reference rate the rate has no effect";
}

TEST(JohnsonCook, RestsAtItsStaticYieldStress) {
    OneElement element = stretched(copper, 0.1, 100, 100);
    EXPECT_GT(element.von_mises(), 1.05 * element.plastic().yield);
    for (int n = 0; n < 200; ++n) element.move_to(isochoric(Geometry::axisymmetric, 0.1), 1);
    EXPECT_NEAR(element.von_mises(), element.plastic().yield, 1e-3 * element.plastic().yield);
}

TEST(JohnsonCook, MeltsToNoStrength) {
    JohnsonCook hot = copper;
    hot.initial_temperature = 1355.999;
    const OneElement element = stretched(hot, 0.3, 100, 100);
    EXPECT_LT(element.von_mises(), 1e-4);
    EXPECT_TRUE(std::isfinite(element.plastic().temperature));
}

}  // namespace
}  // namespace percuss::testing
