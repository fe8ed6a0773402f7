#include "run/series.hpp"

#include <cmath>
#include <numeric>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace percuss {
namespace {

std::vector<double> steps(int count, double dt) {
    std::vector<double> times;
    for (int k = 0; k < count; ++k) times.push_back(k * dt);
    return times;
}

TEST(MovingAverage, LeavesAConstantAndAStraightLine) {
    const auto times = steps(101, 0.1);
    const std::vector<double> constant(101, 7.0);
    for (const double value : moving_average(times, constant, 1)) EXPECT_NEAR(value, 7, 1e-12);
    const auto line = moving_average(times, times, 1);
    for (std::size_t k = 10; k + 10 < line.size(); ++k) EXPECT_NEAR(line[k], times[k], 1e-12) << k;
}

TEST(MovingAverage, ChatterOnAndOffBecomesItsMean) {
    const auto times = steps(1000, 0.01);
    std::vector<double> chatter(1000);
    for (std::size_t k = 0; k < chatter.size(); ++k) chatter[k] = k % 2 == 0 ? 20 : 0;
    const auto mean = moving_average(times, chatter, 0.4);
    for (std::size_t k = 30; k + 30 < mean.size(); ++k) EXPECT_NEAR(mean[k], 10, 0.3) << k;
}

TEST(MovingAverage, KeepsTheImpulseOfASpikeWhateverTheSteps) {
    const std::vector<double> times{0, 1, 2, 2.1, 2.3, 3, 4, 5, 6}, force{0, 0, 0, 100, 0, 0, 0, 0, 0};
    const double impulse = 100 * 0.5 * (2.3 - 2.0);
    EXPECT_NEAR(moving_average(times, force, 2)[3], impulse / 2, 1e-12);
}

TEST(MovingAverage, WithoutWindowGivesTheValuesBack) {
    const std::vector<double> times{0, 1, 2}, values{3, -1, 4};
    EXPECT_EQ(moving_average(times, values, 0), values);
}

TEST(MeanBetween, WeighsByTimeAndLeavesTheRestOut) {
    const std::vector<double> times{0, 1, 2, 4, 8}, values{99, 1, 1, 5, 5};
    // Rows 2 to 4 stand for 1.5, 3 and 2 units of time.
    EXPECT_NEAR(mean_between(times, values, 2, 8), (1 * 1.5 + 5 * 3 + 5 * 2) / 6.5, 1e-12);
    EXPECT_EQ(mean_between(times, values, 9, 10), 0);
}

TEST(LargestMagnitude, SeesNegativePeaks) {
    EXPECT_EQ(largest_magnitude(std::vector<double>{1, -14, 13}), 1U);
    EXPECT_EQ(largest_magnitude(std::vector<double>{}), 0U);
}

}  // namespace
}  // namespace percuss
