#include "view/contact_sides.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/scene/small_scene.hpp"
#include "view/force_scale.hpp"

namespace percuss::render {
namespace {

constexpr Colour master_force_colour = 0xd1135b, slave_force_colour = 0xf08a24;

/// Keeps what is drawn.
class Sheet : public Canvas {
  public:
    struct Dot {
        double x, y, radius;
        Colour colour;
    };
    struct Line {
        double x0, y0, x1, y1;
        Colour colour;
    };
    void text(double, double, const std::string&, const TextStyle&) override {}
    std::array<double, 2> text_size(const std::string&, const TextStyle&) override { return {10, 10}; }
    void line(double x0, double y0, double x1, double y1, Colour colour, double) override {
        lines.push_back({x0, y0, x1, y1, colour});
    }
    void rectangle(const Rect&, Colour, double) override {}
    void quad(const std::array<std::array<double, 2>, 4>&, Colour) override {}
    void disc(double x, double y, double radius, Colour fill) override {
        dots.push_back({x, y, radius, fill});
    }
    void image(const Rect&, vtkImageData*) override {}

    std::vector<Dot> dots;
    std::vector<Line> lines;

  private:
    void fill_arrow(const std::array<std::array<double, 2>, 7>&, Colour) override {}
};

TEST(ContactSides, AreNodesOfTheMasterAndSidesOfTheSlave) {
    // Master rod.face and slave hammer.top lie at z = 0, r from 0 to 4, in four sides each.
    auto setup = std::make_shared<RunSetup>();
    setup->scene = parse_scene(percuss::testing::small_scene, "small.toml");
    setup->mesh = build_mesh(setup->scene);
    Snapshot now;
    now.setup = setup;
    for (const Vec2& node : setup->mesh.nodes) now.position.insert(now.position.end(), {node.x(), node.y()});
    const auto sides = contact_sides(*setup);
    ASSERT_EQ(sides.size(), 1U);
    Sheet sheet;
    const Fit fit{10, {400, 100}};
    const Rect all{-1e4, -1e4, 2e4, 2e4};
    paint_contact_sides(sheet, now, sides[0], {}, fit, all, 1);
    ASSERT_EQ(sheet.dots.size(), 5U);
    ASSERT_EQ(sheet.lines.size(), 4U);
    std::set<double> across;
    for (const auto& dot : sheet.dots) {
        EXPECT_NEAR(dot.y, 100, 1e-9);
        EXPECT_EQ(dot.colour, master_force_colour);
        across.insert(dot.x);
    }
    EXPECT_THAT(across, ::testing::ElementsAre(400, 410, 420, 430, 440));
    for (const auto& line : sheet.lines) {
        EXPECT_NEAR(line.y0, 100, 1e-9);
        EXPECT_NEAR(std::abs(line.x1 - line.x0), 10, 1e-9);
        EXPECT_EQ(line.colour, slave_force_colour);
    }
    const MeshBody& rod = setup->mesh.bodies[1];
    for (const std::int32_t node : sides[0].masters)
        EXPECT_TRUE(rod.node_begin <= node && node < rod.node_end);
    Sheet beside;
    paint_contact_sides(beside, now, sides[0], {}, fit, {0, 0, 50, 50}, 1);
    EXPECT_TRUE(beside.dots.empty());
    EXPECT_TRUE(beside.lines.empty());
    Sheet half;  // lines are cut where the picture ends
    paint_contact_sides(half, now, sides[0], {}, fit, {0, 0, 415, 200}, 1);
    ASSERT_EQ(half.lines.size(), 2U);
    double right = 0;
    for (const auto& line : half.lines) right = std::max({right, line.x0, line.x1});
    EXPECT_NEAR(right, 415, 1e-9);
    Sheet far;  // all nodes on a few pixels
    paint_contact_sides(far, now, sides[0], {}, Fit{0.02, {0, 0}}, all, 1);
    EXPECT_EQ(far.dots.size(), 1U);
    Sheet mirrored;
    paint_contact_sides(mirrored, now, sides[0], {VerticalAxis::second, true}, fit, all, 1);
    EXPECT_EQ(mirrored.dots.size(), 2 * sheet.dots.size());
}

TEST(ForceScaling, CutOffAndDecades) {
    ViewOptions options;
    ForceScaling scaling = make_force_scaling(options, 2, 100);
    EXPECT_EQ(scaling.length(0.009 * scaling.reference), 0) << "below a hundredth";
    EXPECT_GT(scaling.length(0.011 * scaling.reference), 0);
    options.force_cut_off = 0.2;
    scaling = make_force_scaling(options, 2, 100);
    EXPECT_EQ(scaling.length(0.19 * scaling.reference), 0);
    EXPECT_NEAR(scaling.length(2), 100, 1e-9) << "the largest keeps its length";
    options.force_scale = ForceScale::logarithmic;
    options.force_cut_off = 0.1;
    scaling = make_force_scaling(options, 2, 100);
    EXPECT_EQ(scaling.decades(), 1);
    EXPECT_NEAR(scaling.length(2), 100, 1e-9);
    EXPECT_NEAR(scaling.length(scaling.reference / std::sqrt(10)), 0.5 * scaling.reference_length, 1e-9);
    EXPECT_EQ(scaling.length(0.1 * scaling.reference), 0);
    options.force_cut_off.reset();
    EXPECT_EQ(make_force_scaling(options, 2, 100).decades(), 3);
    // A reference far above all forces keeps the length that the largest arrow has.
    options.force_reference = 1e6;
    EXPECT_EQ(make_force_scaling(options, 2, 100).reference_length, 100);
    options.force_scale = ForceScale::fixed;
    options.force_reference = 5;
    scaling = make_force_scaling(options, 2, 100);
    EXPECT_EQ(scaling.length(5), 100);
    EXPECT_EQ(scaling.length(10), 200);
}

}  // namespace
}  // namespace percuss::render
