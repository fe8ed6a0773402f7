#include "app/workbench/window_fixture.hpp"

namespace percuss {
namespace {

class ResizeTest : public test::WindowTest {};

TEST_F(ResizeTest, AnySizeIsDrawnWhileTheRunGoesOn) {
    std::string script = "wait time = 0\nframes 2\ndo run.toggle\nscreenshot before.png\n";
    for (const char* size : {"1 1", "50 50", "1 700", "1900 60", "300 1000", "2600 1700", "2 2", "640 480"})
        script += std::string("resize ") + size + "\nframes 3\n";
    script +=
        "expect width = 640\nexpect height = 480\nscreenshot small.png\nresize 1 1\nframes "
        "2\nscreenshot one.png\n";
    for (int i = 0; i < 40; ++i)
        script += "resize " + std::to_string(1 + 97 * i % 1311) + " " + std::to_string(1 + 211 * i % 977) +
                  "\nframes 1\n";
    script += "resize 1280 720\nframes 3\nwait status = finished\nframes 3\nscreenshot after.png\nwidgets\n";
    play(script);
    const render::Image small = render::read_png(path("small.png")), one = render::read_png(path("one.png")),
                        before = render::read_png(path("before.png")),
                        after = render::read_png(path("after.png"));
    EXPECT_EQ(small.width, 640);
    EXPECT_EQ(small.height, 480);
    EXPECT_EQ(one.width, 1);
    EXPECT_EQ(after.width, before.width);
    EXPECT_EQ(after.height, before.height);
    EXPECT_GT(count("after.png", "viewport", 0x440154), 0) << "the model is not in the picture";
    write("bad.txt", "resize 0 10\n");
    EXPECT_NE(run({"view", "scene.toml", "--headless", "--script", "bad.txt"}).status, 0);
}

}  // namespace
}  // namespace percuss
