#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/workbench/window_fixture.hpp"

/// What is marked in the picture and done at its places, by scripts on OSMesa.
namespace percuss {
namespace {

constexpr unsigned master_ink = 0xd1135b, slave_ink = 0xf08a24, probe_ink = 0x000000, first_curve = 0x0072b2;

class ViewportTest : public test::WindowTest {
  protected:
    /// Pixels of the arrows' colours that are not the legend's: what two pictures differ by.
    [[nodiscard]] int more(const char* now, const char* before, unsigned colour) const {
        return count(now, "viewport", colour) - count(before, "viewport", colour);
    }
};

TEST_F(ViewportTest, PairsAreMarkedByChoiceAndByPointing) {
    play(R"(
wait time = 0
frames 3
widgets
screenshot none.png
expect pairs.marked = none
key S
frames 2
expect pairs.marked = all
screenshot all.png
key S
frames 2
expect pairs.marked = none
click view.pairs
frames 2
click view.pairs.impact
move run.toggle
frames 2
expect pairs.marked = impact
screenshot one.png
click view.pairs
frames 2
click view.pairs.none
frames 1
move "plots.forces.y/impact"
frames 2
expect pairs.marked = impact
screenshot pointed.png
move run.toggle
frames 2
expect pairs.marked = none
screenshot again.png
)");
    for (const char* marked : {"all.png", "one.png", "pointed.png"}) {
        EXPECT_GT(more(marked, "none.png", master_ink), 40) << marked;
        EXPECT_GT(more(marked, "none.png", slave_ink), 300) << marked;
    }
    EXPECT_EQ(more("again.png", "none.png", master_ink), 0);
}

TEST_F(ViewportTest, ArrowsHaveThreeScalesAndACutOff) {
    play(R"(
wait time = 0
until 0.0003
do run.until
wait time >= 0.0003
wait status = paused
frames 2
widgets
expect arrows = automatic
screenshot automatic.png
click view.arrows
frames 2
click view.arrows.fixed
frames 2
expect arrows = fixed
expect arrows.reference > 0
click view.arrows.reference
key Ctrl+A
type 1e6
key Enter
frames 2
screenshot weak.png
click view.arrows
frames 2
click view.arrows.logarithmic
frames 2
expect arrows = logarithmic
screenshot logarithmic.png
click view.arrows
frames 2
click view.arrows.automatic
move run.toggle
frames 2
screenshot back.png
)");
    EXPECT_LT(more("weak.png", "automatic.png", master_ink), -100)
        << "forces far below the reference are not drawn";
    EXPECT_GT(more("logarithmic.png", "weak.png", master_ink), 100);
    EXPECT_EQ(more("back.png", "automatic.png", master_ink), 0);
}

TEST_F(ViewportTest, AProbeOfARecordedRunHasACurveOverItsFrames) {
    ASSERT_EQ(run({"run", "scene.toml", "--out", "out", "--no-render"}).status, 0);
    write("script.txt", R"(
wait recorded = 1
frames 3
right-click viewport 0.5 0.4
frames 3
click viewport.menu.probe
wait probes = 1
wait probe.rows = 101
expect moments = 101
frames 3
click plots.probes.von_mises.menu
frames 2
click plots.probes.von_mises.menu.csv
wait export.written contains probes
click probes.p1.remove
wait probes = 0
frames 2
right-click viewport 0.5 0.4
frames 3
click viewport.menu.fields
frames 3
click viewport.menu.fields.velocity.y
wait probe.rows = 101
frames 2
move plots.probes.velocity.y 0.5 0.5
)");
    const auto outcome = run({"view", "out", "--headless", "--script", "script.txt"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    const std::string csv = test::text_of(path("out-probes.von_mises.csv"));
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 102);
    EXPECT_NE(csv.find("probe.p1"), std::string::npos);
}

TEST_F(ViewportTest, AClickOpensAMenuThatPutsAProbe) {
    play(R"(
wait time = 0
frames 3
widgets
screenshot before.png
click run.step
wait steps = 1
click viewport 0.5 0.4
wait probes = 0
frames 30
click viewport.menu.probe
wait probes = 1
wait probe.rows > 0
until 0.001
do run.until
wait time >= 0.001
wait status = paused
move run.toggle
frames 2
widgets
screenshot probe.png
expect probe.rows > 5
right-click viewport 0.5 0.6
frames 2
move viewport.menu.fields
frames 30
click viewport.menu.fields.velocity.y
wait probes = 2
move run.toggle
frames 2
screenshot two.png
do probe.copy
move probes.p1
frames 2
key R
wait steps = 0
do run.until
wait time >= 0.001
wait status = paused
expect probes = 2
click probes.p1.remove
wait probes = 1
do probe.clear
wait probes = 0
move run.toggle
wait steps >= 0
frames 2
screenshot none.png
)");
    EXPECT_GT(more("probe.png", "before.png", probe_ink), 25);
    EXPECT_GT(more("two.png", "probe.png", probe_ink), 25);
    EXPECT_EQ(more("none.png", "before.png", probe_ink), 0);
    EXPECT_GT(count("probe.png", "plots.probes.von_mises", first_curve), 20);
}

TEST_F(ViewportTest, ADoubleClickIsNoClick) {
    play(R"(
wait time = 0
frames 3
double-click viewport 0.5 0.4
frames 40
widgets
key P
wait probes = 1
move run.toggle
key P
frames 2
expect probes = 1
)");
    EXPECT_EQ(widgets_.count("viewport.menu.view.fit"), 0U);
    EXPECT_EQ(widgets_.count("viewport.menu.probe"), 0U);
}

TEST_F(ViewportTest, ThePictureFollowsANode) {
    play(R"(
wait time = 0
frames 3
set parameters.speed 5
wait builds = 2
frames 2
wheel viewport 4 0.5 0.4
move viewport 0.5 0.4
frames 2
key N
expect following = 1
expect centre.y > 0.055
until 0.01
do run.until
wait time >= 0.01
wait status = paused
frames 3
expect centre.y < 0.05
drag viewport 0.5 0.5 0.5 0.7
frames 2
expect following = 1
set parameters.speed 4
wait builds = 3
wait status = finished
frames 2
expect following = 1
key F
frames 2
expect following = 0
)");
}

TEST_F(ViewportTest, TheChatterMeterCountsEvents) {
    play(R"(
wait time = 0
do run.toggle
wait status = finished
frames 2
widgets
click plots.events.title
move run.toggle
frames 2
widgets
screenshot events.png
move plots.events 0.2 0.5
frames 2
screenshot told.png
)");
    EXPECT_GT(count("events.png", "plots.events", first_curve), 20);
}

}  // namespace
}  // namespace percuss
