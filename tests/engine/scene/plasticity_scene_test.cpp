// [material.plastic], [material.johnson_cook] and [[wall]]: what they give and what they refuse.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/scene/small_scene.hpp"
#include "run/fields.hpp"

namespace percuss::testing {
namespace {

using ::testing::HasSubstr;

std::string with_material(const std::string& table, const std::string& scene = small_scene) {
    return changed(scene, "poisson = 0.3\n", "poisson = 0.3\n" + table + "\n");
}
std::string with_wall(const std::string& wall, const std::string& contact) {
    return changed(small_scene, "[[contact]]\n", wall + "\n[[contact]]\n" + contact + "\n[[contact]]\n");
}

TEST(PlasticScene, ReadsHardeningFormula) {
    const Scene scene = parse_scene(
        with_material("[material.plastic]\nyield = 0.3\nlinear = 0.05\nsaturation = 0.15\nrate = 10"), "s");
    const auto& law = std::get<VoceHardening>(scene.materials[0].plasticity);
    EXPECT_EQ(law.yield, 0.3);
    EXPECT_EQ(law.linear, 0.05);
    EXPECT_EQ(law.saturation, 0.15);
    EXPECT_EQ(law.rate, 10);
}

TEST(PlasticScene, ReadsPoints) {
    const Scene scene =
        parse_scene(with_material("[material.plastic]\npoints = [[0, 0.3], [0.1, 0.4]]"), "s");
    const auto& points = std::get<TabulatedHardening>(scene.materials[0].plasticity).points;
    EXPECT_EQ(points, (std::vector<std::pair<double, double>>{{0, 0.3}, {0.1, 0.4}}));
}

TEST(PlasticScene, ReadsJohnsonCookWithDefaults) {
    const Scene scene =
        parse_scene(with_material("[material.johnson_cook]\nyield = 0.09\nheat_capacity = 383"), "s");
    const auto& law = std::get<JohnsonCook>(scene.materials[0].plasticity);
    EXPECT_EQ(law.initial_temperature, 293);
    EXPECT_EQ(law.heat_fraction, 0.9);
    EXPECT_FALSE(law.melting_temperature);
}

struct Refused {
    std::string table, message;
};

TEST(PlasticScene, RefusesWithExactMessages) {
    const std::vector<Refused> cases{
        {"[material.plastic]",
         "scene.toml:16:1: [material.plastic] lacks 'yield'; add yield = NUMBER in GPa, or points = [[0, "
         "yield stress], ...]"},
        {"[material.plastic]\nyield = -1", "scene.toml:17:9: 'yield' is -1; it must be > 0"},
        {"[material.plastic]\nyeild = 1", "did you mean 'yield'?"},
        {"[material.plastic]\nyield = 1\nsaturation = 1", "'saturation' needs 'rate'"},
        {"[material.plastic]\nyield = 1\nrate = 1", "'rate' belongs to 'saturation'"},
        {"[material.plastic]\nyield = 1\npoints = [[0, 1]]", "'yield' and 'points' exclude each other"},
        {"[material.plastic]\npoints = []", "'points' is empty"},
        {"[material.plastic]\npoints = [[0.1, 1]]",
         "'points' begin at plastic strain 0.1; the first point must be at 0"},
        {"[material.plastic]\npoints = [[0, 1], [0, 2]]", "does not rise from 0 to 0"},
        {"[material.plastic]\npoints = [[0, 2], [1, 1]]", "the yield stress of 'points' falls from 2 to 1"},
        {"[material.plastic]\npoints = [[0, 0]]", "the first yield stress of 'points' is 0; it must be > 0"},
        {"[material.plastic]\nyield = 1\n[material.johnson_cook]\nyield = 1", "exclude each other; keep one"},
        {"[material.johnson_cook]\nyield = 1\nhardening = 1", "needs 'exponent'"},
        {"[material.johnson_cook]\nyield = 1\nrate_factor = 0.01",
         "'rate_factor' C needs 'reference_rate'; 1/s is reference_rate = 0.001 in 1/ms"},
        {"[material.johnson_cook]\nyield = 1\nmelting_temperature = 200",
         "it must be above the room temperature of 293"},
        {"[material.johnson_cook]\nyield = 1\nheat_fraction = 1", "has no effect without 'heat_capacity'"},
        {"[material.johnson_cook]\nyield = 1\nsoftening_exponent = 1",
         "has no effect without 'melting_temperature'"},
    };
    for (const auto& [table, message] : cases)
        EXPECT_THAT(faults_of(with_material(table)), HasSubstr(message)) << table;
}

TEST(PlasticScene, PlaneStressIsRefused) {
    const std::string text = R"(percuss = 1
[units]
length = "mm"
time = "ms"
mass = "kg"
[model]
geometry = "plane stress"
duration = 1
[[material]]
name = "m"
density = 7.85e-6
young = 210
poisson = 0.3
plastic = { yield = 0.3 }
[[body]]
name = "b"
material = "m"
block = [{ corners = [[0, 0], [1, 0], [1, 1], [0, 1]], divisions = [1, 1] }]
)";
    EXPECT_EQ(faults_of(text),
              "scene.toml:14:11: material 'm' is plastic, but in plane stress plastic flow would change the "
              "thickness, which the "
              "elements do not follow; take geometry = \"plane strain\" or \"axisymmetric\", or an elastic "
              "material");
}

TEST(PlasticScene, WarnsOfAYieldStressInOtherUnits) {
    const Scene scene = parse_scene(with_material("[material.plastic]\nyield = 300"), "s");
    ASSERT_EQ(scene.warnings.size(), 1U);
    EXPECT_THAT(scene.warnings[0],
                HasSubstr("material 'steel' yields at 300 GPa, above 0.2 of its Young's modulus"));
}

TEST(PlasticScene, FieldsDependOnTheMaterials) {
    const auto has = [](const std::string& text, std::string_view name) {
        return fault_of_field(parse_scene(text, "s"), "field", name).empty();
    };
    const std::string plastic = with_material("[material.plastic]\nyield = 0.3");
    const std::string warm = with_material("[material.johnson_cook]\nyield = 0.3\nheat_capacity = 400");
    EXPECT_FALSE(has(small_scene, "plastic_strain"));
    EXPECT_TRUE(has(plastic, "plastic_strain"));
    EXPECT_TRUE(has(plastic, "yield_margin"));
    EXPECT_FALSE(has(plastic, "temperature"));
    EXPECT_TRUE(has(warm, "temperature"));
    EXPECT_THAT(faults_of(changed(small_scene, "field = \"von_mises\"", "field = \"plastic_strain\"")),
                HasSubstr("field 'plastic_strain' needs a body whose material has [material.plastic] or "
                          "[material.johnson_cook]"));
    EXPECT_EQ(faults_of(changed(plastic, "record = [\"stress.axial\"]", "record = [\"plastic_strain\"]")),
              "");
}

const std::string floor = "[[wall]]\nname = \"floor\"\npoint = [0, -3]\nnormal = [0, 2]";
const std::string on_floor = "name = \"on-floor\"\nmaster = \"hammer\"\nslave = \"floor\"";

TEST(WallScene, AWallIsASlaveOfAPair) {
    const std::string text = with_wall(floor, on_floor);
    EXPECT_EQ(faults_of(text), "");
    const Scene scene = parse_scene(text, "s");
    EXPECT_EQ(scene.walls.at(0).normal, Vec2(0, 1));
    const Mesh mesh = build_mesh(scene);
    ASSERT_EQ(mesh.walls.size(), 1U);
    EXPECT_EQ(mesh.walls[0].nodes[0], mesh.bodies.back().node_end);
}

TEST(WallScene, RefusesWithExactMessages) {
    const auto fault = [&](const std::string& old, const std::string& replacement) {
        return faults_of(changed(with_wall(floor, on_floor), old, replacement));
    };
    EXPECT_THAT(fault("point = [0, -3]", "point = [0, -1]"),
                HasSubstr("body 'hammer' reaches 1 mm into wall 'floor' at"));
    EXPECT_THAT(fault("normal = [0, 2]", "normal = [0, 0]"), HasSubstr("'normal' has no direction"));
    EXPECT_THAT(fault("normal = [0, 2]", ""),
                HasSubstr("lacks 'normal'; add normal = [0, 1], pointing out of the wall"));
    EXPECT_THAT(fault("slave = \"floor\"", "slave = \"flor\""), HasSubstr("unknown body 'flor'"));
    EXPECT_THAT(fault("slave = \"floor\"", "slave = \"floor.top\""),
                HasSubstr("wall 'floor' has no edges; write slave = \"floor\""));
    EXPECT_THAT(fault("master = \"hammer\"\n", "master = \"floor\"\n"),
                HasSubstr("'floor' is a wall; walls can only be slaves"));
    EXPECT_THAT(fault("name = \"floor\"", "name = \"rod\""), HasSubstr("the name 'rod' is taken by a body"));
}

}  // namespace
}  // namespace percuss::testing
