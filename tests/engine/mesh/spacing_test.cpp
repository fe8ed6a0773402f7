#include "mesh/spacing.hpp"

#include <numeric>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace percuss {
namespace {

using ::testing::DoubleNear;
using ::testing::ElementsAre;

std::string fault(const std::vector<Spacing>& stretches, double length) {
    try {
        static_cast<void>(spaced_fractions(stretches, length));
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "";
}

TEST(Spacing, GrowsToTheLargestSizeAndFillsTheLength) {
    const auto sizes = cell_sizes({.first = 1, .ratio = 2, .largest = 4}, 16);
    // 1 + 2 + 4 + 4 + 4 = 15 is nearer to 16 than 19 is: five cells, scaled by 16/15.
    ASSERT_EQ(sizes.size(), 5U);
    EXPECT_DOUBLE_EQ(sizes[0], 16.0 / 15);
    EXPECT_DOUBLE_EQ(sizes[2] / sizes[1], 2);
    EXPECT_DOUBLE_EQ(sizes[4], sizes[2]);
    EXPECT_DOUBLE_EQ(std::accumulate(sizes.begin(), sizes.end(), 0.0), 16);
    EXPECT_EQ(cell_sizes({.first = 1, .ratio = 2, .largest = 4}, 17.5).size(), 6U);
}

TEST(Spacing, GrowsBackwardsFromTheLastCell) {
    const auto sizes = cell_sizes({.first = 1, .ratio = 2, .from_end = true}, 7);
    EXPECT_THAT(sizes, ElementsAre(4, 2, 1));
}

TEST(Spacing, TakesSizesAsGivenUpToScale) {
    EXPECT_THAT(cell_sizes({.sizes = {1, 3, 2}}, 12), ElementsAre(2, 6, 4));
    EXPECT_THAT(cell_sizes({.first = 0.1}, 1), ::testing::SizeIs(10));
    EXPECT_THAT(cell_sizes({.first = 5}, 1), ElementsAre(1));
}

TEST(Spacing, JoinsStretches) {
    const auto fractions = spaced_fractions({{.length = 1, .first = 0.5}, {.sizes = {1, 2}}}, 4);
    EXPECT_THAT(fractions, ElementsAre(0, DoubleNear(0.125, 1e-15), 0.25, DoubleNear(0.5, 1e-15), 1));
    EXPECT_EQ(spaced_fractions({{.length = 1, .first = 0.5}, {.length = 3, .first = 3}}, 4).size(), 4U);
}

TEST(Spacing, RefusesStretchesThatDoNotAddUp) {
    EXPECT_EQ(fault({{.length = 3, .first = 1}}, 4),
              "has stretches that do not add up to the side, of length 4: 3 ends after 0");
    EXPECT_EQ(fault({{.length = 4, .first = 1}, {.first = 1}}, 4),
              "has stretches that do not add up to the side, of length 4: 4 leaves nothing after 0");
    EXPECT_EQ(fault({{.first = 1}, {.first = 1}}, 4),
              "has a stretch without 'length'; only the last may leave it out");
    EXPECT_EQ(fault({{.first = 1}}, 0), "gives sizes to a side without length; write a number of cells");
    EXPECT_EQ(fault({}, 1), "is empty; write a number of cells or their sizes");
    EXPECT_EQ(fault({{.first = 1e-9}}, 1), "makes more than 1000000 cells; enlarge them");
}

}  // namespace
}  // namespace percuss
