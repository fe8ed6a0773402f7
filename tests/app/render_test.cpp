#include "app/program_test.hpp"
#include "image.hpp"

namespace percuss {
namespace {

using test::Outcome;
using testing::ElementsAre;
using testing::HasSubstr;

/// One run for all tests of this file.
class RenderTest : public test::ProgramTest {
  protected:
    void SetUp() override {
        const Outcome outcome =
            run({"run", "scene.toml", "--out", "out", "--no-render", "--frames", "0.005"});
        ASSERT_EQ(outcome.status, 0) << outcome.err;
    }
};

TEST_F(RenderTest, DrawsTheLastFrameByDefault) {
    const Outcome outcome = run({"render", "out", "--size", "320x200"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_THAT(files("out/redrawn"), ElementsAre("000004.png"));
    const render::Image image = render::read_png(path("out/redrawn/000004.png"));
    EXPECT_EQ(image.width, 320);
    EXPECT_EQ(image.height, 200);
}

TEST_F(RenderTest, DrawsOtherFieldsOtherwise) {
    ASSERT_EQ(run({"render", "out/run.h5", "--size", "320x200", "--frame", "2", "--out", "a"}).status, 0);
    ASSERT_EQ(run({"render", "out/run.h5", "--size", "320x200", "--frame", "2", "--out", "b", "--field",
                   "velocity.y"})
                  .status,
              0);
    EXPECT_NE(render::read_png(path("a/000002.png")).pixels, render::read_png(path("b/000002.png")).pixels);
    ASSERT_EQ(run({"render", "out/run.h5", "--size", "320x200", "--frame", "2", "--out", "c", "--window",
                   "0,-1,1,0"})
                  .status,
              0);
    EXPECT_NE(render::read_png(path("a/000002.png")).pixels, render::read_png(path("c/000002.png")).pixels);
}

TEST_F(RenderTest, DrawsTheFrameAndRangeAskedFor) {
    const auto picture = [&](const std::string& out, const std::string& frame,
                             std::vector<std::string> more = {}, const std::string& run_folder = "out") {
        std::vector<std::string> command{"render",  run_folder, "--size", "320x200",
                                         "--frame", frame,      "--out",  out};
        command.insert(command.end(), more.begin(), more.end());
        const Outcome outcome = run(command);
        EXPECT_EQ(outcome.status, 0) << outcome.err;
        return render::read_png(path(out) / ("00000" + frame + ".png")).pixels;
    };
    const std::vector<std::string> velocity{"--field", "velocity.y"};
    const auto plain = picture("plain", "2");
    EXPECT_NE(plain, picture("earlier", "1"));
    EXPECT_NE(plain, picture("range", "2", {"--range", "0,100"}));
    // A range that the scene sets belongs to the scene's field: another field is drawn over its own.
    ASSERT_EQ(run({"run", "scene.toml", "--out", "ranged", "--no-render", "--frames", "0.005", "--set",
                   "view.range=[0, 100]"})
                  .status,
              0);
    EXPECT_NE(plain, picture("ranged-plain", "2", {}, "ranged"));
    EXPECT_EQ(picture("velocity", "2", velocity), picture("ranged-velocity", "2", velocity, "ranged"));
}

TEST_F(RenderTest, DrawsAllFramesAndReplacesOnlyByForce) {
    const std::vector<std::string> command{"render", "out",   "--size",  "160x120",
                                           "--all",  "--out", "pictures"};
    ASSERT_EQ(run(command).status, 0);
    EXPECT_EQ(files("pictures").size(), 5U);
    const Outcome refused = run(command);
    EXPECT_EQ(refused.status, 2);
    EXPECT_THAT(refused.err, HasSubstr("pictures/000000.png: the picture exists"));
    std::vector<std::string> forced = command;
    forced.emplace_back("--force");
    EXPECT_EQ(run(forced).status, 0);
}

TEST_F(RenderTest, RefusesWhatTheRunDoesNotHave) {
    const Outcome field = run({"render", "out", "--field", "stress.yy"});
    EXPECT_EQ(field.status, 2);
    EXPECT_THAT(field.err, HasSubstr("stress.y"));
    const Outcome frame = run({"render", "out", "--frame", "5"});
    EXPECT_EQ(frame.status, 2);
    EXPECT_EQ(frame.err, "percuss: --frame 5: the run has frames 0 to 4\n");
    EXPECT_EQ(run({"render", "out", "--range", "1"}).status, 2);
    EXPECT_EQ(run({"render", "out", "--range", "2,1"}).status, 2);
    EXPECT_EQ(run({"render", "out", "--size", "big"}).status, 2);
    EXPECT_FALSE(exists("out/redrawn"));
    write("broken.h5", "no HDF5");
    const Outcome broken = run({"render", "broken.h5"});
    EXPECT_EQ(broken.status, 1);
    EXPECT_THAT(broken.err, HasSubstr("broken.h5: cannot be opened: "));
}

TEST_F(RenderTest, MakesAFilm) {
    const Outcome outcome = run({"render", "out", "--size", "320x200", "--film", "film.mp4"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(test::text_of(path("film.mp4")).substr(4, 4), "ftyp");
    EXPECT_FALSE(exists("out/redrawn"));
    EXPECT_EQ(run({"render", "out", "--film", "film.mp4"}).status, 2);
}

TEST_F(RenderTest, DrawsFigures) {
    const Outcome outcome = run({"figures", "out", "--column", "contact.impact.y", "--column",
                                 "energy.kinetic", "--out", "figure.png", "--size", "600x300"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(render::read_png(path("figure.png")).width, 600);
    const Outcome wrong = run({"figures", "out", "--column", "contact.impact.z", "--out", "other.png"});
    EXPECT_EQ(wrong.status, 2);
    EXPECT_THAT(wrong.err, HasSubstr("no history column 'contact.impact.z'"));
    EXPECT_FALSE(exists("other.png"));
}

}  // namespace
}  // namespace percuss
