#include "workbench/layout.hpp"

#include <cstdlib>

#include "app/workbench/window_fixture.hpp"

namespace percuss {
namespace {

using app::WindowLayout;
using test::Outcome;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(Layout, ComesBackAsItWas) {
    WindowLayout layout;
    layout.left = 17.25;
    layout.scale = 1.5;
    layout.dark = true;
    layout.window = {1600, 900};
    layout.plots = {{"energies", false}, {"step", true}};
    layout.curves = {"forces.axial/\"washer\"-nail"};
    layout.sections = {{3735928559U, true}, {7U, false}};
    layout.recent = {"/a b/ü.toml", "/c.toml"};
    const WindowLayout back = app::parse_layout(app::layout_text(layout));
    EXPECT_EQ(back.left, layout.left);
    EXPECT_EQ(back.right, std::nullopt);
    EXPECT_EQ(back.scale, layout.scale);
    EXPECT_EQ(back.dark, layout.dark);
    EXPECT_EQ(back.window, layout.window);
    EXPECT_EQ(back.plots, layout.plots);
    EXPECT_EQ(back.curves, layout.curves);
    EXPECT_EQ(back.sections, layout.sections);
    EXPECT_EQ(back.recent, layout.recent);
}

TEST(Layout, NonsenseIsPassedOver) {
    const WindowLayout layout = app::parse_layout(
        R"({"left": "wide", "right": 1e9, "scale": -1, "dark": 1, "window": [0, 99999], "plots": [1],
            "curves": {"a": 3}, "sections": {"x": true, "-1": true, "5": 2}, "recent": [7], "new": {}})");
    EXPECT_FALSE(layout.left || layout.right || layout.scale || layout.dark || layout.window);
    EXPECT_TRUE(layout.plots.empty() && layout.curves.empty() && layout.sections.empty());
    EXPECT_THAT(layout.recent, IsEmpty());
    EXPECT_THROW(static_cast<void>(app::parse_layout("{\"left\": ")), app::LayoutError);
    EXPECT_THROW(static_cast<void>(app::parse_layout("[]")), app::LayoutError);
}

TEST(Layout, RecentScenesAreFewAndDistinct) {
    WindowLayout layout;
    for (int i = 0; i < 30; ++i) layout.remember("/s" + std::to_string(i) + ".toml");
    layout.remember("/x/../s20.toml");
    EXPECT_EQ(layout.recent.size(), 20U);
    EXPECT_EQ(layout.recent[0], "/s20.toml");
    EXPECT_EQ(layout.recent[1], "/s29.toml");
    EXPECT_EQ(std::count(layout.recent.begin(), layout.recent.end(), "/s20.toml"), 1);
}

class LayoutTest : public test::WindowTest {
  protected:
    LayoutTest() {
        setenv("XDG_STATE_HOME", path("state").c_str(), 1);
        setenv("XDG_CACHE_HOME", path("cache").c_str(), 1);
    }
    ~LayoutTest() override {
        unsetenv("XDG_STATE_HOME");
        unsetenv("XDG_CACHE_HOME");
    }
    [[nodiscard]] int width(const std::string& widget) const {
        const Place& place = widgets_.at(widget);
        return place[2] - place[0];
    }
};

TEST_F(LayoutTest, TheWindowComesBackAsItWasLeft) {
    play("wait time = 0\nframes 3\nwidgets\n");
    const Place before = widgets_.at("viewport");
    ASSERT_TRUE(widgets_.contains("plots.velocities.y"));
    ASSERT_FALSE(exists("state")) << "a script alone remembers nothing";
    const std::vector<std::string> with{"--layout", "kept/layout.json"};
    play(R"(
wait time = 0
frames 3
drag splitter.left 0.5 0.5 9 0.5
drag splitter.right 0.5 0.5 -6 0.5
click "plots.velocities.y/anvil"
click plots.velocities.y.title
click header.design
do window.dark
frames 2
)",
         with);
    widgets_.clear();
    play(R"(
wait time = 0
frames 3
widgets
expect dark = 1
expect recent contains scene.toml
)",
         with);
    const Place after = widgets_.at("viewport");
    EXPECT_GT(after[0], before[0] + 30) << "the left panel is wider";
    EXPECT_LT(after[2], before[2] - 20) << "so is the right one";
    EXPECT_FALSE(widgets_.contains("plots.velocities.y")) << "folded";
    EXPECT_FALSE(widgets_.contains("parameters.speed")) << "folded";
    EXPECT_THAT(test::text_of(path("kept/layout.json")), HasSubstr("velocities.y/anvil"));
    // A double click takes the width back.
    play("wait time = 0\nframes 3\ndouble-click splitter.left\nframes 2\nwidgets\n", with);
    EXPECT_EQ(widgets_.at("viewport")[0], before[0]);
    EXPECT_FALSE(exists("state"));
}

