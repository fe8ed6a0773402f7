#include "study/grid.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/scene/small_scene.hpp"
#include "exit_status.hpp"

namespace percuss::app {
namespace {

using percuss::testing::small_scene;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

Scene scene() { return parse_scene(small_scene, "scene.toml"); }

Variation variation(const std::string& text) { return make_variation(parse_axis(text, "--vary"), scene()); }

template <class Call>
std::string complaint(Call call) {
    try {
        call();
    } catch (const UsageError& error) {
        return error.what();
    }
    return "";
}

TEST(Grid, CommasInBracketsAndQuotesDoNotPart) {
    EXPECT_THAT(parse_axis("a.b=1,2.5,x", "--vary").values, ElementsAre("1", "2.5", "x"));
    EXPECT_THAT(parse_axis("a=[5,50],[10,100]", "--vary").values, ElementsAre("[5,50]", "[10,100]"));
    EXPECT_THAT(parse_axis("a=\"x,y\",z", "--vary").values, ElementsAre("\"x,y\"", "z"));
    for (const char* text : {"a", "a=", "=1", "a=1,,2", ""})
        EXPECT_THAT(complaint([&] { static_cast<void>(parse_axis(text, "--vary")); }),
                    HasSubstr("write KEY=VALUE,VALUE"))
            << text;
    EXPECT_THAT(complaint([] { static_cast<void>(parse_axis("a=1,2,1", "--vary")); }),
                HasSubstr("the value 1 stands there twice"));
}

TEST(Grid, KeysTellWhatTheyAreToTheAnswer) {
    EXPECT_EQ(usual_kind("model.step.courant"), AxisKind::step);
    EXPECT_EQ(usual_kind("parameters.mesh"), AxisKind::mesh);
    EXPECT_EQ(usual_kind("body.rod.block.0.divisions"), AxisKind::mesh);
    EXPECT_EQ(usual_kind("body.*.element"), AxisKind::method);
    EXPECT_EQ(usual_kind("scheme"), AxisKind::method);
    EXPECT_EQ(usual_kind("contact.hit.layer.viscosity"), AxisKind::method);
    EXPECT_EQ(usual_kind("parameters.friction"), AxisKind::design);
    EXPECT_EQ(usual_kind("contact.hit.friction"), AxisKind::design);
}

TEST(Grid, AllCombinationsTheLastAxisRunningFastest) {
    const std::vector<Variation> axes{variation("model.step.courant=0.9,0.5,0.1"),
                                      variation("body.rod.block.0.divisions=[4,8],[8,16]")};
    const auto all = combine(axes);
    ASSERT_EQ(all.size(), 6U);
    EXPECT_THAT(all[0].at, ElementsAre(0, 0));
    EXPECT_THAT(all[1].at, ElementsAre(0, 1));
    EXPECT_THAT(all[2].at, ElementsAre(1, 0));
    EXPECT_THAT(all[1].overrides, ElementsAre("model.step.courant=0.9", "body.rod.block.0.divisions=[8,16]"));
    EXPECT_EQ(combine({}).size(), 1U);
}

TEST(Grid, MethodsAreSetBeforeWhatTheyWouldTakeAway) {
    const std::vector<Variation> axes{variation("contact_solver.recovery_speed=1,2"),
                                      variation("scheme=joint")};
    const auto overrides = combine(axes)[1].overrides;
    EXPECT_EQ(overrides.front(), "contact_solver.scheme=joint");
    EXPECT_EQ(overrides.back(), "contact_solver.recovery_speed=2");
    EXPECT_EQ(parse_scene(small_scene, "scene.toml", overrides).contact_solver.recovery_speed, 2);
}

TEST(Grid, TheScenesOwnValueIsHome) {
    EXPECT_EQ(variation("model.step.courant=0.9,0.5,0.1").home(), 1U);
    EXPECT_EQ(variation("model.step.courant=0.9,0.4").home(), 1U) << "else the last";
    EXPECT_EQ(variation("scheme=projection,joint").home(), 0U);
    EXPECT_EQ(variation("body.*.element=triangle,one-point quad").home(), 1U);
}

TEST(Grid, AStarStandsForEachBody) {
    EXPECT_THAT(variation("body.*.element=triangle").values[0].overrides,
                ElementsAre("body.hammer.element=triangle", "body.rod.element=triangle"));
    EXPECT_THAT(complaint([] { variation("wall.*.point=[0,0]"); }),
                HasSubstr("nothing that the star stands for"));
}

TEST(Grid, AnUnknownSchemeIsToldWithTheNearest) {
    EXPECT_THAT(complaint([] { variation("scheme=projektion"); }),
                HasSubstr("unknown scheme 'projektion'; did you mean 'projection'?"));
}

}  // namespace
}  // namespace percuss::app
