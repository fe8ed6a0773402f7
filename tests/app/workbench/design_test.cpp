#include "app/workbench/window_fixture.hpp"

/// The design panel: values of the scene beyond its parameters, what acts at once and what builds anew.
namespace percuss {
namespace {

class DesignWindowTest : public test::WindowTest {
  protected:
    DesignWindowTest() {
        std::string text = test::text_of(path("scene.toml"));
        text.insert(text.find("[units]"), "soft = { value = 0.1, range = [0, 1] }\n");
        text.replace(text.find("velocity = [0.0, \"= -speed\"]"), 28,
                     "velocity = [0.0, \"= -speed\"]\nhourglass = \"= soft\"");
        text.replace(text.find("poisson = 0.3"), 13, "poisson = 0.3\nviscosity = { linear = 0.06 }");
        write("scene.toml", text);
    }
};

constexpr unsigned at_once = 0x009e73;

TEST_F(DesignWindowTest, WhatCanActAtOnceDoesAndGoesBackToTheFile) {
    play(R"(
wait time = 0
frames 3
click "design.material steel"
frames 2
click run.step
wait steps = 1
click material.steel.viscosity.linear 0.9 0.5
wait material.steel.viscosity.linear > 0.4
expect builds = 1
expect steps = 1
click back.material.steel.viscosity.linear
wait material.steel.viscosity.linear = 0.06
expect builds = 1
click parameters.soft 0.8 0.5
wait body.striker.hourglass > 0.7
expect builds = 1
click scheme
click scheme.joint
wait contact_solver.scheme = joint
expect builds = 1
click run.step
wait steps = 2
expect messages = ""
)");
}

TEST_F(DesignWindowTest, AMaterialBuildsAnewAndTheWindowSaysHowLongThatTook) {
    play(R"(
wait time = 0
frames 3
click "design.material steel"
frames 2
expect rebuild.seconds < 30
click run.step
wait steps = 1
drag material.steel.young 0.5 0.5 0.9 0.5
wait builds > 1
wait building = 0
expect material.steel.young > 210
wait status = finished
frames 3
expect rebuild.seconds < 30
expect rebuild.seconds > 0
expect engine.speed > 0
expect fps > 0
expect frame.seconds > 0
expect frame.seconds < 10
click back.material.steel.young
wait material.steel.young = 210
)",
         {"--set", "model.duration=20"});
}

TEST_F(DesignWindowTest, ADoubleClickTypesAValue) {
    play(R"(
wait time = 0
frames 3
double-click parameters.speed 0.5 0.5
frames 2
key Ctrl+A
type 3.25
key Enter
wait parameters.speed = 3.25
wait building = 0
click "design.material steel"
frames 2
double-click material.steel.young
frames 2
key Ctrl+A
type 180
key Enter
wait material.steel.young = 180
expect messages = ""
)");
}

TEST_F(DesignWindowTest, MarksSayWhatTheyTake) {
    play(R"(
wait time = 0
frames 3
frames 2
widgets
screenshot marks.png
)");
    // A dot before the name of what acts at once, none before the other.
    widgets_["soft"] = widgets_["label.parameters.soft"];
    widgets_["soft"][0] -= 24;
    widgets_["speed"] = widgets_["label.parameters.speed"];
    widgets_["speed"][0] -= 24;
    EXPECT_GT(count("marks.png", "soft", at_once), 10);
    EXPECT_EQ(count("marks.png", "speed", at_once), 0);
}

TEST_F(DesignWindowTest, TheTimeSpentNamesTheEffectsThatAreOn) {
    play(R"(
wait time = 0
frames 3
do run.toggle
wait status = finished
click header.picture
frames 2
click header.time-spent
frames 3
widgets
)");
    EXPECT_TRUE(widgets_.contains("time-spent.contact solve"));
    EXPECT_TRUE(widgets_.contains("time-spent.bulk viscosity"));
    EXPECT_FALSE(widgets_.contains("time-spent.probes"));
    EXPECT_FALSE(widgets_.contains("time-spent.body force"));
}

}  // namespace
}  // namespace percuss
