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

const std::string lesson = R"([lesson]
title = "Hit"
text = """
One line
and another."""
question = "Why?"
control = "scheme"
look_for = "the force"
answer = "so"
compare = { schemes = ["lagged", "joint"], steps = [0.5, 0.9] }
)";

TEST(LessonScene, ReadsALesson) {
    const Scene scene = parse_scene(small_scene + lesson, "scene.toml");
    ASSERT_TRUE(scene.lesson);
    EXPECT_EQ(scene.lesson->text, "One line\nand another.");
    EXPECT_EQ(scene.lesson->control, "scheme");
    ASSERT_TRUE(scene.lesson->compare);
    EXPECT_THAT(scene.lesson->compare->schemes, ElementsAre("lagged", "joint"));
    EXPECT_THAT(scene.lesson->compare->steps, ElementsAre(0.5, 0.9));
    EXPECT_FALSE(parse_scene(small_scene, "scene.toml").lesson);
}

TEST(LessonScene, TheControlMustExist) {
    const std::string parameters = "[parameters]\nspeed = 1\ntwice = \"= 2*speed\"\n";
    const auto with = [&](const std::string& control) {
        return faults_of(small_scene + parameters +
                         changed(lesson, "control = \"scheme\"", "control = \"" + control + "\""));
    };
    EXPECT_EQ(with("parameters.speed"), "");
    EXPECT_EQ(with("model.step.courant"), "");
    EXPECT_THAT(with("parameters.sped"),
                HasSubstr("there is no control 'parameters.sped'; did you mean 'parameters.speed'?"));
    EXPECT_THAT(with("parameters.twice"), HasSubstr("there is no control 'parameters.twice'"));
    EXPECT_THAT(with("model.step.fixed"), HasSubstr("valid: scheme, model.step.courant, parameters.speed"));
}

TEST(LessonScene, TheFigureNamesSchemesThatExist) {
    EXPECT_THAT(faults_of(small_scene + changed(lesson, "\"lagged\"", "\"laged\"")),
                HasSubstr("unknown scheme 'laged'; did you mean 'lagged'?"));
    EXPECT_THAT(faults_of(small_scene + changed(lesson, "steps = [0.5, 0.9]", "steps = [1.5]")),
                HasSubstr("'steps[0]' is 1.5"));
    EXPECT_THAT(faults_of(small_scene + changed(lesson, "steps = [0.5, 0.9]", "values = [1]")),
                HasSubstr("'values' are those of a parameter"));
    EXPECT_THAT(faults_of(small_scene + changed(lesson, "question = \"Why?\"\n", "")), HasSubstr("question"));
}

TEST(LessonScene, NoRunReadsIt) {
    const Scene scene = parse_scene(small_scene, "scene.toml"),
                taught = parse_scene(small_scene + lesson, "scene.toml");
    EXPECT_EQ(effect_of_change(scene, taught), ChangeEffect::none);
}

const SchemeChoice& choice(const std::vector<SchemeChoice>& choices, const std::string& name) {
    for (const SchemeChoice& each : choices)
        if (each.name == name) return each;
    throw std::runtime_error(name);
}

TEST(NamedSchemes, EveryOneIsKnownByItsNameAfterItWasSet) {
    for (const NamedScheme& first : named_schemes())
        for (const NamedScheme& second : named_schemes()) {
            const Scene plain = parse_scene(small_scene, "scene.toml");
            std::vector<std::string> overrides = scheme_overrides(first, plain);
            for (const std::string& setting : scheme_overrides(second, plain)) overrides.push_back(setting);
            const auto choices = scheme_choices(parse_scene(small_scene, "scene.toml", overrides));
            for (const SchemeChoice& each : choices) {
                EXPECT_EQ(each.present, each.name == second.name) << first.name << ", then " << second.name;
                EXPECT_EQ(each.fault, "");
            }
        }
}

TEST(NamedSchemes, TellWhichASceneCannotTake) {
    const Scene scene =
        parse_scene(small_scene, "scene.toml", {"contact_solver.scheme=joint", "contact.hit.friction=0.3"});
    const auto choices = scheme_choices(scene);
    EXPECT_TRUE(choice(choices, "joint").present);
    EXPECT_THAT(choice(choices, "projection").fault, HasSubstr("knows no friction"));
}

TEST(NamedSchemes, TellWithWhichARunGoesOn) {
    const auto goes_on = [](const char* from, const char* to) {
        const Scene plain = parse_scene(small_scene, "scene.toml");
        const Scene scene =
            parse_scene(small_scene, "scene.toml", scheme_overrides(*find_scheme(from), plain));
        return choice(scheme_choices(scene), to).goes_on;
    };
    EXPECT_TRUE(goes_on("projection", "joint"));
    EXPECT_FALSE(goes_on("symmetric", "penalty")) << "springs would come in with energy";
    EXPECT_FALSE(goes_on("symmetric", "massless")) << "nodes lose their mass at the start";
    EXPECT_FALSE(goes_on("joint", "symmetric")) << "other contact rows";
    EXPECT_FALSE(goes_on("symmetric", "velocity")) << "another level";
    EXPECT_FALSE(goes_on("lagged", "projection"));
}

}  // namespace
}  // namespace percuss
