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
