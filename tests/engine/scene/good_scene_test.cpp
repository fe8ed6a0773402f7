#include <fstream>
#include <regex>
#include <sstream>

#include <gtest/gtest.h>

#include "engine/scene/small_scene.hpp"

namespace percuss::testing {
namespace {

/// The fuzzer's seed names every key of plane scenes.
Scene every_key() { return load_scene(PERCUSS_SOURCE_DIR "/tests/fuzz/corpus/small.toml"); }

TEST(Scene, ReadsEveryKeyOfModelAndMaterial) {
    const auto scene = every_key();
    EXPECT_EQ(scene.units.length_name(), "mm");
    EXPECT_EQ(scene.geometry, Geometry::plane_strain);
    EXPECT_EQ(scene.thickness, 2);
    EXPECT_EQ(scene.duration, 1);
    EXPECT_EQ(scene.step.courant, 0.5);
    EXPECT_FALSE(scene.step.fixed);
    EXPECT_EQ(scene.energy_growth_limit, 0.5);
    ASSERT_EQ(scene.materials.size(), 1U);
    EXPECT_EQ(scene.materials[0].density, 7.85e-6);
    EXPECT_EQ(scene.materials[0].poisson, 0.3);
    EXPECT_EQ(scene.materials[0].viscosity->linear, 0.06);
    EXPECT_EQ(scene.materials[0].viscosity->quadratic, 1.2);
    EXPECT_TRUE(scene.warnings.empty());
}

TEST(Scene, ReadsEveryKeyOfBodies) {
    const auto scene = every_key();
    ASSERT_EQ(scene.bodies.size(), 2U);
    const auto& body = scene.bodies[0];
    EXPECT_EQ(body.element, ElementKind::triangle);
    EXPECT_EQ(body.pattern, CellPattern::crossed);
    EXPECT_EQ(body.body_force, (std::array{0.0, -1.0}));
    ASSERT_EQ(body.blocks.size(), 2U);
    EXPECT_EQ(body.blocks[0].grading, (std::array{2.0, 0.5}));
    EXPECT_EQ(std::get<Arc>(body.blocks[0].shapes[0]).through, Vec2(0.5, -0.1));
    EXPECT_EQ(std::get<Polyline>(body.blocks[0].shapes[1]).points.at(0), Vec2(1.1, 0.5));
    EXPECT_EQ(body.blocks[0].edge_names, (std::array<std::string, 4>{"face", "", "", ""}));
    EXPECT_EQ(body.constraints.at(0).fixed, (std::array{true, true}));
    EXPECT_EQ(body.constraints[0].box, (std::array{0.0, 0.0, 2.0, 2.0}));
    EXPECT_EQ(body.prescribed.at(0).velocity(0.25), 0.5);
    EXPECT_EQ(body.loads.at(0).pressure.value()(7), 1);
    EXPECT_EQ(body.loads[0].traction[1].value()(0.5), 0.5);
    EXPECT_EQ(scene.bodies[1].hourglass, 0.05);
    EXPECT_EQ(scene.bodies[1].blocks[0].edge_names,
              (std::array<std::string, 4>{"bottom", "right", "top", "left"}));
}

TEST(Scene, ReadsEveryKeyOfParametersAndTurnedBlocks) {
    const auto scene = every_key();
    ASSERT_EQ(scene.parameters.size(), 2U);
    EXPECT_EQ(scene.parameters[1].description, "d");
    const auto& body = scene.bodies.at(1);
    EXPECT_EQ(body.chains.at(0).edges, (std::vector<std::string>{"left", "top"}));
    const auto& block = body.blocks.at(0);
    EXPECT_DOUBLE_EQ(block.corners[1].y(), -2);
    EXPECT_EQ(block.divisions, (std::array{2, 4}));
    EXPECT_EQ(block.fractions[1].size(), 5U);
    EXPECT_EQ(std::get<FormulaSide>(block.shapes[0]).of.by[1]->text, " -2 + 0.1*x*(1 - x)");
    EXPECT_TRUE(std::get<FormulaSide>(block.shapes[3]).of.by[0]);
    EXPECT_EQ(block.shift.by[0]->parameters.at(0).second, 0.1);
    EXPECT_NO_THROW(check_mesh(scene, build_mesh(scene)));
}

TEST(Scene, ReadsEveryKeyOfContactsAndOutput) {
    const auto scene = every_key();
    ASSERT_EQ(scene.contacts.size(), 2U);
    EXPECT_EQ(scene.contacts[0].slave.body, "b");
    EXPECT_EQ(scene.contacts[0].slave.edge, "top");
    EXPECT_EQ(scene.contacts[0].sign, ContactSign::unrestricted);
    EXPECT_EQ(scene.contact_solver.scheme, ContactScheme::projection);
    EXPECT_EQ(scene.probes.at(0).at, Vec2(0.5, -1.5));
    EXPECT_EQ(scene.probes[0].record.size(), 2U);
    EXPECT_EQ(scene.record.history_every, 2);
    EXPECT_EQ(scene.record.frames, 0.1);
    EXPECT_EQ(scene.view.colour_map, "plasma");
    EXPECT_EQ(scene.view.range, (std::array{0.0, 1.0}));
    EXPECT_FALSE(scene.view.edges);
    EXPECT_EQ(scene.view.force_scale, ForceScale::fixed);
    EXPECT_EQ(scene.view.force_reference, 1);
    EXPECT_FALSE(scene.view.velocities);
    EXPECT_EQ(scene.view.up, VerticalAxis::second);
    EXPECT_EQ(scene.view.window->at(3), 1);
    EXPECT_EQ(scene.view.size, (std::array{640, 480}));
    EXPECT_EQ(scene.view.charts.size(), 2U);
    EXPECT_EQ(scene.view.frames_per_second, 30);
    EXPECT_EQ(scene.exact.at(0).label, "zero");
    EXPECT_EQ(scene.exact[0].window, 0.1);
    ASSERT_EQ(scene.expect.size(), 2U);
    EXPECT_EQ(scene.expect[0].path, "energy.maximum_growth");
    EXPECT_EQ(scene.expect[1].why, "w");
}

TEST(Scene, PlacesPointAtValues) {
    const auto scene = parse_scene(small_scene, "scene.toml");
    EXPECT_EQ(describe_place(scene, scene.step.place), "scene.toml:10:11");
    EXPECT_EQ(describe_place(scene, scene.contacts[0].slave.place), "scene.toml:36:9");
}

TEST(TimeFunction, IsLinearBetweenPointsAndConstantOutside) {
    const TimeFunction f{{{1, 10}, {2, 20}, {4, 0}}};
    EXPECT_EQ(f(0), 10);
    EXPECT_EQ(f(1.5), 15);
    EXPECT_EQ(f(2), 20);
    EXPECT_EQ(f(3), 10);
    EXPECT_EQ(f(9), 0);
}

TEST(SceneDocument, ExplainsEveryKeyOfTheSceneThatNamesThemAll) {
    std::ifstream stream(PERCUSS_SOURCE_DIR "/scenes/README.md");
    std::stringstream document;
    document << stream.rdbuf();
    const std::string text = every_key().text + "\nfixed = 1\nmirror = 1\n";
    const std::regex key("(^|[\\n{,] *)([a-z_]+) = ");
    int keys = 0;
    for (std::sregex_iterator match(text.begin(), text.end(), key), end; match != end; ++match, ++keys)
        EXPECT_NE(document.str().find("`" + (*match)[2].str() + "`"), std::string::npos) << (*match)[2];
    EXPECT_GT(keys, 90);
}

TEST(Scene, JointContactRecoversAtOneMetreASecondInAnyUnits) {
    const auto joint = changed(small_scene, "[view]", "[contact_solver]\nscheme = \"joint\"\n[view]");
    EXPECT_EQ(parse_scene(joint, "scene.toml").contact_solver.scheme, ContactScheme::joint);
    EXPECT_DOUBLE_EQ(parse_scene(joint, "scene.toml").contact_solver.recovery_speed, 1) << "mm/ms";
    const auto in_seconds = changed(joint, "time = \"ms\"", "time = \"s\"");
    EXPECT_DOUBLE_EQ(parse_scene(in_seconds, "scene.toml").contact_solver.recovery_speed, 1000) << "mm/s";
    const auto slow = changed(joint, "scheme = \"joint\"", "scheme = \"joint\"\nrecovery_speed = 0.5");
    EXPECT_EQ(parse_scene(slow, "scene.toml").contact_solver.recovery_speed, 0.5);
}

}  // namespace
}  // namespace percuss::testing
