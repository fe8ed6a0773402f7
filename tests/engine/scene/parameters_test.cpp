#include <gtest/gtest.h>

#include "engine/scene/small_scene.hpp"
#include "mesh/select.hpp"

namespace percuss::testing {
namespace {

/// The small scene with [parameters] in its second and next lines; the rest moves down.
std::string scene_with(const std::string& parameters, const std::string& old = "percuss = 1",
                       const std::string& replacement = "percuss = 1") {
    return changed(changed(small_scene, old, replacement), "percuss = 1\n",
                   "percuss = 1\n[parameters]\n" + parameters + "\n");
}

Scene parsed(const std::string& text, const std::vector<std::string>& overrides = {}) {
    return parse_scene(text, "scene.toml", overrides);
}

const std::string shank =
    R"(shank = { value = 4.2, range = [3, 6], unit = "mm", description = "diameter of the shank" })";

TEST(Parameters, ComeWithValueRangeUnitAndDescriptionInTheOrderOfTheFile) {
    const auto scene = parsed(scene_with(shank + "\nclearance = 0.1\nbore = \"= shank + 2*clearance\""));
    ASSERT_EQ(scene.parameters.size(), 3U);
    const auto& first = scene.parameters[0];
    EXPECT_EQ(first.name, "shank");
    EXPECT_EQ(first.value, 4.2);
    EXPECT_EQ(first.range, (std::array{3.0, 6.0}));
    EXPECT_EQ(first.unit, "mm");
    EXPECT_EQ(first.description, "diameter of the shank");
    EXPECT_EQ(first.expression, "");
    EXPECT_EQ(describe_place(scene, first.place), "scene.toml:3:19");
    EXPECT_EQ(scene.parameters[1].name, "clearance");
    EXPECT_FALSE(scene.parameters[1].range);
    EXPECT_EQ(scene.parameters[2].value, 4.2 + 0.2);
    EXPECT_EQ(scene.parameters[2].expression, "= shank + 2*clearance");
}

TEST(Parameters, MayReferToLaterOnes) {
    EXPECT_EQ(parsed(scene_with("a = \"= 2*b\"\nb = \"= c + 1\"\nc = 3")).parameters[0].value, 8);
}

TEST(Parameters, ReachEveryKindOfNumber) {
    auto text = scene_with("h = 4\nn = 2.0\nspeed = 10", "corners = [[0, 0], [4, 0], [4, 8], [0, 8]]",
                           "corners = [[0, 0], ['= h', 0], ['= h', '= 2*h'], [0, '= 2*h']]");
    text = changed(text, "divisions = [4, 8]", "divisions = ['= 2*n', '= round(1.99*h)']");
    text = changed(text, "velocity = [0, 10]", "velocity = [0, \"= speed*2\"]");
    text = changed(text, "young = 210", "young = \"= 200 + speed\"");
    text = changed(text, "at = [1, 2]", "at = ['= h/4', 2]");
    text = changed(
        text, "fixed = [\"axial\"]",
        "fixed = [\"axial\"]\nbox = [0, '= 2*h', '= h/2', '= 2*h']\n[[body.prescribed]]\nedge = \"top\"\n"
        "direction = \"axial\"\nvelocity = [['= h - 4', '= h - 4'], ['= h', 1]]\n[[body.load]]\n"
        "edge = \"right\"\npressure = \"= h/1000\"\ntraction = [\"= h\", [[0, \"= h\"], [1, 2]]]");
    text +=
        "range = [0, \"= h\"]\nsize = [640, \"= 120*h\"]\n[record]\nhistory_every = \"= h/2\"\n"
        "[expect]\nsteps = { value = \"= h\" }\n";
    const auto scene = parsed(text);
    EXPECT_EQ(scene.bodies[0].velocity[1], 20);
    EXPECT_EQ(scene.materials[0].young, 210);
    const auto& rod = scene.bodies[1];
    EXPECT_EQ(rod.blocks[0].corners[2], Vec2(4, 8));
    EXPECT_EQ(rod.blocks[0].divisions, (std::array{4, 8}));
    EXPECT_EQ(rod.constraints[0].box, (std::array{0.0, 8.0, 2.0, 8.0}));
    EXPECT_EQ(rod.prescribed[0].velocity(2), 0.5);
    EXPECT_EQ(rod.loads[0].pressure.value()(0), 0.004);
    EXPECT_EQ(rod.loads[0].traction[0].value()(0), 4);
    EXPECT_EQ(rod.loads[0].traction[1].value()(0), 4);
    EXPECT_EQ(scene.probes[0].at, Vec2(1, 2));
    EXPECT_EQ(scene.view.range, (std::array{0.0, 4.0}));
    EXPECT_EQ(scene.view.size, (std::array{640, 480}));
    EXPECT_EQ(scene.record.history_every, 2);
    EXPECT_EQ(scene.expect[0].max, 4);
    check_mesh(scene, build_mesh(scene));
}

TEST(Parameters, LeaveTextAlone) {
    EXPECT_EQ(parsed(scene_with("a = 1", "percuss = 1", "title = \"= a\"\npercuss = 1")).title, "= a");
}

TEST(Parameters, AreOverriddenByValueAndKeepTheirRange) {
    const auto text = scene_with(shank + "\nclearance = 0.1\nbore = \"= shank + clearance\"");
    const auto scene = parsed(text, {"parameters.shank=4.4", "parameters.clearance== 0.1 + 0.1",
                                     "body.hammer.velocity.1== 2*shank"});
    EXPECT_EQ(scene.parameters[0].value, 4.4);
    EXPECT_EQ(scene.parameters[0].unit, "mm");
    EXPECT_EQ(scene.parameters[1].value, 0.2);
    EXPECT_EQ(scene.parameters[2].value, 4.4 + 0.2);
    EXPECT_EQ(scene.bodies[0].velocity[1], 8.8);
    const auto refused = [&](const std::string& override) { return faults_of(text, {override}); };
    EXPECT_EQ(refused("parameters.shank=7"),
              "--set parameters.shank=7: parameter 'shank' is 7 mm; its range is 3 to 6 mm");
    EXPECT_EQ(refused("parameters.shnk=4"),
              "--set parameters.shnk=4: there is no parameter 'shnk'; did you mean 'shank'?");
    EXPECT_EQ(refused("parameters.shank== bore"),
              "--set parameters.shank== bore: parameter 'shank' depends on itself: shank -> bore -> shank; "
              "give one of them a number");
    EXPECT_EQ(refused("parameters.shank=thick"),
              "--set parameters.shank=thick: parameter 'shank' is a string; it must be a number");
    EXPECT_EQ(parsed(text, {"parameters.shank={value=9}"}).parameters[0].value, 9);
    EXPECT_EQ(faults_of(small_scene, {"parameters.shank=4"}),
              "--set parameters.shank=4: there is no parameter 'shank'; there are none");
}

struct Broken {
    std::string parameters, young, message;
};

class BrokenExpression : public ::testing::TestWithParam<Broken> {};

TEST_P(BrokenExpression, NamesItsTextAndPlace) {
    const auto& [parameters, young, message] = GetParam();
    EXPECT_EQ(faults_of(scene_with(parameters, "young = 210", "young = " + young)), "scene.toml:" + message);
}

INSTANTIATE_TEST_SUITE_P(
    Parameters, BrokenExpression,
    ::testing::Values(
        Broken{shank, "'= 50*shnk'",
               "16:9: 'young' = \"= 50*shnk\": unknown name 'shnk'; did you mean 'shank'?"},
        Broken{"", "'= 50*shank'", "16:9: 'young' = \"= 50*shank\": unknown name 'shank'; there are none"},
        Broken{shank, "'= 1/(shank - 4.2)'", "16:9: 'young' = \"= 1/(shank - 4.2)\": division by zero"},
        Broken{shank, "'= sqrt(-shank)'",
               "16:9: 'young' = \"= sqrt(-shank)\": the result is not a finite number"},
        Broken{shank, "'= 50*'", "16:9: 'young' = \"= 50*\": it ends too early"},
        Broken{shank, "'= -shank'", "16:9: 'young' is -4.2 (\"= -shank\"); it must be > 0"},
        Broken{"a = \"= 1/0\"\nb = \"= a + 1\"", "'= b'", "3:5: parameter 'a' = \"= 1/0\": division by zero"},
        Broken{"a = \"= a\"", "210",
               "3:5: parameter 'a' depends on itself: a -> a; give one of them a number"},
        Broken{"a = \"= b\"\nb = { value = \"= c\" }\nc = \"= a\"", "'= c'",
               "3:5: parameter 'a' depends on itself: a -> b -> c -> a; give one of them a number"},
        Broken{"shank = { value = 7, range = [3, 6] }", "'= shank'",
               "3:19: parameter 'shank' is 7; its range is 3 to 6"},
        Broken{"a = 8\nb = { value = \"= a/2\", range = [5, 6], unit = \"mm\" }", "210",
               "4:15: parameter 'b' is 4 mm (\"= a/2\"); its range is 5 to 6 mm"},
        Broken{"shank = { value = 4, range = [6, 3] }", "210",
               "3:30: 'range' is empty; write [lowest, highest]"},
        Broken{"shank = { range = [3, 6] }", "210",
               "3:9: parameter 'shank' lacks 'value'; add value = NUMBER"},
        Broken{"shank = { value = 4, rnage = [3, 6] }", "210",
               "3:22: unknown key 'rnage' in parameter 'shank'; did you mean 'range'?"},
        Broken{"shank = true", "210", "3:9: parameter 'shank' is a boolean; it must be a number"},
        Broken{"my-shank = 1", "210",
               "3:1: parameter 'my-shank' is no name for expressions; use letters, digits and '_', a letter "
               "first"},
        Broken{"r = 1", "210",
               "3:1: parameter 'r' has the name of a variable of formulas; choose a longer one"},
        Broken{"sin = 1", "210",
               "3:1: parameter 'sin' has the name of a function or constant; choose another"}));

TEST(Parameters, RoundNothingThatIsNoInteger) {
    const auto fault = [](const std::string& cells) {
        return faults_of(scene_with("n = 2", "divisions = [4, 8]", "divisions = [" + cells + ", 8]"));
    };
    EXPECT_EQ(fault("\"= 4.5*n - 1\""), "");
    EXPECT_EQ(fault("\"= 0.1*3*10*n/3 + 2\""), "");  // 4.000000000000001
    EXPECT_EQ(fault("\"= n*2.2\""),
              "scene.toml:30:14: 'divisions[0]' is 4.4 (\"= n*2.2\"); it must be an integer: use round(), "
              "floor() or ceil()");
    EXPECT_EQ(fault("\"= n - 2\""),
              "scene.toml:30:14: 'divisions[0]' is 0 (\"= n - 2\"); it must be >= 1 and <= 1000000");
    EXPECT_EQ(fault("4.0"), "scene.toml:30:14: 'divisions[0]' is 4.0; it must be an integer");
    EXPECT_EQ(fault("4.0000001"), "scene.toml:30:14: 'divisions[0]' is 4.0000001; it must be an integer");
    EXPECT_EQ(fault("'= round(n*2.2)'"), "");
}

TEST(Parameters, MayBeManyButNotTooMany) {
    std::string chain;
    for (int i = 0; i < 499; ++i)
        chain += "p" + std::to_string(i) + " = \"= p" + std::to_string(i + 1) + " + 1\"\n";
    EXPECT_EQ(parsed(scene_with(chain + "p499 = 0")).parameters[0].value, 499);
    EXPECT_EQ(faults_of(scene_with(chain + "p499 = 0\nq = 1")),
              "scene.toml:2:1: [parameters] has 501 parameters; at most 500 are read");
}

}  // namespace
}  // namespace percuss::testing
