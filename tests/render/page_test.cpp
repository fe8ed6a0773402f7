#include "figures/page.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "figures/ticks.hpp"
#include "render/synthetic.hpp"
#include "view/view.hpp"

namespace percuss::render {
namespace {

using synthetic::count_pixels;

bool red(int r, int g, int b) { return r > 150 && g < 90 && b < 90; }
bool blue(int r, int g, int b) { return r < 110 && g < 120 && b > 150; }
bool dark(int r, int g, int b) { return r + g + b < 300; }

Page page_of(Panel panel) {
    Page page;
    page.width = 800;
    page.height = 500;
    page.type = 1;
    page.panels.push_back({std::move(panel), {0, 0, 1, 1}});
    return page;
}

/// High at early times and low places, low at late times and high places.
HeatMap quarters() {
    HeatMap map;
    map.x_title = "time";
    map.y_title = "place";
    map.value_title = "stress";
    map.colour_map = "coolwarm";
    for (int i = 0; i < 20; ++i) map.x.push_back(i);
    for (int j = 0; j < 10; ++j) map.y.push_back(j);
    for (int i = 0; i < 20; ++i)
        for (int j = 0; j < 10; ++j) map.values.push_back(i < 10 && j < 5 ? 1 : i >= 10 && j >= 5 ? -1 : 0);
    return map;
}

TEST(Page, AHeatMapHasItsValuesWhereTheyBelong) {
    const auto context = make_offscreen_context();
    const Image image = draw_page(*context, page_of(quarters()));
    // The area reaches from about 95 to 660, and from 20 to 430; the colour bar stands beyond.
    EXPECT_GT(count_pixels(image, {100, 250, 350, 420}, red), 30000);
    EXPECT_GT(count_pixels(image, {400, 40, 640, 200}, blue), 30000);
    EXPECT_EQ(count_pixels(image, {100, 40, 350, 200}, red), 0);
    EXPECT_EQ(count_pixels(image, {100, 40, 350, 200}, blue), 0);
    EXPECT_EQ(count_pixels(image, {400, 250, 640, 420}, red), 0);
    EXPECT_GT(count_pixels(image, {660, 10, 720, 440}, red), 200);  // of the colour bar
}

TEST(Page, AScatterHasItsPointsWhereTheyBelong) {
    const auto context = make_offscreen_context();
    Scatter scatter;
    scatter.x_title = "price";
    scatter.y_title = "error";
    // The second colour of the palette at the lower left, the first at the upper right.
    scatter.series = {{"", {100, -1}, {10, 1}, 0}, {"", {1, 0}, {0.1, 1}, 1}};
    scatter.notes = {{100, 10, "far"}};
    const Image image = draw_page(*context, page_of(scatter));
    const auto first = [](int r, int g, int b) { return r < 60 && std::abs(g - 0x72) < 40 && b > 140; };
    const auto second = [](int r, int g, int b) { return r > 170 && std::abs(g - 0x5e) < 40 && b < 60; };
    EXPECT_GT(count_pixels(image, {500, 0, 800, 200}, first), 30);
    EXPECT_GT(count_pixels(image, {80, 300, 300, 460}, second), 30);
    EXPECT_EQ(count_pixels(image, {80, 200, 450, 460}, first), 0);
    EXPECT_EQ(count_pixels(image, {450, 0, 800, 460}, second), 0);
}

TEST(Page, LogarithmicTicksAreRound) {
    EXPECT_EQ(make_log_ticks(0.5, 30, 10).labels,
              (std::vector<std::string>{"0.5", "1", "2", "5", "10", "20"}));
    EXPECT_EQ(make_log_ticks(0.17, 0.37, 10).labels,
              (std::vector<std::string>{"0.20", "0.25", "0.30", "0.35"}));
    EXPECT_EQ(make_log_ticks(1e-4, 1e4, 5).labels,
              (std::vector<std::string>{"0.0001", "0.01", "1", "100", "1e+04"}));
}

TEST(Page, StackedAreasFillTheirShare) {
    const auto context = make_offscreen_context();
    StackedAreas areas;
    areas.x = {0, 1, 2};
    areas.layers = {{"lower", {3, 3, 3}}, {"upper", {1, 1, 1}}};
    const Image image = draw_page(*context, page_of(areas));
    const auto of = [](unsigned colour) {
        return [colour](int r, int g, int b) {
            return std::abs(r - static_cast<int>(colour >> 16U)) < 12 &&
                   std::abs(g - static_cast<int>(colour >> 8U & 255U)) < 12 &&
                   std::abs(b - static_cast<int>(colour & 255U)) < 12;
        };
    };
    const int lower = count_pixels(image, {100, 60, 780, 440}, of(area_colour(0)));
    const int upper = count_pixels(image, {100, 60, 780, 440}, of(area_colour(1)));
    EXPECT_GT(upper, 40000);
    EXPECT_NEAR(static_cast<double>(lower) / upper, 3, 0.3);
}

TEST(Page, BarsAreAsLongAsTheirValues) {
    const auto context = make_offscreen_context();
    Bars bars;
    bars.series = {"force"};
    bars.groups = {{"a", {10}, {"10"}}, {"b", {5}, {"5"}}};
    const Image image = draw_page(*context, page_of(bars));
    const auto of_bars = [](int r, int g, int b) { return r < 40 && std::abs(g - 0x72) < 20 && b > 140; };
    const int longer = count_pixels(image, {0, 0, 800, 225}, of_bars),
              shorter = count_pixels(image, {0, 225, 800, 500}, of_bars);
    EXPECT_GT(shorter, 2000);
    EXPECT_NEAR(static_cast<double>(longer) / shorter, 2, 0.1);
}

TEST(Page, ATableLeavesInkInEachRow) {
    const auto context = make_offscreen_context();
    Table table;
    table.header = {"quantity", "A", "B"};
    for (int i = 0; i < 6; ++i) table.rows.push_back({"length", "1.5", "2.5"});
    const Image full = draw_page(*context, page_of(table));
    table.rows.resize(3);
    const Image half = draw_page(*context, page_of(table));
    const int of_full = count_pixels(full, {0, 0, 800, 500}, dark),
              of_half = count_pixels(half, {0, 0, 800, 500}, dark);
    EXPECT_GT(of_half, 200);
    EXPECT_GT(of_full, 1.4 * of_half);
}

TEST(Page, AMeshPictureMirrorsItsBodiesAndStaysInItsPlace) {
    const auto context = make_offscreen_context();
    const auto setup = synthetic::rods();
    MeshPicture picture;
    picture.snapshot = std::make_shared<const Snapshot>(synthetic::at_rest(setup));
    picture.options = setup->scene.view;
    picture.options.up = VerticalAxis::second;
    picture.options.window = std::array{0.0, 80.0, 10.0, 120.0};
    Page page = page_of(picture);
    page.panels[0].place = {0, 0, 0.5, 1};
    page.panels.push_back({picture, {0.5, 0, 0.5, 1}});
    const Image image = draw_page(*context, page);
    const auto pale = [](int r, int g, int b) { return r + g + b < 740 && r > 200; };
    // Twice as high as wide, mirrored: around the middle of each half.
    for (const int middle : {200, 600}) {
        EXPECT_GT(count_pixels(image, {middle - 100, 100, middle - 5, 400}, pale), 15000) << middle;
        EXPECT_GT(count_pixels(image, {middle + 5, 100, middle + 100, 400}, pale), 15000) << middle;
    }
    EXPECT_LT(count_pixels(image, {375, 50, 425, 450}, pale), 500);
}

TEST(View, DrawsWallsHatchedOnTheirOwnSide) {
    const auto context = make_offscreen_context();
    const auto setup = synthetic::blocks();
    setup->scene.walls.push_back({"ground", {0, 0}, {0, 1}, {}});
    ViewOptions options;
    options.forces = options.velocities = options.edges = false;
    options.window = std::array{-60.0, -20.0, 60.0, 80.0};
    const Snapshot snapshot = synthetic::at_rest(setup);
    const Image with = View(*context, setup, options).draw(snapshot);
    setup->scene.walls.clear();
    const Image without = View(*context, setup, options).draw(snapshot);
    const auto ink = [](int r, int g, int b) { return r + g + b < 480; };
    // The wall runs through the picture's lower part, beyond the block on both sides; its hatches hang below.
    const auto added = [&](std::array<int, 4> where) {
        return count_pixels(with, where, ink) - count_pixels(without, where, ink);
    };
    EXPECT_GT(added({40, 480, 300, 560}), 400);
    EXPECT_GT(added({40, 529, 300, 560}), 100);
    EXPECT_GT(added({980, 480, 1240, 560}), 400);
    EXPECT_EQ(added({40, 100, 300, 521}), 0);
}

TEST(Page, RefusesAPageWithoutSizeAndAnUnknownField) {
    const auto context = make_offscreen_context();
    Page page = page_of(quarters());
    page.width = 10;
    EXPECT_THROW(static_cast<void>(draw_page(*context, page)), RenderError);
    const auto setup = synthetic::rods();
    MeshPicture picture;
    picture.snapshot = std::make_shared<const Snapshot>(synthetic::at_rest(setup));
    picture.coloured = true;
    picture.options.field = "nonsense";
    EXPECT_THROW(static_cast<void>(draw_page(*context, page_of(picture))), RenderError);
}

}  // namespace
}  // namespace percuss::render
