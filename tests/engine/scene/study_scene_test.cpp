#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/scene/small_scene.hpp"
#include "run/in_flight.hpp"
#include "scene/named_schemes.hpp"

namespace percuss {
namespace {

using testing::changed;
using ::testing::ElementsAre;
using testing::faults_of;
using ::testing::HasSubstr;
using testing::small_scene;

const std::string study = R"([parameters]
speed = 10
[[study.vary]]
key = "model.step.courant"
values = [0.9, 0.25, 1]
[[study.vary]]
key = "body.rod.block.0.divisions"
values = [[4, 8], [8, 16]]
name = "cells"
kind = "mesh"
[[study.vary]]
key = "scheme"
values = ["joint", "projection"]
[[study.quantity]]
of = "contact.hit.peak_force"
name = "peak"
exact = "= 2*speed"
tolerance = 0.05
[[study.quantity]]
of = "probe.p.stress.axial"
)";

TEST(StudyScene, ReadsAStudy) {
    const Scene scene = parse_scene(small_scene + study, "scene.toml");
    ASSERT_TRUE(scene.study);
    const auto& vary = scene.study->vary;
    ASSERT_EQ(vary.size(), 3U);
    EXPECT_THAT(vary[0].values, ElementsAre("0.9", "0.25", "1"));
    EXPECT_EQ(vary[0].name, "step");
    EXPECT_EQ(vary[0].kind, AxisKind::step);
    EXPECT_THAT(vary[1].values, ElementsAre("[ 4, 8 ]", "[ 8, 16 ]"));
    EXPECT_EQ(vary[1].name, "cells");
    EXPECT_EQ(vary[2].kind, AxisKind::method);
    const auto& quantities = scene.study->quantities;
    ASSERT_EQ(quantities.size(), 2U);
    EXPECT_EQ(quantities[0].exact, 20);
    EXPECT_EQ(quantities[0].tolerance, 0.05);
    EXPECT_EQ(quantities[1].name, "probe.p.stress.axial");
    EXPECT_FALSE(parse_scene(small_scene, "scene.toml").study);
}

TEST(StudyScene, AccuracyNeedsSomethingToChooseFrom) {
    const std::string target =
        "[accuracy]\ntarget = { quantity = \"contact.hit.peak_force\", tolerance = 0.02 }\n";
    const Scene scene = parse_scene(small_scene + study + target, "scene.toml");
    ASSERT_TRUE(scene.accuracy);
    EXPECT_EQ(scene.accuracy->quantity, "contact.hit.peak_force");
    EXPECT_EQ(scene.accuracy->tolerance, 0.02);
    EXPECT_THAT(faults_of(small_scene + target),
                HasSubstr("no steps or meshes to choose from; add a [[study.vary]]"));
    EXPECT_THAT(faults_of(small_scene + study + changed(target, ".hit.", ".hot.")),
                HasSubstr("unknown contact 'hot'"));
    EXPECT_THAT(faults_of(small_scene + study + "[accuracy]\n"), HasSubstr("lacks 'target'"));
}

TEST(StudyScene, ARunKnowsNothingOfIt) {
    EXPECT_EQ(effect_of_change(parse_scene(small_scene, "scene.toml"),
                               parse_scene(small_scene + study, "scene.toml")),
              ChangeEffect::none);
    EXPECT_EQ(effect_of_change("study.vary.0.values"), ChangeEffect::none);
}

TEST(StudyScene, FaultsAreToldWithTheirCure) {
    const auto with = [&](const std::string& old, const std::string& now) {
        return faults_of(small_scene + changed(study, old, now));
    };
    EXPECT_EQ(faults_of(small_scene + study), "");
    EXPECT_THAT(with("values = [0.9, 0.25, 1]", "value = [0.9]"),
                HasSubstr("lacks 'values'; add values = [0.9, 0.5]"));
    EXPECT_THAT(with("values = [0.9, 0.25, 1]", "value = [0.9]"), HasSubstr("unknown key 'value'"));
    EXPECT_THAT(with("values = [0.9, 0.25, 1]", "values = []"), HasSubstr("at least one value"));
    EXPECT_THAT(with("[0.9, 0.25, 1]", "[0.9, 0.9]"), HasSubstr("the value 0.9 stands there twice"));
    EXPECT_THAT(with("[0.9, 0.25, 1]", "[{ a = 1 }]"), HasSubstr("a value is a table"));
    EXPECT_THAT(with("kind = \"mesh\"", "kind = \"mash\""),
                HasSubstr("unknown kind 'mash'; did you mean 'mesh'?"));
    EXPECT_THAT(with("key = \"scheme\"", "key = \"model.step.courant\""), HasSubstr("is varied twice"));
    EXPECT_THAT(with("contact.hit.peak_force", "contact.hot.peak_force"), HasSubstr("unknown contact 'hot'"));
    EXPECT_THAT(with("exact = \"= 2*speed\"", "exact = 0"),
                HasSubstr("no error is relative to 0; add 'scale'"));
    EXPECT_THAT(with("tolerance = 0.05", "tolerance = 0"), HasSubstr("'tolerance' is 0; it must be > 0"));
}

TEST(StudyScene, AnElementTakesAwayWhatTheBodySaysForOthers) {
    const std::string text = changed(small_scene, "name = \"rod\"", "name = \"rod\"\nhourglass = 0.05");
    const Scene quads = parse_scene(text, "scene.toml", {"body.rod.element=mean-dilatation quad"});
    EXPECT_EQ(quads.bodies[1].element, ElementKind::quad_mean_dilatation);
    const Scene own = parse_scene(text, "scene.toml", {"body.rod.element=one-point quad"});
    EXPECT_EQ(own.bodies[1].hourglass, 0.05);
    const std::string crossed = changed(small_scene, "name = \"rod\"",
                                        "name = \"rod\"\nelement = \"triangle\"\npattern = \"crossed\"");
    EXPECT_EQ(parse_scene(crossed, "scene.toml", {"body.rod.element=averaged triangle"}).bodies[1].pattern,
              CellPattern::crossed);
    EXPECT_EQ(parse_scene(crossed, "scene.toml", {"body.rod.element=one-point quad"}).bodies[1].pattern,
              CellPattern::quads);
}

TEST(StudyScene, AStarIsSpeltOut) {
    const Scene scene = parse_scene(small_scene, "scene.toml");
    EXPECT_THAT(spell_out("body.*.element=triangle", scene),
                ElementsAre("body.hammer.element=triangle", "body.rod.element=triangle"));
    EXPECT_THAT(spell_out("contact.*.friction=0.1", scene), ElementsAre("contact.hit.friction=0.1"));
    EXPECT_THAT(spell_out("material.*.young=200", scene), ElementsAre("material.steel.young=200"));
    EXPECT_THAT(spell_out("parameters.a=b.*.c", scene), ElementsAre("parameters.a=b.*.c"));
    EXPECT_THAT(spell_out("wall.*.point=1", scene), ElementsAre());
}

}  // namespace
}  // namespace percuss
