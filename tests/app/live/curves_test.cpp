#include "live/curves.hpp"

#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "live/fuzzy.hpp"
#include "live/reference.hpp"
#include "run/history_columns.hpp"
#include "scene/parse.hpp"

namespace percuss::app {
namespace {

using testing::ElementsAre;

std::shared_ptr<History> chatter(int rows) {
    auto history = std::make_shared<History>(
        std::vector<HistoryColumn>{{"time", Quantity::time}, {"force", Quantity::force}});
    for (int i = 0; i < rows; ++i)
        history->append(std::array{0.001 * i, i == 7777 ? 50.0 : i % 2 == 0 ? -1.0 : 1.0});
    return history;
}

TEST(Curves, ASpikeOfOneStepIsDrawnAtFullHeight) {
    Curves curves;
    curves.follow(chatter(100000));
    std::vector<CurvePoint> points;
    decimate(curves, curves.column(1), 0, 100, 300, points);
    EXPECT_LE(points.size(), 2U * 300 + 2);
    const auto highest = std::max_element(points.begin(), points.end(),
                                          [](const auto& a, const auto& b) { return a.value < b.value; });
    EXPECT_EQ(highest->value, 50);
    EXPECT_NEAR(highest->time, 7.777, 100.0 / 300);
    // Chatter fills its band in every part.
    const auto low = std::count_if(points.begin(), points.end(), [](const auto& p) { return p.value == -1; });
    EXPECT_GE(low, 299);
}

TEST(Curves, FewPointsAreDrawnAsTheyAre) {
    Curves curves;
    curves.follow(chatter(100000));
    std::vector<CurvePoint> points;
    decimate(curves, curves.column(1), 7.7755, 7.7785, 300, points);
    ASSERT_EQ(points.size(), 5U);  // three inside, one beyond either end
    EXPECT_NEAR(points[2].time, 7.777, 1e-12);
    EXPECT_EQ(points[2].value, 50);
}

/// How far a point lies above or below a line of ascending x; the nearer where it jumps.
float distance_to(const std::vector<std::array<float, 2>>& line, const std::array<float, 2>& point) {
    float least = 1e9F;
    for (std::size_t i = 1; i < line.size(); ++i) {
        const auto& [x0, y0] = line[i - 1];
        const auto& [x1, y1] = line[i];
        if (point[0] < x0 || point[0] > x1) continue;
        const float y = x1 > x0 ? y0 + (y1 - y0) * (point[0] - x0) / (x1 - x0)
                                : std::clamp(point[1], std::min(y0, y1), std::max(y0, y1));
        least = std::min(least, std::abs(point[1] - y));
    }
    return least;
}

TEST(Curves, AStraightenedLinePassesNearEveryPointAndKeepsJumps) {
    std::vector<std::array<float, 2>> line;
    for (int i = 0; i < 300; ++i) {
        const auto x = static_cast<float>(i);
        const float y = 40 * std::sin(0.02F * x) + 0.1F * static_cast<float>(i % 3);
        line.push_back({x, y});
        line.push_back({x, i == 77 ? y + 30 : y + 0.05F});
        if (i > 200 && i < 220) line.push_back({x, i % 2 == 0 ? -20.0F : 20.0F});  // chatter
    }
    const auto whole = line;
    straighten(line, 0.3F);
    EXPECT_LT(line.size(), whole.size() / 4);
    EXPECT_EQ(line.front(), whole.front());
    EXPECT_EQ(line.back(), whole.back());
    for (const auto& point : whole) EXPECT_LE(distance_to(line, point), 0.61F) << point[0];
    const auto highest = [](const auto& points) {
        return (*std::max_element(points.begin(), points.end(),
                                  [](const auto& a, const auto& b) { return a[1] < b[1]; }))[1];
    };
    EXPECT_EQ(highest(line), highest(whole));
}

TEST(Curves, NewRowsAreAddedAndAnotherHistoryBeginsAnew) {
    auto history = chatter(10);
    Curves curves;
    curves.follow(history);
    EXPECT_EQ(curves.column(1).size(), 10U);
    history->append(std::array{0.01, 99.0});
    curves.follow(history);
    EXPECT_EQ(curves.rows(), 11U);
    EXPECT_EQ(curves.column(1)[10], 99);
    curves.follow(chatter(3));
    EXPECT_EQ(curves.column(1).size(), 3U);
}

TEST(Curves, AScenesPlotsHaveTheMainDirectionOpen) {
    const Scene scene = load_scene(std::string(PERCUSS_SOURCE_DIR) + "/scenes/rods.toml");
    const auto columns = history_columns(scene);
    const auto plots = plots_of(scene, columns);
    std::vector<std::string> open;
    for (const PlotInfo& plot : plots) {
        if (!plot.folded) open.push_back(plot.name);
        for (const CurveInfo& curve : plot.curves) EXPECT_EQ(columns[curve.column].quantity, plot.quantity);
    }
    EXPECT_THAT(std::vector(open.begin(), open.begin() + 5),
                ElementsAre("forces.axial", "events", "velocities.axial", "energies", "step"));
    EXPECT_EQ(columns[plots[0].curves[0].column].name, "contact.impact.axial");
    EXPECT_EQ(plots[0].curves[0].label, "impact");
}

TEST(Reference, ComparesPeaksUpToTheTimeThatBothHave) {
    const auto run = [](int rows, double peak) {
        auto history = std::make_shared<History>(
            std::vector<HistoryColumn>{{"time", Quantity::time}, {"contact.a.y", Quantity::force}});
        for (int i = 0; i < rows; ++i)
            history->append(std::array{0.1 * i, i == 3 ? -peak : i == 8 ? 100.0 : 1.0});
        return history;
    };
    const auto present = run(6, 4), kept = run(10, 5);
    Curves curves;
    curves.follow(present);
    Reference reference{kept, [](double) { return nullptr; }, {}, nullptr};
    reference.follow(0);
    const std::vector<PlotInfo> plots{{"forces.y", "", Quantity::force, {{1, "a"}}}};
    const auto peaks = peak_differences(plots, present->columns(), curves, reference);
    ASSERT_EQ(peaks.size(), 1U);
    EXPECT_EQ(peaks[0].present, -4);
    EXPECT_EQ(peaks[0].reference, -5) << "the 100 comes later than the present run has got";
}

TEST(Fuzzy, LettersInOrderClosestFirst) {
    const std::vector<std::string> scenes{"scenes/nail.toml", "scenes/rods.toml",
                                          "scenes/hard/narrow-lid.toml"};
    EXPECT_THAT(fuzzy_matches("nail", scenes),
                ElementsAre("scenes/nail.toml", "scenes/hard/narrow-lid.toml"));
    EXPECT_THAT(fuzzy_matches("RD", scenes), ElementsAre("scenes/hard/narrow-lid.toml", "scenes/rods.toml"));
    EXPECT_THAT(fuzzy_matches("xyz", scenes), ElementsAre());
    EXPECT_EQ(fuzzy_matches("", scenes), scenes);
    EXPECT_THAT(fuzzy_matches("d/", {"d/3-long.toml", "d/1-longest.toml", "a/d/2.toml", "e.toml"}),
                ElementsAre("a/d/2.toml", "d/1-longest.toml", "d/3-long.toml"));
}

TEST(Curves, APastStandsBeforeTheRows) {
    auto history = chatter(3);
    Curves curves;
    EXPECT_EQ(curves.rows(), 0U);
    curves.follow(history, {-0.2, 7, -0.1, 8});
    ASSERT_EQ(curves.rows(), 5U);
    EXPECT_EQ(curves.times()[1], -0.1);
    EXPECT_EQ(curves.column(1)[0], 7);
    EXPECT_EQ(curves.column(1)[2], -1);
    history->append(std::array{0.003, 42.0});
    curves.follow(history);
    ASSERT_EQ(curves.rows(), 6U);
    EXPECT_EQ(curves.column(1)[5], 42);
    curves.follow(chatter(2));
    EXPECT_EQ(curves.rows(), 2U) << "another history has no such past";
}

/// A counter that goes up by `by[k]` in step k, one step a unit of time.
Curves counter(const std::vector<double>& by) {
    auto history = std::make_shared<History>(
        std::vector<HistoryColumn>{{"time", Quantity::time}, {"count", Quantity::dimensionless}});
    double sum = 0;
    for (std::size_t k = 0; k < by.size(); ++k)
        history->append(std::array{static_cast<double>(k), sum += by[k]});
    Curves curves;
    curves.follow(history);
    return curves;
}

TEST(Rates, CountTheEventsOfAWindow) {
    Curves curves = counter({2, 0, 0, 3, 1, 0, 0, 0, 0, 5});
    const MinMaxPyramid& counts = curves.column(1);
    EXPECT_EQ(rate_at(curves, counts, 3.5, 2), 2) << "[2.5, 4.5): steps 3 and 4";
    EXPECT_EQ(rate_at(curves, counts, 3.5, 1), 3) << "[3, 4): step 3";
    EXPECT_EQ(rate_at(curves, counts, 6.5, 2), 0);
    EXPECT_EQ(rate_at(curves, counts, 0, 2), 2) << "cut at the start: [0, 1)";
    EXPECT_EQ(rate_at(curves, counts, 9, 2), 5) << "cut at the end, which belongs to it";
    EXPECT_EQ(rate_at(curves, counts, 20, 2), 0);
}

TEST(Rates, NoEventIsLostHoweverFewPixelsThereAre) {
    std::vector<double> by(3000, 0);
    for (const std::size_t k : {1U, 777U, 778U, 1500U, 2999U}) by[k] = 4;
    Curves curves = counter(by);
    for (const int parts : {7, 50, 400}) {
        std::vector<CurvePoint> points;
        rates(curves, curves.column(1), 0, 2999, parts, 1, points);
        ASSERT_EQ(points.size(), static_cast<std::size_t>(parts));
        double sum = 0;
        for (const CurvePoint& point : points) sum += point.value * 2999.0 / parts;
        EXPECT_NEAR(sum, 20, 1e-9);
    }
    std::vector<CurvePoint> points;
    rates(curves, curves.column(1), 770, 786, 16, 2, points);
    for (const CurvePoint& point : points)
        EXPECT_EQ(point.value > 0, std::abs(point.time - 777.5) <= 1.5) << point.time;
}

TEST(Plots, ChangesOfContactsAreShownAsARate) {
    const Scene scene;
    const auto plots = plots_of(scene, {{"time", Quantity::time},
                                        {"contact.a.x", Quantity::force},
                                        {"contact.a.changes", Quantity::dimensionless},
                                        {"contact.b.changes", Quantity::dimensionless}});
    const auto events =
        std::find_if(plots.begin(), plots.end(), [](const PlotInfo& p) { return p.name == "events"; });
    ASSERT_NE(events, plots.end());
    EXPECT_TRUE(events->rate);
    ASSERT_EQ(events->curves.size(), 2U);
    EXPECT_EQ(events->curves[1].label, "b");
    EXPECT_EQ(events->curves[1].column, 3U);
}

}  // namespace
}  // namespace percuss::app
