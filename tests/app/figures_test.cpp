#include "app/program_test.hpp"
#include "image.hpp"

namespace percuss {
namespace {

using test::Outcome;
using testing::HasSubstr;
using testing::UnorderedElementsAre;

const std::string every_kind = R"(
[[figure]]
name = "force"
kind = "history"
columns = ["contact.impact.y", "contact.impact.x"]
labels = ["across", "along"]
window = 0.001
factor = -1
[[figure]]
name = "shapes"
kind = "mesh"
times = [0, 0.01, 0.02]
[[figure]]
name = "stresses"
kind = "mesh"
times = [0.01]
field = "von_mises"
[[figure]]
name = "waves"
kind = "space-time"
body = "striker"
field = "stress.y"
[[figure]]
name = "along-face"
kind = "surface-forces"
body = "striker"
edge = "bottom"
along = "x"
direction = "y"
bins = 2
times = [0.005]
[[figure]]
name = "grip"
kind = "clamping"
[[figure]]
name = "budget"
kind = "energy"
[analysis]
pull_out = { body = "striker", friction = 0.5 }
)";

class FiguresTest : public test::ProgramTest {
  protected:
    FiguresTest() { write("scene.toml", test::small_scene + every_kind); }
    /// Pixels that are not white, as a fraction.
    [[nodiscard]] double ink(const std::string& name) const {
        const render::Image image = render::read_png(path(name));
        double count = 0;
        for (std::size_t i = 0; i < image.pixels.size(); i += 3)
            count += image.pixels[i] + image.pixels[i + 1] + image.pixels[i + 2] < 720 ? 1 : 0;
        return 3 * count / static_cast<double>(image.pixels.size());
    }
};

TEST_F(FiguresTest, ARunDrawsEveryKindThatItsSceneDeclares) {
    const Outcome outcome = run({"run", "scene.toml", "--out", "out", "--frames", "0.005"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_THAT(files("out/figures"),
                UnorderedElementsAre("force.png", "shapes.png", "stresses.png", "waves.png", "along-face.png",
                                     "along-face.csv", "grip.png", "budget.png", "budget.csv"));
    for (const char* name : {"force", "shapes", "stresses", "waves", "along-face", "grip", "budget"})
        EXPECT_GT(ink(std::string("out/figures/") + name + ".png"), 0.01) << name;
    // Those with filled areas have far more than type and lines.
    for (const char* name : {"waves", "along-face", "budget", "stresses"})
        EXPECT_GT(ink(std::string("out/figures/") + name + ".png"), 0.1) << name;
    EXPECT_THAT(test::text_of(path("out/figures/along-face.csv")),
                HasSubstr("time [ms],initial x 0.5 [kN/mm],initial x 1.5 [kN/mm]\n"));
    EXPECT_THAT(test::text_of(path("out/figures/budget.csv")),
                HasSubstr("time [ms],kinetic.striker [J],kinetic.anvil [J],elastic.striker [J]"));
    const auto summary = this->summary("out");
    EXPECT_DOUBLE_EQ(summary["analysis"]["pull_out"]["force"].get<double>(),
                     0.5 * std::abs(summary["contact"]["impact"]["residual"]["x"].get<double>()));
    EXPECT_GT(std::abs(summary["contact"]["impact"]["peak_averaged"]["y"].get<double>()), 0);
    EXPECT_TRUE(summary["energy_budget"]["elastic"]["anvil"].is_number());
}

TEST_F(FiguresTest, AnyRunHasFiguresThatNeedNoDeclaration) {
    write("scene.toml", test::small_scene);
    ASSERT_EQ(run({"run", "scene.toml", "--out", "out", "--no-render"}).status, 0);
    EXPECT_FALSE(exists("out/figures"));
    const Outcome outcome = run({"figures", "out"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_THAT(files("out/figures"), UnorderedElementsAre("forces.png", "velocities.png", "mesh.png",
                                                           "clamping.png", "energy.png", "energy.csv"));
    EXPECT_EQ(run({"figures", "out"}).status, 2);
    EXPECT_EQ(run({"figures", "out", "--force"}).status, 0);
}

TEST_F(FiguresTest, OneFigureCanBeDrawnAnewWithOtherKeys) {
    ASSERT_EQ(run({"run", "scene.toml", "--out", "out", "--no-render"}).status, 0);
    ASSERT_EQ(run({"figures", "out", "--figure", "force", "--out", "a"}).status, 0);
    ASSERT_EQ(
        run({"figures", "out", "--figure", "force", "--out", "b", "--set", "figure.force.factor=1"}).status,
        0);
    EXPECT_THAT(files("a"), UnorderedElementsAre("force.png"));
    EXPECT_NE(render::read_png(path("a/force.png")).pixels, render::read_png(path("b/force.png")).pixels);
    const Outcome wrong = run({"figures", "out", "--figure", "farce", "--out", "c"});
    EXPECT_EQ(wrong.status, 2);
    EXPECT_THAT(wrong.err, HasSubstr("--figure: unknown figure 'farce'; did you mean 'force'?"));
    const Outcome model = run({"figures", "out", "--out", "c", "--set", "model.duration=1"});
    EXPECT_EQ(model.status, 2);
    EXPECT_THAT(model.err, HasSubstr("only figure, analysis and view can change after the run"));
}

TEST_F(FiguresTest, CompareTellsWhatDiffers) {
    write("scene.toml",
          std::string(test::small_scene) + "[parameters]\nspeed = { value = 1, unit = \"m/s\" }\n");
    ASSERT_EQ(run({"run", "scene.toml", "--out", "slow", "--no-render", "--set",
                   "body.striker.velocity.1='= -speed'"})
                  .status,
              0);
    ASSERT_EQ(run({"run", "scene.toml", "--out", "fast", "--no-render", "--set",
                   "body.striker.velocity.1='= -speed'", "--set", "parameters.speed=2"})
                  .status,
              0);
    const Outcome outcome =
        run({"compare", "slow", "fast/run.h5", "--out", "page.png", "--csv", "table.csv"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_THAT(outcome.out, testing::ContainsRegex("parameters.speed +m/s +1 +2 +\\+100.0 %"));
    EXPECT_THAT(test::text_of(path("table.csv")), HasSubstr("parameters.speed,m/s,1,2,1,1\n"));
    EXPECT_THAT(test::text_of(path("table.csv")), HasSubstr("contact.impact.peak_averaged.y,kN,"));
    EXPECT_GT(ink("page.png"), 0.05);
    EXPECT_EQ(run({"compare", "slow", "fast", "--out", "page.png"}).status, 2);
    EXPECT_EQ(run({"compare", "slow", "nowhere", "--out", "other.png"}).status, 2);
}

}  // namespace
}  // namespace percuss
