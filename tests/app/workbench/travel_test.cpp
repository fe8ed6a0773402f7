#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/workbench/window_fixture.hpp"

/// Looking back, branches, speed, recorded runs, ghosts and failures, as the window's user meets them.
namespace percuss {
namespace {

using test::Outcome;
using test::WindowTest;
using testing::HasSubstr;

constexpr unsigned shown_moment = 0xe02020, ghost = 0x9aa0a8, reference_outline = 0x3aa0ff;

TEST_F(WindowTest, TheSliderLooksBackAndTheButtonReturns) {
    play(R"(
wait time = 0
do run.toggle
wait status = finished
frames 2
widgets
screenshot live.png
drag time.slider 0.97 0.5 0.5 0.5
expect live = 0
expect time > 0.0085
expect time < 0.0115
expect newest >= 0.02
expect status = finished
frames 2
screenshot back.png
key Left
key Left
key Left
key Right
key Left
key Left
wait time < 0.0098
click time.live
expect live = 1
wait time >= 0.02
drag time.slider 0.97 0.5 0.2 0.5
expect live = 0
key End
expect live = 1
frames 2
screenshot again.png
)");
    EXPECT_GT(count("back.png", "plots.forces.y", shown_moment), 50) << "the moment is marked in the plots";
    EXPECT_EQ(count("live.png", "plots.forces.y", shown_moment), 0);
    EXPECT_EQ(count("again.png", "plots.forces.y", shown_moment), 0);
}

TEST_F(WindowTest, TheRunGoesOnWhileOneLooksBack) {
    play(R"(
wait time = 0
click run.speed
type 4
key Enter
expect speed.wanted = 0.004
do run.toggle
wait time > 0.003
drag time.slider 0.9 0.5 0.3 0.5
expect live = 0
expect time < 0.003
wait newest > 0.006
expect time < 0.003
expect status = running
wait speed > 0
expect speed < 0.006
do run.toggle             # plays what is looked back at
wait playing = 1
do run.toggle
wait playing = 0
do time.live
expect status = running
click run.speed
key Ctrl+A
key Delete
key Enter
expect speed.wanted = 0
wait status = finished
)");
}

TEST_F(WindowTest, TheSpeedIsChosenByASlider) {
    play(R"(
wait time = 0
click run.speeds 0.25 0.5
expect speed.wanted > 0.00005
expect speed.wanted < 0.0003
click run.speeds 0.75 0.5
expect speed.wanted > 0.008
expect speed.wanted < 0.04
do run.full-speed
expect speed.wanted = 0
click run.speed
type none
key Enter
expect speed.wanted = 0
)");
}

TEST_F(WindowTest, ABranchIsAskedForBeforeAnythingIsDropped) {
    play(R"(
wait time = 0
do run.toggle
wait status = finished
drag time.slider 0.97 0.5 0.5 0.5
click time.branch
wait branch.from > 0.0085
expect branch.from < 0.0115
expect branch.to >= 0.02
frames 2
widgets
click time.branch-cancel
expect branch.asked = 0
expect live = 0
expect end >= 0.02
wait time > 0.008
click run.speed
type 4
key Enter
click time.branch
wait branch.to >= 0.02
click time.branch-confirm
wait live = 1
wait status = running
expect time < 0.015
expect end < 0.015
do run.full-speed
wait status = finished
expect messages = ""
)");
}

TEST_F(WindowTest, RecordedRunsArePlayed) {
    ASSERT_EQ(run({"run", "scene.toml", "--out", "out", "--no-render"}).status, 0);
    for (const char* argument : {"out", "out/run.h5"}) {
        write("script.txt", R"(
wait recorded = 1
expect time = 0
expect live = 0
expect rows > 100
expect moments > 3
frames 2
widgets
screenshot recorded.png
click time.slider 0.5 0.5
wait time > 0.008
expect time < 0.011
key Left
key Left
key Left
wait time < 0.0098
key End
wait time >= 0.02
click run.speed
type 20
key Enter
key Space
wait playing = 1
wait time < 0.015
wait playing = 0
expect time >= 0.02
key R
wait time = 0
set parameters.speed 2
expect messages contains recorded
click messages.dismiss
open scene.toml
wait recorded = 0
wait live = 1
open out
wait recorded = 1
expect builds = 3
)");
        const Outcome outcome = run({"view", argument, "--headless", "--script", "script.txt"});
        EXPECT_EQ(outcome.status, 0) << outcome.err;
    }
    EXPECT_EQ(run({"view", "nowhere.h5", "--headless", "--script", "script.txt"}).status, 2);
    const Outcome set =
        run({"view", "out", "--set", "parameters.speed=2", "--headless", "--script", "script.txt"});
    EXPECT_EQ(set.status, 2);
    EXPECT_THAT(set.err, HasSubstr("--set is for scenes"));
    write("damaged.h5", "no HDF5 at all");
    play(
        "wait time = 0\nopen damaged.h5\nwait messages contains damaged.h5\nexpect title = \"two blocks\"\n");
}

TEST_F(WindowTest, TheReferenceIsShownAtTheSameTime) {
    play(R"(
wait time = 0
do run.toggle
wait status = finished
widgets
key B
set parameters.speed 4
wait builds = 2
wait status = finished
expect ghost = 0            # the reference shows it
drag time.slider 0.97 0.5 0.3 0.5
expect time > 0.0045
expect time < 0.0075
frames 2
expect reference.time > 0.0045
expect reference.time < 0.0075
screenshot early.png
key End
frames 2
expect reference.time >= 0.0199
screenshot late.png
)");
    EXPECT_GT(count("early.png", "viewport", reference_outline), 100);
    EXPECT_GT(count("late.png", "viewport", reference_outline), 100);
}

TEST_F(WindowTest, TheDesignBeforeStaysAsAGhostUntilTheNewOneHasComeAsFar) {
    write("other.toml", test::small_scene);
    play(R"(
wait time = 0
do run.toggle
wait status = finished
widgets
click run.speed
type 5
key Enter
set parameters.speed 4
wait builds = 2
expect ghost = 1
expect ghost.time >= 0.02
wait time > 0.001
set parameters.speed 3      # a run that got nowhere leaves the ghost as it was
wait builds = 3
expect ghost.time >= 0.02
do run.full-speed
wait status = finished
expect ghost = 0
click run.speed
type 5
key Enter
set parameters.speed 1
wait builds = 4
expect ghost = 1
wait status = running
do run.toggle
wait status = paused
frames 2
screenshot ghost.png
do view.drop-ghost
expect ghost = 0
frames 2
screenshot dropped.png
do run.toggle
set parameters.speed 2
wait builds = 5
wait time > 0
open other.toml             # not a design of the same scene
wait builds = 6
expect ghost = 0
)");
    EXPECT_GT(count("ghost.png", "viewport", ghost), count("dropped.png", "viewport", ghost) + 200);
}

TEST_F(WindowTest, OneClickFramesTheElementThatFailed) {
    std::string fine = test::text_of(path("scene.toml"));
    fine.replace(fine.find("divisions = [2, 1]"), 18, "divisions = [24, 12]");
    write("scene.toml", fine);
    const std::vector<std::string> fragile{"--set", "model.lagged=true", "--set",
                                           "model.energy_growth_limit=1e-6"};
    std::vector<std::string> record{"run", "scene.toml", "--out", "broken", "--no-render"};
    record.insert(record.end(), fragile.begin(), fragile.end());
    EXPECT_NE(run(record).status, 0);
    play(R"(
wait time = 0
widgets
expect failed-element = -1
do run.toggle
wait status = diverged
expect failed-element >= 0
frames 2
expect zoom < 250
screenshot all.png
click view.failure
frames 2
expect zoom > 500
screenshot near.png
move viewport 0.5 0.44
frames 2
expect hovered != nothing
open broken                 # the record knows it, too
wait recorded = 1
expect failed-element = -1
key End
wait status = diverged
expect failed-element >= 0
)",
         fragile);
    EXPECT_GT(count("near.png", "viewport", shown_moment), count("all.png", "viewport", shown_moment) + 50)
        << "the element has a red rim";
}

}  // namespace
}  // namespace percuss
