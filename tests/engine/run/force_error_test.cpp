#include "run/force_error.hpp"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

namespace percuss {
namespace {

const TimePoints square{{0, 0}, {0, 2}, {4, 2}, {4, 0}};

struct Rows {
    std::vector<double> time, force;
};

/// The impulses of an exact pulse: each row holds the pulse's own mean over [t_n - dt/2, t_n + dt/2].
Rows impulses_of(const TimePoints& pulse, double dt, double end, double shift = 0) {
    const RunningIntegral integral(pulse);
    Rows rows;
    for (int n = 0; n * dt <= end; ++n) {
        const double t = n * dt;
        rows.time.push_back(t);
        rows.force.push_back((integral(t + dt / 2 - shift) - integral(t - dt / 2 - shift)) / dt);
    }
    return rows;
}

TEST(RunningIntegral, FollowsRampsAndJumpsExactly) {
    const RunningIntegral integral({{1, 0}, {3, 4}, {3, -1}, {5, -1}});
    EXPECT_DOUBLE_EQ(integral(0), 0);
    EXPECT_DOUBLE_EQ(integral(2), 1);  // half of the ramp's way: a quarter of its area
    EXPECT_DOUBLE_EQ(integral(3), 4);
    EXPECT_DOUBLE_EQ(integral(4), 3);
    EXPECT_DOUBLE_EQ(integral(9), 2);
    EXPECT_THROW(RunningIntegral({{1, 0}, {0, 0}}), std::invalid_argument);
}

TEST(ForceBetweenMidpoints, GivesEachRowItsImpulse) {
    const std::vector<double> time{0, 1, 3}, force{5, 7, 11};
    const TimePoints expected{{-0.5, 5}, {0.5, 5}, {0.5, 7}, {2, 7}, {2, 11}, {4, 11}};
    EXPECT_EQ(force_between_midpoints(time, force), expected);
}

TEST(ForceError, OfAnExactPulseFallsToNothingWithTheStep) {
    // Within a window of one step a jump is smeared over one more step: the error falls like sqrt(dt).
    const Rows coarse = impulses_of(square, 0.04, 6), fine = impulses_of(square, 0.0025, 6);
    const double coarse_error = force_error(coarse.time, coarse.force, square, 0, 6);
    const double fine_error = force_error(fine.time, fine.force, square, 0, 6);
    EXPECT_NEAR(coarse_error / fine_error, 4, 0.05);
    EXPECT_LT(fine_error, 0.007);
    EXPECT_LT(force_error(fine.time, fine.force, square, 0.5, 6), 1e-4);
}

TEST(ForceError, OfAShiftedPulseIsTheAnalyticValue) {
    // Averages are ramps of width w at both edges. A shift s <= w leaves a trapezoid of height F s / w and
    // area F^2 (s/w)^2 (w - s/3) at each edge; || exact ||^2 = F^2 (T - w/3) less the half ramp before t = 0.
    constexpr double dt = 0.001, shift = 0.1, window = 0.4, length = 4;
    const Rows rows = impulses_of(square, dt, 6, shift);
    const double early =
        [&] {  // of the leading edge only t >= 0 counts: the difference between -w/2 and 0 is lost
            const double s = shift / window;
            const double before = window / 2 - shift;  // full height between s - w/2 and 0
            return s * s * (before + shift / 3);
        }();
    const double edge = (shift / window) * (shift / window) * (window - shift / 3);
    const double norm = length - window / 3 - window / 24;
    const double expected = std::sqrt((2 * edge - early) / norm);
    EXPECT_NEAR(force_error(rows.time, rows.force, square, window, 6), expected, 1e-3 * expected);
}

TEST(ForceError, OfADoubledForceIsOne) {
    Rows rows = impulses_of(square, 0.001, 6);
    for (double& force : rows.force) force *= 2;
    EXPECT_NEAR(force_error(rows.time, rows.force, square, 0.5, 6), 1, 1e-4);
}

TEST(ForceError, ForgivesOscillationWithinTheWindowOnly) {
    Rows rows = impulses_of(square, 0.01, 6);
    for (std::size_t n = 1; n < rows.force.size(); ++n) rows.force[n] *= n % 2 == 0 ? 1.5 : 0.5;
    EXPECT_GT(force_error(rows.time, rows.force, square, 0, 6), 0.2);
    EXPECT_LT(force_error(rows.time, rows.force, square, 0.4, 6), 0.02);
}

TEST(ForceError, HoldsForVariableSteps) {
    const RunningIntegral integral(square);
    Rows rows;
    for (double t = 0, dt = 0.001; t<6; t += dt, dt = dt> 0.004 ? 0.001 : dt * 1.1) rows.time.push_back(t);
    for (std::size_t n = 0; n < rows.time.size(); ++n) {
        const double t = rows.time[n];
        const double before = n > 0 ? 0.5 * (rows.time[n - 1] + t) : t;
        const double after = n + 1 < rows.time.size() ? 0.5 * (t + rows.time[n + 1]) : t + 0.001;
        rows.force.push_back((integral(after) - integral(before)) / (after - before));
    }
    EXPECT_LT(force_error(rows.time, rows.force, square, 0.5, 6), 2e-3);
}

TEST(ForceError, RefusesWhatHasNoAnswer) {
    const std::vector<double> one{0}, two{0, 1}, zero{0, 0};
    EXPECT_THROW(static_cast<void>(force_error(one, one, square, 0, 1)), std::invalid_argument);
    EXPECT_THROW(static_cast<void>(force_error(two, zero, {{0, 0}, {1, 0}}, 0, 1)), std::invalid_argument);
    EXPECT_THROW(static_cast<void>(force_error(zero, zero, square, 0, 1)), std::invalid_argument);
}

TEST(FirstSample, IsTheFirstForceOverThePlateau) {
    const std::vector<double> force{0, 0, 8, 1}, none{0, 0};
    EXPECT_DOUBLE_EQ(first_sample(force, square), 4);
    EXPECT_DOUBLE_EQ(first_sample(none, square), 0);
    EXPECT_DOUBLE_EQ(first_sample(force, {{0, -2}, {4, -2}}), -4);
}

}  // namespace
}  // namespace percuss
