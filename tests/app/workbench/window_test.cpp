#include "app/workbench/window_fixture.hpp"

#include <algorithm>
#include <cstdlib>
#include <set>
#include <thread>

#include "app/workbench/window_fixture.hpp"
#include "workbench/command_table.hpp"

namespace percuss {
namespace {

using test::Outcome;
using test::WindowTest;
using testing::HasSubstr;

constexpr unsigned master_ink = 0xd1135b, first_curve = 0x0072b2, refusal = 0xffedeb,
                   viridis_middle = 0x21918c;  // of a field that is the same everywhere

TEST_F(WindowTest, ShowsMeshForcesAndCurvesOfTheRun) {
    play(R"(
wait time = 0
frames 2
widgets
screenshot start.png
until 0.0003
do run.until
wait time >= 0.0003
wait status = paused
frames 2
expect time >= 0.0003
expect time < 0.0005
expect contacts > 0
screenshot contact.png
click view.forces
expect forces = 0
frames 1
screenshot plain.png
click "plots.forces.y/impact"
frames 1
screenshot hidden.png
)");
    EXPECT_GT(count("start.png", "viewport", viridis_middle), 20000) << "nothing is stressed yet";
    // The legend alone writes "master" in the arrows' colour.
    EXPECT_GT(count("contact.png", "viewport", master_ink), count("start.png", "viewport", master_ink) + 100);
    EXPECT_EQ(count("plain.png", "viewport", master_ink), 0);
    EXPECT_GT(count("contact.png", "viewport", 0xfde725), 100)
        << "the highest colour of viridis: range = data";
    EXPECT_EQ(count("start.png", "plots.forces.y", first_curve), 0);
    EXPECT_GT(count("plain.png", "plots.forces.y", first_curve), 40);
    EXPECT_EQ(count("hidden.png", "plots.forces.y", first_curve), 0)
        << "its name in the legend hides a curve";
}

TEST_F(WindowTest, ButtonsAndKeysReachTheEngine) {
    play(R"(
wait time = 0
click run.step
wait steps = 1
key Right
wait steps = 2
click run.step-count
key Ctrl+A
type 30
key Enter
click run.steps
wait steps = 32
key Space
wait status = finished
expect time >= 0.02
key R
wait steps = 0
key Space
wait status = finished
key Space
wait steps > 0
)");
}

TEST_F(WindowTest, EveryCommandCanBeDone) {
    std::string script = "wait time = 0\n";
    for (const app::WorkbenchCommand& command : app::workbench_commands())
        if (command.name != "quit") script += "do " + command.name + "\nframes 3\n";
    script += "expect messages = \"\"\nframes 4\nwait building = 0\nexpect panels = 0\nexpect help = 1\n";
    play(script);
    const auto left = files(".");
    EXPECT_TRUE(std::any_of(left.begin(), left.end(), [](const std::string& name) {
        return name.starts_with("percuss-") && name.ends_with(".png");
    })) << "window.screenshot left no picture";
}

TEST_F(WindowTest, ASliderBuildsTheRunAnew) {
    play(R"(
wait time = 0
expect parameters.speed = 1
click run.step
wait steps = 1
click parameters.speed 0.8 0.5
wait builds = 2
wait parameters.speed > 3.5
expect parameters.speed < 4.5
wait status = finished
right-click label.parameters.speed
wait parameters.speed = 1
drag parameters.speed 0.2 0.5 0.5 0.5
wait parameters.speed > 2
wait building = 0
click scene.file-values
wait parameters.speed = 1
)");
}

TEST_F(WindowTest, ABadSceneKeepsTheOldOneAndSaysWhere) {
    write("binary.toml", std::string("\x7f"
                                     "ELF\0\1\2\xff",
                                     8));
    std::string one = test::small_scene;  // one body, no contact
    one.replace(one.find("two blocks"), 10, "one");
    const auto anvil = one.find("[[body]]\nname = \"anvil\"");
    one.erase(anvil, one.find("[expect]") - anvil);
    write("one.toml", one);
    play(R"(
wait time = 0
click run.step
wait steps = 1
open bad.toml
wait messages contains bad.toml:14:
expect title = "two blocks"
expect steps = 1
frames 2
widgets
screenshot refused.png
click run.step
wait steps = 2
click messages.dismiss
expect messages = ""
frames 1
screenshot dismissed.png
open .
wait messages != ""
click messages.dismiss
open binary.toml
wait messages contains binary.toml
open one.toml
wait title = one
do run.toggle
wait status = finished
expect messages = ""
open scene.toml
wait builds = 3
)");
    EXPECT_GT(count("refused.png", "messages", refusal), 2000);
    EXPECT_LT(count("dismissed.png", "messages", refusal), 200);
}

TEST_F(WindowTest, AReferenceLiesBeneathTheNextDesign) {
    play(R"(
wait time = 0
widgets
until 0.006
do run.until
wait time >= 0.006
wait status = paused
key B
expect reference = 1
frames 2
screenshot same.png
set parameters.speed 4
wait builds = 2
wait status = finished
click header.reference
frames 3
screenshot compared.png
key B
frames 2
expect reference = 0
screenshot dropped.png
)");
    constexpr unsigned ghost = 0x3aa0ff;
    EXPECT_EQ(count("same.png", "viewport", ghost), 0) << "the present run is its own reference";
    EXPECT_GT(count("compared.png", "viewport", ghost), 200);
    EXPECT_EQ(count("dropped.png", "viewport", ghost), 0);
}

TEST_F(WindowTest, NavigationMovesAndZoomsThePicture) {
    play(R"(
wait time = 0
frames 2
widgets
screenshot all.png
move viewport 0.5 0.4
frames 2
expect hovered = striker
wheel viewport 3 0.5 0.4
frames 2
expect hovered = striker
move run.toggle
frames 2
screenshot near.png
drag viewport 0.5 0.4 0.9 0.4
frames 2
screenshot moved.png
key F
frames 2
move run.toggle
frames 2
screenshot again.png
)");
    const int all = count("all.png", "viewport", viridis_middle);
    EXPECT_GT(count("near.png", "viewport", viridis_middle), 1.2 * all);
    EXPECT_NE(count("moved.png", "viewport", viridis_middle), count("near.png", "viewport", viridis_middle));
    EXPECT_EQ(count("again.png", "viewport", viridis_middle), all);
}

TEST_F(WindowTest, FieldRangeAndColoursAreChosenByLists) {
    play(R"(
wait time = 0
until 0.0003
do run.until
wait time >= 0.0003
wait status = paused
click view.field
click view.field.velocity.y
frames 2
expect field = velocity.y
expect range.low < 0
click view.range.fixed
frames 1
click view.colours
click view.colours.coolwarm
frames 2
expect colours = coolwarm
click view.zoom-to
click view.zoom-to.anvil
frames 2
move viewport 0.5 0.4
frames 2
expect hovered = anvil
)");
}

TEST_F(WindowTest, AChangedFileIsReadByItself) {
    write("script.txt", "wait time = 0\nscreenshot ready.png\nwait title = changed\n");
    test::Program program(folder_.path(), {"view", "scene.toml", "--headless", "--script", "script.txt"});
    for (int i = 0; i < 2000 && !exists("ready.png"); ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    std::string text = test::text_of(path("scene.toml"));
    text.replace(text.find("two blocks"), 10, "changed");
    write("scene.toml", text);
    std::filesystem::last_write_time(path("scene.toml"),
                                     std::filesystem::file_time_type::clock::now() + std::chrono::seconds(2));
    const Outcome outcome = program.wait();
    EXPECT_EQ(outcome.status, 0) << outcome.err;
}

TEST_F(WindowTest, LargeTextDarkPanelsAndOddSizesStand) {
    for (const auto& more : std::vector<std::vector<std::string>>{{"--size", "1920x1080", "--scale", "200"},
                                                                  {"--size", "320x200"},
                                                                  {"--size", "640x480", "--dark"}})
        play("wait time = 0\nframes 3\ndo run.toggle\nwait status = finished\nframes 2\nscreenshot a.png\n",
             more);
}

TEST_F(WindowTest, SaysWhatIsWrong) {
    write("script.txt", "wait time = 0\nexpect steps = 3\n");
    const Outcome broken = run({"view", "scene.toml", "--headless", "--script", "script.txt"});
    EXPECT_EQ(broken.status, 1);
    EXPECT_EQ(broken.err, "percuss: script.txt:2: expected steps = 3; it is 0\n");
    const Outcome no_display = run({"view", "scene.toml"});
    EXPECT_EQ(no_display.status, 1);
    EXPECT_THAT(no_display.err, HasSubstr("view --headless --script"));
    EXPECT_EQ(std::count(no_display.err.begin(), no_display.err.end(), '\n'), 1) << no_display.err;
    EXPECT_EQ(run({"view", "scene.toml", "--headless"}).status, 2);
    EXPECT_EQ(run({"view", "run.h5"}).status, 2);
    EXPECT_THAT(run({"view", "--help"}).out, HasSubstr("click WIDGET"));
}

/// The same script in a real window, where an X server can be had.
TEST_F(WindowTest, AWindowUnderXDoesTheSame) {
    if (std::system("command -v Xvfb >/dev/null && command -v xvfb-run >/dev/null") != 0)
        GTEST_SKIP() << "no Xvfb here";
    write("script.txt", R"(
wait time = 0
frames 3
widgets
click run.step
wait steps = 1
key Space
wait status = finished
click parameters.speed 0.8 0.5
wait builds = 2
wait parameters.speed > 3.5
frames 2
screenshot window.png
)");
    const std::string program = std::string(PERCUSS_BINARY_DIR) + "/percuss";
    const std::string command = "cd '" + folder_.path().string() +
                                "' && xvfb-run -a -s '-screen 0 1400x900x24' '" + program +
                                "' view scene.toml --script script.txt > out.txt 2>&1";
    const int status = std::system(command.c_str());
    ASSERT_EQ(status, 0) << test::text_of(path("out.txt"));
    const render::Image image = render::read_png(path("window.png"));
    EXPECT_EQ(image.width, 1280);
    EXPECT_EQ(image.height, 720);
    std::set<unsigned> colours;
    for (std::size_t i = 0; i + 2 < image.pixels.size(); i += 3)
        colours.insert(image.pixels[i] << 16U | image.pixels[i + 1] << 8U | image.pixels[i + 2]);
    EXPECT_GT(colours.size(), 200U);
}

}  // namespace
}  // namespace percuss