TEST_F(LayoutTest, ABrokenFileIsToldInOneLine) {
    write("broken.json", "{\"left\": 12,");
    write("script.txt", "wait time = 0\nframes 2\n");
    const Outcome outcome =
        run({"view", "scene.toml", "--headless", "--script", "script.txt", "--layout", "broken.json"});
    EXPECT_EQ(outcome.status, 0);
    EXPECT_THAT(outcome.err, HasSubstr("broken.json: is no JSON"));
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
}

TEST_F(LayoutTest, ThePickerShowsScenesAsTheyBegin) {
    const std::string script = R"(
wait time = 0
key Ctrl+O
frames 2
wait thumbnails.busy = 0
frames 2
expect thumbnails.drawn = 1
widgets
screenshot picker.png
)";
    play(script);
    EXPECT_FALSE(exists("cache/percuss"));
    std::set<unsigned> colours;
    const render::Image image = render::read_png(path("picker.png"));
    const auto [left, top, right, bottom] = widgets_.at("picker.scene.toml");
    for (int y = top; y < bottom; ++y)
        for (int x = left; x < left + (bottom - top); ++x) {
            const auto* p =
                image.pixels.data() + 3 * (static_cast<std::size_t>(y) * 1280 + static_cast<std::size_t>(x));
            colours.insert(static_cast<unsigned>(p[0] << 16 | p[1] << 8 | p[2]));
        }
    EXPECT_GT(colours.size(), 12U) << "two bodies in colours of their own";
    ASSERT_TRUE(widgets_.contains("picker.bad.toml"));
    const std::vector<std::string> with{"--layout", "layout.json"};
    play(script, with);
    EXPECT_EQ(files("cache/percuss/thumbnails").size(), 1U);
    play(R"(
wait time = 0
key Ctrl+O
frames 2
wait thumbnails.busy = 0
expect thumbnails.drawn = 0
type scene
key Enter
wait builds = 2
)",
         with);
    std::string text = test::text_of(path("scene.toml"));
    write("scene.toml", text + "# another\n");
    play(script, with);
}

TEST_F(LayoutTest, RecentScenesComeFirst) {
    std::filesystem::create_directories(path("elsewhere"));
    std::filesystem::copy_file(path("scene.toml"), path("elsewhere/other.toml"));
    const std::vector<std::string> with{"--layout", "layout.json"};
    play(
        "wait time = 0\nopen elsewhere/other.toml\nwait builds = 2\nopen scene.toml\nwait builds = 3\nframes "
        "2\n",
        with);
    play("wait time = 0\nkey Ctrl+O\nframes 3\nwait thumbnails.busy = 0\nframes 2\nwidgets\n", with);
    ASSERT_TRUE(widgets_.contains("picker.elsewhere/other.toml")) << "it is found though it is nowhere near";
    EXPECT_LT(widgets_.at("picker.scene.toml")[1], widgets_.at("picker.elsewhere/other.toml")[1]);
    EXPECT_LT(widgets_.at("picker.elsewhere/other.toml")[1], widgets_.at("picker.bad.toml")[1]);
}

}  // namespace
}  // namespace percuss
