#include "study/richardson.hpp"

#include <array>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace percuss::app {
namespace {

using ::testing::HasSubstr;

/// f(h) = limit + c h^p on three levels.
std::array<Level, 3> levels(double limit, double c, double p, std::array<double, 3> h) {
    std::array<Level, 3> result;
    for (std::size_t i = 0; i < 3; ++i) result[i] = {h[i], limit + c * std::pow(h[i], p)};
    return result;
}

TEST(Richardson, FindsOrderAndLimitAlsoOnUnevenLevels) {
    for (const double p : {0.7, 1.0, 1.6, 2.0})
        for (const auto& h :
             {std::array{1.0, 2.0, 4.0}, std::array{0.18, 0.25, 0.36}, std::array{1.0, 1.3, 2.9}})
            for (const double c : {0.3, -2.0}) {
                const Limit limit = extrapolate(levels(7, c, p, h));
                ASSERT_TRUE(limit.order);
                EXPECT_NEAR(*limit.order, p, 1e-9);
                EXPECT_NEAR(limit.value, 7, 1e-9);
                EXPECT_NEAR(limit.uncertainty, 1.25 * std::abs(c) * std::pow(h[0], p), 1e-9);
                EXPECT_TRUE(limit.extrapolated);
            }
}

TEST(Richardson, AnOrderAboveTheFormalOneIsNotTrusted) {
    const Limit limit = extrapolate(levels(1, 1, 4, {1, 2, 4}));
    EXPECT_NEAR(*limit.order, 4, 1e-9);
    // (f2 - f1)/(2^2 - 1) = 15/3 and not 15/15
    EXPECT_NEAR(limit.value, 2 - 5, 1e-9);
    EXPECT_NEAR(limit.uncertainty, 1.25 * 5, 1e-9);
    EXPECT_THAT(limit.how, HasSubstr("2 used"));
}

TEST(Richardson, WhatDoesNotConvergeKeepsItsFinestValueAndItsRange) {
    for (const auto& values :
         {std::array{1.0, 3.0, 2.0}, std::array{1.0, 2.0, 2.5}, std::array{1.0, 1.0, 3.0}}) {
        const std::array<Level, 3> rows{{{1, values[0]}, {2, values[1]}, {4, values[2]}}};
        const Limit limit = extrapolate(rows);
        EXPECT_FALSE(limit.extrapolated);
        EXPECT_EQ(limit.value, 1);
        const double range = std::max({values[0], values[1], values[2]}) - 1;
        EXPECT_NEAR(limit.uncertainty, 1.5 * range, 1e-12);
    }
}

TEST(Richardson, TwoLevelsOrOne) {
    const std::array<Level, 2> two{{{1, 5}, {1.5, 6}}};
    EXPECT_EQ(extrapolate(two).value, 5);
    EXPECT_NEAR(extrapolate(two).uncertainty, 3 * 1 / 0.5, 1e-12) << "as if of first order";
    EXPECT_TRUE(std::isinf(extrapolate(std::span(two).first(1)).uncertainty));
    const std::array<Level, 3> same{{{1, 5}, {2, 5}, {4, 5}}};
    EXPECT_EQ(extrapolate(same).uncertainty, 0);
}

}  // namespace
}  // namespace percuss::app
