#include "run/design_values.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/scene/small_scene.hpp"
#include "scene/expressions.hpp"
#include "scene/parse.hpp"

namespace percuss {
namespace {

using percuss::testing::changed;
using percuss::testing::small_scene;

const DesignValue* find(const std::vector<DesignValue>& values, const std::string& key) {
    const auto found =
        std::find_if(values.begin(), values.end(), [&](const DesignValue& v) { return v.key == key; });
    return found == values.end() ? nullptr : &*found;
}

TEST(DesignValues, CanBeSetByTheirKeysAndHaveTheEffectThatTheySay) {
    for (const char* name : {"nail", "rods", "taylor", "sliding_block"}) {
        const std::string file = fmt::format(PERCUSS_SOURCE_DIR "/scenes/{}.toml", name);
        const Scene scene = load_scene(file);
        const auto values = design_values(scene);
        ASSERT_GT(values.size(), 5U) << name;
        int at_once = 0;
        for (const DesignValue& value : values) {
            if (!value.expression.empty() || !value.choices.empty()) continue;
            double other = value.number != 0 ? 0.995 * value.number : 0.01;
            if (value.range) other = std::clamp(other, (*value.range)[0], (*value.range)[1]);
            if (other == value.number) other = 0.5 * ((*value.range)[0] + (*value.range)[1]);
            const std::string set = fmt::format("{}={:.17g}", value.key, other);
            Scene varied;
            try {
                varied = load_scene(file, {set});
            } catch (const SceneError&) {
                EXPECT_EQ(value.group, "parameters") << set;  // a figure's time may fall out of the run
                continue;
            }
            EXPECT_EQ(find(design_values(varied), value.key)->number, other) << name << ": " << set;
            const ChangeEffect effect = effect_of_change(scene, varied);
            // The geometry of a scene may hide a small change of a parameter: rounded cell counts.
            EXPECT_LE(effect, value.effect) << name << ": " << set;
            if (value.group != "parameters") {
                EXPECT_EQ(effect, value.effect) << name << ": " << set;
            }
            at_once += effect == ChangeEffect::next_step;
        }
        EXPECT_GT(at_once, 0) << name;
    }
}

TEST(DesignValues, AreThoseThatTheSceneCallsFor) {
    const auto values = design_values(parse_scene(small_scene, "s"));
    EXPECT_EQ(find(values, "material.steel.young")->number, 210);
    EXPECT_EQ(find(values, "material.steel.young")->unit, "GPa");
    EXPECT_EQ(find(values, "material.steel.young")->group, "material steel");
    EXPECT_EQ(find(values, "material.steel.young")->effect, ChangeEffect::rebuild);
    EXPECT_EQ(find(values, "body.rod.hourglass")->effect, ChangeEffect::next_step);
    EXPECT_EQ(find(values, "body.hammer.velocity.1")->number, 10);
    EXPECT_EQ(find(values, "contact_solver.scheme")->choice, "projection");
    for (const char* absent : {"material.steel.viscosity.linear", "material.steel.plastic.yield",
                               "body.rod.velocity.1", "body.rod.body_force.1", "contact.hit.friction",
                               "contact_solver.recovery_speed", "model.step.fixed"})
        EXPECT_EQ(find(values, absent), nullptr) << absent;
}

TEST(DesignValues, SayWhatFollowsFromParametersAndWhatThoseTake) {
    const std::string text =
        changed(changed(changed(small_scene, "young = 210", "young = \"= 2*half\""), "name = \"rod\"",
                        "name = \"rod\"\nhourglass = \"= third\""),
                "[model]",
                "[parameters]\nhalf = 105\nsoft = { value = 0.3, range = [0, 1], unit = \"-\" }\n"
                "third = \"= soft/3\"\nidle = 3\n[model]");
    const auto values = design_values(parse_scene(text, "s"));
    EXPECT_EQ(values.front().key, "parameters.half");
    EXPECT_EQ(find(values, "material.steel.young")->expression, "= 2*half");
    EXPECT_EQ(find(values, "material.steel.young")->number, 210);
    EXPECT_EQ(find(values, "parameters.half")->effect, ChangeEffect::rebuild);
    EXPECT_EQ(find(values, "parameters.soft")->effect, ChangeEffect::next_step) << "by way of third";
    EXPECT_EQ(find(values, "parameters.third")->expression, "= soft/3");
    EXPECT_EQ(find(values, "parameters.idle")->effect, ChangeEffect::none);
    EXPECT_EQ((*find(values, "parameters.soft")->range)[1], 1);

    // A number given in the place of an expression is a value of its own.
    const auto set = design_values(parse_scene(text, "s", {"material.steel.young=200"}));
    EXPECT_EQ(find(set, "material.steel.young")->expression, "");
    EXPECT_EQ(find(set, "parameters.half")->effect, ChangeEffect::none);
}

TEST(Expressions, HaveKeysByWhichTheyAreSet) {
    const auto found = expressions_in(load_scene(PERCUSS_SOURCE_DIR "/scenes/nail.toml"));
    EXPECT_EQ(found.at("parameters.tip_z"), "= nail_z + tip");
    EXPECT_EQ(found.at("parameters.nail_z"), "= sheets_top - 0.05");
    EXPECT_EQ(found.at("body.nail.velocity.1"), "= -piston_speed");
    EXPECT_EQ(found.at("material.substrate-steel.plastic.yield"), "= substrate_yield");
    EXPECT_FALSE(found.contains("parameters.shank"));
}

}  // namespace
}  // namespace percuss
