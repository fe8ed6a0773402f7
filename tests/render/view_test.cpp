#include "view/view.hpp"

#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "render/synthetic.hpp"
#include "view/colour_range.hpp"
#include "view/force_scale.hpp"
#include "view/side_charts.hpp"

namespace percuss::render {
namespace {

using synthetic::count_pixels;

bool near(int r, int g, int b, unsigned colour, int tolerance = 24) {
    return std::abs(r - static_cast<int>(colour >> 16U & 255U)) <= tolerance &&
           std::abs(g - static_cast<int>(colour >> 8U & 255U)) <= tolerance &&
           std::abs(b - static_cast<int>(colour & 255U)) <= tolerance;
}
constexpr unsigned viridis_low = 0x440154, viridis_high = 0xfde725, viridis_middle = 0x21918c;
constexpr unsigned master_ink = 0xd1135b, slave_ink = 0xf08a24;
const auto of = [](unsigned colour) {
    return [colour](int r, int g, int b) { return near(r, g, b, colour); };
};
const auto ink = [](int r, int g, int b) { return r + g + b < 380; };

/// First and last column (or row) that holds such a pixel inside a part of the picture.
template <class Test>
std::array<int, 2> columns_with(const Image& image, std::array<int, 4> where, const Test& test) {
    std::array<int, 2> found{image.width, -1};
    for (int x = where[0]; x < where[2]; ++x)
        if (count_pixels(image, {x, where[1], x + 1, where[3]}, test) > 0) {
            found[0] = std::min(found[0], x);
            found[1] = std::max(found[1], x);
        }
    return found;
}

class ViewTest : public testing::Test {
  protected:
    ViewTest() : context(make_offscreen_context()), rods(synthetic::rods()) {
        plain = rods->scene.view;
        plain.forces = plain.velocities = plain.edges = false;
    }
    [[nodiscard]] Image draw(const Snapshot& snapshot, const ViewOptions& options,
                             const History* history = nullptr) const {
        View view(*context, snapshot.setup, options);
        return view.draw(snapshot, history);
    }
    std::unique_ptr<Context> context;
    std::shared_ptr<RunSetup> rods;
    ViewOptions plain;
};

// Without labels the rods' 300 mm lie from 30 to 1250 in a picture 1280 wide.
constexpr double first_column = 30, last_column = 1250, contact_column = 30 + 1220.0 / 3;
constexpr std::array<int, 4> model_part{0, 50, 1280, 640};

TEST_F(ViewTest, LeastAndGreatestValueHaveTheEndsOfTheColourMap) {
    Snapshot snapshot = synthetic::at_rest(rods);
    const MeshBody& striker = rods->mesh.bodies[0];
    for (std::int32_t c = striker.cell_begin; c < striker.cell_end; ++c)
        snapshot.stress[static_cast<std::size_t>(c)][1] = -0.203;
    const Image image = draw(snapshot, plain);
    const auto low = columns_with(image, model_part, of(viridis_low));
    const auto high = columns_with(image, model_part, of(viridis_high));
    EXPECT_LT(low[1], high[0] + 3);                 // striker left of the long rod, no overlap
    EXPECT_NEAR(low[1] - low[0], 1220 / 3.0, 6);    // a third of the length
    EXPECT_NEAR(high[1] - high[0], 2440 / 3.0, 6);  // two thirds
    EXPECT_EQ(count_pixels(image, {100, 300, 1180, 400}, of(viridis_middle)), 0);
}

TEST_F(ViewTest, AFixedRangeIsKept) {
    Snapshot snapshot = synthetic::at_rest(rods);
    for (StressMean& stress : snapshot.stress) stress[1] = 0.1;
    ViewOptions options = plain;
    options.range = {0, 0.2};
    const Image image = draw(snapshot, options);
    EXPECT_GT(count_pixels(image, model_part, of(viridis_middle)), 50000);
    EXPECT_EQ(count_pixels(image, model_part, of(viridis_high)), 0);
}

TEST_F(ViewTest, NodeFieldsAreDrawnToo) {
    Snapshot snapshot = synthetic::at_rest(rods);
    for (std::size_t i = 0; i < rods->mesh.nodes.size(); ++i)
        snapshot.velocity[2 * i + 1] = rods->mesh.nodes[i][1];
    ViewOptions options = plain;
    options.field = "velocity.axial";
    const Image image = draw(snapshot, options);
    const auto low = columns_with(image, model_part, of(viridis_low));
    const auto high = columns_with(image, model_part, of(viridis_high));
    EXPECT_NEAR(low[0], first_column, 4);
    EXPECT_NEAR(high[1], last_column, 4);
    EXPECT_LT(low[1], high[0]);
}

TEST_F(ViewTest, ContactForcesPointFromTheContactIntoTheBodies) {
    ViewOptions options = plain;
    options.forces = true;
    options.colour_map = "grey";
    const Image image = draw(synthetic::rods_in_contact(rods, 0.0225, 60), options);
    const auto master = columns_with(image, model_part, of(master_ink));
    const auto slave = columns_with(image, model_part, of(slave_ink));
    EXPECT_NEAR(master[0], contact_column, 4);
    EXPECT_NEAR(slave[1], contact_column, 4);
    EXPECT_NEAR(master[1] - master[0], 0.13 * 720, 5);  // the largest force has its length
    EXPECT_NEAR(slave[1] - slave[0], 0.13 * 720, 5);
    options.forces = false;
    EXPECT_EQ(
        count_pixels(draw(synthetic::rods_in_contact(rods, 0.0225, 60), options), model_part, of(master_ink)),
        0);
}

TEST_F(ViewTest, AutomaticForceScaleIsKeptOverARun) {
    ViewOptions options = plain;
    options.forces = true;
    options.colour_map = "grey";
    View view(*context, rods, options);
    const Snapshot strong = synthetic::rods_in_contact(rods, 0.02, 60);
    Snapshot weak = strong;
    for (ContactForce& contact : weak.contact_forces)
        for (double& force : contact.force) force *= 0.5;
    static_cast<void>(view.draw(strong));
    const auto master = columns_with(view.draw(weak), model_part, of(master_ink));
    EXPECT_NEAR(master[1] - master[0], 0.5 * 0.13 * 720, 5);
}

TEST_F(ViewTest, MirroredPicturesAreSymmetric) {
    ViewOptions options = plain;
    options.forces = true;
    options.up = VerticalAxis::second;
    Snapshot snapshot = synthetic::rods_in_contact(rods, 0.0225, 60);
    for (std::size_t c = 0; c < snapshot.stress.size(); ++c)
        snapshot.stress[c][1] -= 0.02 * static_cast<double>(c % 5);
    const Image image = draw(snapshot, options);
    int different = 0, coloured = 0;
    for (int y = 60; y < 640; ++y)
        for (int x = 0; x < 640; ++x) {
            const auto* left = image.pixels.data() + 3 * (y * image.width + x);
            const auto* right = image.pixels.data() + 3 * (y * image.width + image.width - 1 - x);
            const int apart =
                std::abs(left[0] - right[0]) + std::abs(left[1] - right[1]) + std::abs(left[2] - right[2]);
            if (left[0] + left[1] + left[2] < 700) ++coloured;
            if (apart > 60) ++different;
        }
    EXPECT_GT(coloured, 5000);
    EXPECT_LT(different, 0.06 * coloured);  // rims fall on either side of a pixel's centre

    options.mirror = false;
    const Image half = draw(snapshot, options);
    const auto both_columns = columns_with(image, {0, 100, 1280, 600}, ink);
    const auto half_columns = columns_with(half, {0, 100, 1280, 600}, ink);
    EXPECT_NEAR(half_columns[1] - half_columns[0], 0.5 * (both_columns[1] - both_columns[0]), 6);
}

TEST_F(ViewTest, TheSamePictureTwiceIsIdentical) {
    const auto history = synthetic::rods_history(0.06, 2000);
    ViewOptions options = rods->scene.view;
    options.charts = {"force", "energy"};
    const Snapshot snapshot = synthetic::rods_in_contact(rods, 0.0225, 60);
    View view(*context, rods, options);
    const Image first = view.draw(snapshot, history.get());
    static_cast<void>(view.draw(synthetic::at_rest(rods), history.get()));
    EXPECT_EQ(view.draw(snapshot, history.get()).pixels, first.pixels);
    EXPECT_EQ(draw(snapshot, options, history.get()).pixels, first.pixels);
}

TEST_F(ViewTest, ChartsShowTheHistoryUpToTheSnapshotsTime) {
    const auto history = synthetic::rods_history(0.06, 2000);
    ViewOptions options = plain;
    options.charts = {"force"};
    const auto curve = of(0x0072b2);
    const std::array<int, 4> chart_part{30, 400, 1270, 670};
    const auto early = columns_with(draw(synthetic::rods_in_contact(rods, 0.015, 30), options, history.get()),
                                    chart_part, curve);
    const auto late = columns_with(draw(synthetic::rods_in_contact(rods, 0.06, 30), options, history.get()),
                                   chart_part, curve);
    EXPECT_NEAR(early[1] - early[0], 0.25 * (late[1] - late[0]), 12);
    EXPECT_GT(late[1], 1150);  // the whole run
    EXPECT_EQ(count_pixels(draw(synthetic::rods_in_contact(rods, 0.06, 30), options), chart_part, curve), 0);
}

TEST_F(ViewTest, EveryChartNameDraws) {
    const auto history = synthetic::rods_history(0.06, 200);
    ViewOptions options = plain;
    for (const char* name : {"force", "velocity", "energy", "body.striker.velocity.axial"}) {
        options.charts = {name};
        EXPECT_GT(count_pixels(draw(synthetic::rods_in_contact(rods, 0.03, 30), options, history.get()),
                               {30, 400, 1270, 690}, of(0x0072b2)),
                  200)
            << name;
    }
}

TEST_F(ViewTest, TheEnergyChartShowsTheSumOfKineticAndInternalEnergy) {
    const auto history = synthetic::rods_history(0.06, 500);
    const Chart chart = make_side_chart("energy", rods->scene, *history, 0.06, {1, "ms"});
    ASSERT_EQ(chart.curves.size(), 4U);
    EXPECT_EQ(chart.title, "energy [J]");
    EXPECT_EQ(chart.curves[3].label, "kinetic + internal");
    for (std::size_t i = 0; i < chart.curves[0].y.size(); ++i)
        EXPECT_DOUBLE_EQ(chart.curves[3].y[i], chart.curves[0].y[i] + chart.curves[1].y[i]);
}

TEST_F(ViewTest, ForceChartsLeaveOutADirectionWithoutForce) {
    const auto history = synthetic::rods_history(0.06, 500);
    const Chart chart = make_side_chart("force", rods->scene, *history, 0.03, {1e3, "µs"});
    ASSERT_EQ(chart.curves.size(), 1U);
    EXPECT_EQ(chart.curves[0].label, "impact");
    EXPECT_EQ(chart.x_title, "time [µs]");
    EXPECT_EQ((*chart.x_range)[1], 60);
    EXPECT_LE(chart.curves[0].x.back(), 30);
}

TEST_F(ViewTest, VelocityLabelsStandOutsideTheMesh) {
    ViewOptions options = plain;
    options.window = {-30, -10, 30, 310};  // one scale for both pictures
    const Image without = draw(synthetic::rods_in_contact(rods, 0.0225, 60), options);
    options.velocities = true;
    const Snapshot snapshot = synthetic::rods_in_contact(rods, 0.0225, 60);
    const Image with = draw(snapshot, options);
    const auto label = of(0x12324f);
    // The rods are 76 pixels high around the middle of the model's part.
    const int axis = 345;
    const int above = count_pixels(with, {0, 60, 1280, axis - 45}, label);
    int changed_in_mesh = 0;
    for (int y = axis - 30; y < axis + 30; ++y)
        for (int x = 0; x < 1280; ++x) {
            const std::size_t at = 3 * static_cast<std::size_t>(y * 1280 + x);
            if (with.pixels[at] != without.pixels[at]) ++changed_in_mesh;
        }
    EXPECT_GT(above, 300);
    EXPECT_LT(changed_in_mesh, 2500);  // arrows, discs and leaders only
}

TEST_F(ViewTest, AWindowShowsOnlyItsPart) {
    Snapshot snapshot = synthetic::at_rest(rods);
    const MeshBody& striker = rods->mesh.bodies[0];
    for (std::int32_t c = striker.cell_begin; c < striker.cell_end; ++c)
        snapshot.stress[static_cast<std::size_t>(c)][1] = -0.203;
    ViewOptions options = plain;
    options.window = {-3, 60, 3, 72};  // inside the striker
    const Image image = draw(snapshot, options);
    EXPECT_EQ(count_pixels(image, {0, 60, 1280, 640}, of(viridis_high)), 0);
    EXPECT_GT(count_pixels(image, {0, 60, 1280, 640}, of(viridis_low)), 100000);
}

TEST_F(ViewTest, SizeAndFieldChangeBetweenDraws) {
    View view(*context, rods, plain);
    const Snapshot snapshot = synthetic::rods_in_contact(rods, 0.0225, 60);
    EXPECT_EQ(view.draw(snapshot).width, 1280);
    ViewOptions options = plain;
    options.size = {801, 451};
    options.field = "displacement.magnitude";
    options.up = VerticalAxis::second;
    view.set_options(options);
    const Image image = view.draw(snapshot);
    EXPECT_EQ(image.width, 801);
    EXPECT_EQ(image.height, 451);
    EXPECT_EQ(image.pixels, draw(snapshot, options).pixels);
}

TEST_F(ViewTest, WrongNamesAreAnsweredWithTheNearest) {
    const auto message = [&](const ViewOptions& options, const History* history) {
        try {
            static_cast<void>(draw(synthetic::at_rest(rods), options, history));
        } catch (const RenderError& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    ViewOptions options = plain;
    options.field = "stress.axail";
    EXPECT_THAT(message(options, nullptr), testing::AllOf(testing::HasSubstr("unknown field 'stress.axail'"),
                                                          testing::HasSubstr("stress.axial")));
    options = plain;
    options.colour_map = "viridris";
    EXPECT_THAT(message(options, nullptr), testing::AllOf(testing::HasSubstr("unknown colour map 'viridris'"),
                                                          testing::HasSubstr("viridis")));
    options = plain;
    options.charts = {"forse"};
    const auto history = synthetic::rods_history(0.06, 20);
    EXPECT_THAT(message(options, history.get()),
                testing::AllOf(testing::HasSubstr("unknown chart 'forse'"), testing::HasSubstr("force")));
    options = plain;
    options.size = {10, 10};
    EXPECT_THAT(message(options, nullptr), testing::HasSubstr("64 x 64"));
}

TEST(ColourRange, IsTheDataRangeOrTheOneAskedFor) {
    ViewOptions options;
    const std::vector<double> values{0.05, 0.1, NAN, -0.2, 0.02};
    EXPECT_EQ(colour_range(values, options, false, 1), (ColourRange{-0.2, 0.1}));
    EXPECT_EQ(colour_range(values, options, true, 1), (ColourRange{-0.2, 0.2}));
    options.range = {0, 3};
    EXPECT_EQ(colour_range(values, options, true, 1), (ColourRange{0, 3}));
}

TEST(ColourRange, RoundingNoiseIsNoRainbow) {
    const std::vector<double> noise{1e-17, -3e-16, 2e-16};
    EXPECT_EQ(colour_range(noise, ViewOptions{}, false, 0.2), (ColourRange{0, 0}));
}

TEST(ForceScaling, LengthsFollowTheKindOfScale) {
    ViewOptions options;
    const ForceScaling automatic = make_force_scaling(options, 63.8, 100);
    EXPECT_DOUBLE_EQ(automatic.reference, 50);
    EXPECT_NEAR(automatic.length(63.8), 100, 1e-9);
    EXPECT_NEAR(automatic.length(31.9), 50, 1e-9);
    EXPECT_EQ(automatic.length(0.1), 0);  // negligible

    options.force_scale = ForceScale::fixed;
    options.force_reference = 20;
    const ForceScaling fixed = make_force_scaling(options, 63.8, 100);
    EXPECT_NEAR(fixed.length(20), 100, 1e-9);
    EXPECT_NEAR(fixed.length(40), 200, 1e-9);

    options = ViewOptions{};
    options.force_scale = ForceScale::logarithmic;
    const ForceScaling logarithmic = make_force_scaling(options, 100, 90);
    EXPECT_NEAR(logarithmic.length(100), 90, 1e-9);
    EXPECT_NEAR(logarithmic.length(10), 60, 1e-9);
    EXPECT_NEAR(logarithmic.length(0.01), 0, 1e-9);
}

}  // namespace
}  // namespace percuss::render
