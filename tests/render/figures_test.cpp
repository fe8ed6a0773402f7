#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "figures/figure.hpp"
#include "figures/thin.hpp"
#include "figures/ticks.hpp"
#include "render/synthetic.hpp"

namespace percuss::render {
namespace {

using testing::ElementsAre;

TEST(Ticks, AreRoundAndInsideTheRange) {
    const Ticks ticks = make_ticks(-203, 41, 5);
    EXPECT_THAT(ticks.values, ElementsAre(-200, -150, -100, -50, 0));
    EXPECT_THAT(ticks.labels, ElementsAre("\u2212200", "\u2212150", "\u2212100", "\u221250", "0"));
}

TEST(Ticks, HaveAsManyDecimalsAsTheStepNeeds) {
    EXPECT_THAT(make_ticks(0, 0.3, 3).labels, ElementsAre("0.0", "0.1", "0.2", "0.3"));
    EXPECT_THAT(make_ticks(7, 7, 5).labels, ElementsAre("7"));
}

TEST(Ticks, RoundBelowIsOneTwoOrFive) {
    EXPECT_DOUBLE_EQ(round_below(63.8), 50);
    EXPECT_DOUBLE_EQ(round_below(0.0499), 0.02);
    EXPECT_DOUBLE_EQ(round_below(1), 1);
    EXPECT_NEAR(round_below(1e-7), 1e-7, 1e-20);
}

TEST(Thin, KeepsTheFullHeightOfChatterAndSpikes) {
    std::vector<double> x, y;
    for (int i = 0; i < 100000; ++i) {
        x.push_back(i);
        y.push_back(i % 2 == 0 ? 1.0 : -1.0);
    }
    y[54321] = 40;
    const Polyline2 line = thin(x, y, 0, 100000, 200);
    EXPECT_LE(line.x.size(), 800U);
    EXPECT_EQ(*std::max_element(line.y.begin(), line.y.end()), 40);
    EXPECT_EQ(*std::min_element(line.y.begin(), line.y.end()), -1);
    EXPECT_TRUE(std::is_sorted(line.x.begin(), line.x.end()));
    EXPECT_EQ(line.x.back(), 99999);
    // Each column still shows both levels.
    EXPECT_GE(std::count(line.y.begin(), line.y.end(), 1.0), 200);
    EXPECT_GE(std::count(line.y.begin(), line.y.end(), -1.0), 200);
}

TEST(Thin, LeavesShortCurvesAndDropsWhatIsNotFinite) {
    const std::vector<double> x{0, 1, 2}, y{5, NAN, 7};
    const Polyline2 line = thin(x, y, 0, 2, 100);
    EXPECT_THAT(line.x, ElementsAre(0, 2));
    EXPECT_THAT(line.y, ElementsAre(5, 7));
}

bool blue(int r, int g, int b) { return r < 90 && g > 70 && g < 170 && b > 140; }
bool dark_grey(int r, int g, int b) { return r < 110 && std::abs(r - g) < 16 && std::abs(g - b) < 20; }

Figure one_chart() {
    Figure figure;
    figure.width = 640;
    figure.height = 400;
    Chart chart;
    chart.x_title = "time [µs]";
    chart.y_title = "force [kN]";
    chart.x_range = {0, 10};
    chart.y_range = {0, 10};
    chart.curves = {{"", {0, 5, 5, 10}, {2, 2, 8, 8}, false}};
    figure.charts = {chart};
    return figure;
}

TEST(Figure, ACurveIsWhereItsNumbersAre) {
    const auto context = make_offscreen_context();
    const Image image = draw_figure(*context, one_chart());
    ASSERT_EQ(image.width, 640);
    ASSERT_EQ(image.height, 400);
    // Low in the left half, high in the right half, nothing where it is not.
    EXPECT_GT(synthetic::count_pixels(image, {100, 230, 310, 360}, blue), 200);
    EXPECT_GT(synthetic::count_pixels(image, {370, 50, 600, 170}, blue), 200);
    EXPECT_EQ(synthetic::count_pixels(image, {100, 40, 310, 200}, blue), 0);
    EXPECT_EQ(synthetic::count_pixels(image, {370, 200, 600, 350}, blue), 0);
    EXPECT_EQ(draw_figure(*context, one_chart()).pixels, image.pixels);
}

TEST(Figure, ExactCurvesAreDashed) {
    const auto context = make_offscreen_context();
    Figure figure = one_chart();
    figure.charts[0].curves = {{"", {0, 10}, {5, 5}, true}};
    const Image dashed = draw_figure(*context, figure);
    figure.charts[0].curves[0].exact = false;
    const Image full = draw_figure(*context, figure);
    const int dashes = synthetic::count_pixels(dashed, {150, 150, 600, 260}, dark_grey);
    const int line = synthetic::count_pixels(full, {150, 150, 600, 260}, blue);
    EXPECT_GT(dashes, 0.4 * line);
    EXPECT_LT(dashes, 0.85 * line);
}

// Energies that differ by 1e-13: an axis as fine as that would show nothing but its own rounding.
TEST(Figure, WhatVariesByRoundingIsAFlatLine) {
    const auto context = make_offscreen_context();
    Figure figure = one_chart();
    figure.charts[0].y_range = {};
    figure.charts[0].curves = {{"", {0, 5, 10}, {-61.65, -61.65 - 1e-13, -61.65 + 1e-13}, false}};
    const Image image = draw_figure(*context, figure);
    EXPECT_GT(synthetic::count_pixels(image, {100, 40, 600, 360}, blue), 400) << "it is there";
    int rows = 0;
    for (int y = 40; y < 360; ++y) rows += synthetic::count_pixels(image, {100, y, 600, y + 1}, blue) > 0;
    EXPECT_LT(rows, 8) << "and flat";
}

TEST(Figure, TitlesAndUnitsLeaveInk) {
    const auto context = make_offscreen_context();
    Figure figure = one_chart();
    const Image with = draw_figure(*context, figure);
    figure.charts[0].y_title.clear();
    const Image without = draw_figure(*context, figure);
    const auto ink = [](int r, int g, int b) { return r + g + b < 300; };
    EXPECT_GT(synthetic::count_pixels(with, {10, 100, 40, 330}, ink),
              synthetic::count_pixels(without, {10, 100, 28, 330}, ink) + 50);
}

TEST(Figure, ManyChartsFillAGrid) {
    const auto context = make_offscreen_context();
    Figure figure = one_chart();
    figure.width = 1000;
    figure.height = 800;
    figure.columns = 2;
    figure.charts.assign(4, figure.charts[0]);
    const Image image = draw_figure(*context, figure);
    for (const int left : {0, 500})
        for (const int top : {0, 400})
            EXPECT_GT(synthetic::count_pixels(image, {left, top, left + 500, top + 400}, blue), 200);
}

TEST(Figure, RefusesAnEmptyPage) {
    const auto context = make_offscreen_context();
    Figure figure;
    figure.width = 0;
    EXPECT_THROW(static_cast<void>(draw_figure(*context, figure)), RenderError);
}

}  // namespace
}  // namespace percuss::render
