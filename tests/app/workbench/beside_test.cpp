#include "app/workbench/window_fixture.hpp"

/// Runs beside each other: one clock, a picture and a curve for each.
namespace percuss {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class BesideWindowTest : public test::WindowTest {};

TEST_F(BesideWindowTest, TheyShareTheClockOfTheRunThatIsShown) {
    play(R"(
wait time = 0
frames 3
expect beside = 1
expect beside.label = "speed 2"
expect beside.newest = 0
click run.step
wait steps = 1
wait beside.newest > 0
wait beside.busy = 0
frames 5
expect beside.newest < 0.001
do run.toggle
wait status = finished
wait beside.busy = 0
frames 2
expect time > 0.02
expect beside.time > 0.0199
expect beside.rows > 100
widgets
screenshot both.png
click time.slider 0.5 0.5
wait time < 0.012
frames 3
expect beside.time < 0.012
expect beside.time > 0.008
expect beside.faults = ""
do compare.clear
frames 2
expect beside = 0
)",
         {"--beside", "parameters.speed=2"});
    ASSERT_TRUE(widgets_.contains("viewport.beside.1"));
    const Place own = widgets_["viewport"], other = widgets_["viewport.beside.1"];
    EXPECT_GE(other[1], own[3] - 1) << "above each other in a narrow viewport";
    EXPECT_NEAR(other[3] - other[1], own[3] - own[1], 6);
}

TEST_F(BesideWindowTest, TheSameDesignHasTheSamePicture) {
    fs::copy_file(fs::path(PERCUSS_SOURCE_DIR) / "scenes/rods.toml", path("scene.toml"),
                  fs::copy_options::overwrite_existing);
    play(R"(
wait time = 0
until 0.03
do run.until
wait time >= 0.03
wait status = paused
wait beside.busy = 0
do view.fit
move run.toggle
frames 3
widgets
screenshot both.png
)",
         {"--beside", "view.edges=true"});
    const render::Image image = render::read_png(path("both.png"));
    const Place own = widgets_["viewport"], other = widgets_["viewport.beside.1"];
    const auto drawn = [&](const Place& place) {
        int count = 0;
        for (int y = place[1] + 40; y < place[3]; ++y)  // beneath the labels in the corners
            for (int x = place[0] + 2; x < place[2] - 2; ++x)
                count += image.pixels[3 * (static_cast<std::size_t>(y) * image.width + x)] < 240;
        return count;
    };
    EXPECT_GT(drawn(own), 10000);
    EXPECT_NEAR(drawn(other), drawn(own), 0.05 * drawn(own)) << "both halves of both";
}

TEST_F(BesideWindowTest, ADesignStaysBesideWhileTheOtherIsChanged) {
    play(R"(
wait time = 0
frames 3
do compare.add
wait beside.newest = 0
expect beside.label = projection
click parameters.speed 0.8 0.5
wait builds = 2
frames 3
expect parameters.speed > 3
do run.toggle
wait status = finished
wait beside.busy = 0
expect beside = 1
expect beside.newest > 0.0199
)");
}

TEST_F(BesideWindowTest, AFaultyOneIsRefusedAtTheStart) {
    write("script.txt", "frames 1\n");
    const auto complaint = [&](const std::string& wanted) {
        const test::Outcome outcome =
            run({"view", "scene.toml", "--headless", "--script", "script.txt", "--beside", wanted});
        EXPECT_EQ(outcome.status, 2);
        return outcome.err;
    };
    EXPECT_THAT(complaint("scheme=joined"), HasSubstr("unknown scheme 'joined'; did you mean 'joint'?"));
    EXPECT_THAT(complaint("parameters.sped=2"), HasSubstr("did you mean 'speed'?"));
    EXPECT_THAT(complaint("speed"), HasSubstr("write scheme=NAME or KEY=VALUE"));
}

}  // namespace
}  // namespace percuss
