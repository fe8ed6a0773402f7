#include "live/min_max_pyramid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

namespace percuss::app {
namespace {

TEST(MinMaxPyramid, TellsWhatALookAtAllNumbersTells) {
    std::mt19937 random(7);
    std::normal_distribution<double> number;
    std::vector<double> values;
    MinMaxPyramid pyramid;
    // In pieces of odd sizes, as frames find them.
    for (const std::size_t piece : {1U, 15U, 16U, 300U, 7U, 4096U, 1000U}) {
        std::vector<double> fresh(piece);
        for (double& value : fresh) value = number(random);
        values.insert(values.end(), fresh.begin(), fresh.end());
        pyramid.append(fresh);
        ASSERT_EQ(pyramid.size(), values.size());
        std::uniform_int_distribution<std::size_t> place(0, values.size());
        for (int i = 0; i < 300; ++i) {
            const auto [begin, end] = std::minmax({place(random), place(random)});
            if (begin == end) continue;
            const auto [low, high] = std::minmax_element(values.begin() + static_cast<std::ptrdiff_t>(begin),
                                                         values.begin() + static_cast<std::ptrdiff_t>(end));
            const MinMax found = pyramid.range(begin, end);
            EXPECT_EQ(found.low, *low) << begin << " " << end;
            EXPECT_EQ(found.high, *high) << begin << " " << end;
        }
    }
}

TEST(MinMaxPyramid, WithinABoundNoSpikeIsLostAndTheNewestStay) {
    std::mt19937 random(3);
    std::normal_distribution<double> number;
    std::vector<double> values;
    MinMaxPyramid pyramid(64);
    for (std::size_t piece = 1; values.size() < 100'000; piece = piece * 7 % 997) {
        std::vector<double> fresh(piece);
        for (double& value : fresh) value = number(random);
        values.insert(values.end(), fresh.begin(), fresh.end());
        pyramid.append(fresh);
    }
    ASSERT_EQ(pyramid.size(), values.size());
    EXPECT_GT(pyramid.thinned(), values.size() - 2 * 64 - 997);
    EXPECT_LE(pyramid.thinned(), values.size() - 64);
    for (std::size_t k = pyramid.thinned(); k < values.size(); ++k) ASSERT_EQ(pyramid[k], values[k]);
    const auto extremes = [&](std::size_t begin, std::size_t end) {
        const auto [low, high] =
            std::minmax_element(values.begin() + static_cast<std::ptrdiff_t>(begin),
                                values.begin() + static_cast<std::ptrdiff_t>(std::min(end, values.size())));
        return MinMax{*low, *high};
    };
    EXPECT_EQ(pyramid.range(0, values.size()).high, extremes(0, values.size()).high);
    std::uniform_int_distribution<std::size_t> place(0, values.size());
    for (int i = 0; i < 2000; ++i) {
        const auto [begin, end] = std::minmax({place(random), place(random)});
        if (begin == end) continue;
        // Two levels up are groups of 256, of which some hundred are kept; then those of 4096.
        const std::size_t group = 4096;
        const MinMax exact = extremes(begin, end),
                     most = extremes(begin / group * group, (end + group - 1) / group * group),
                     found = pyramid.range(begin, end);
        EXPECT_LE(found.low, exact.low);
        EXPECT_GE(found.high, exact.high);
        EXPECT_GE(found.low, most.low);
        EXPECT_LE(found.high, most.high);
    }
}

TEST(MinMaxPyramid, WhatAscendsStillAscendsWhenItIsThinned) {
    MinMaxPyramid pyramid(16);
    for (int k = 0; k < 5000; ++k) pyramid.append(std::vector{0.5 * k});
    ASSERT_GT(pyramid.thinned(), 4000U);
    for (std::size_t k = 0; k < 5000; ++k) EXPECT_NEAR(pyramid[k], 0.5 * static_cast<double>(k), 1e-9);
}

TEST(MinMaxPyramid, PassesOverWhatIsNoNumber) {
    MinMaxPyramid pyramid;
    const double nan = std::numeric_limits<double>::quiet_NaN();
    pyramid.append(std::vector{nan, 2.0, nan, -1.0});
    EXPECT_EQ(pyramid.range(0, 4).low, -1);
    EXPECT_EQ(pyramid.range(0, 4).high, 2);
    EXPECT_GT(pyramid.range(0, 1).low, pyramid.range(0, 1).high);
}

}  // namespace
}  // namespace percuss::app
