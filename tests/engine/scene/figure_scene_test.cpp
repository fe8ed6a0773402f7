#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/scene/small_scene.hpp"

namespace percuss {
namespace {

using testing::faults_of;
using testing::small_scene;

/// The faults of the small scene with a figure that begins at line 45.
std::string faults(const std::string& figure) { return faults_of(small_scene + figure); }

const std::string head = "[[figure]]\nname = \"f\"\n";

TEST(FigureScene, ReadsWhatAFigureDeclares) {
    const Scene scene = parse_scene(small_scene + head + R"(kind = "history"
columns = ["contact.hit.axial", "contact.hit.radial"]
labels = ["axial", "radial"]
factor = -1
window = 0.002
range = [-1, 2]
[analysis]
residual = 0.2
pull_out = { body = "rod", friction = 0.3 }
)",
                                    "scene.toml", {});
    ASSERT_EQ(scene.figures.size(), 1U);
    const FigureSpec& figure = scene.figures[0];
    EXPECT_EQ(figure.kind, FigureKind::history);
    EXPECT_THAT(figure.labels, ::testing::ElementsAre("axial", "radial"));
    EXPECT_EQ(figure.factor, -1);
    EXPECT_EQ(figure.window, 0.002);
    EXPECT_EQ((*figure.range)[1], 2);
    EXPECT_EQ(scene.analysis.residual, 0.2);
    EXPECT_EQ(scene.analysis.pull_out->friction, 0.3);
}

TEST(FigureScene, AColumnThatHistoriesDoNotHaveIsAFaultWithTheNearestName) {
    EXPECT_EQ(
        faults(head + "kind = \"history\"\ncolumns = [\"contact.hit.axail\"]\n"),
        "scene.toml:48:11: unknown history column 'contact.hit.axail'; did you mean 'contact.hit.axial'?");
}

TEST(FigureScene, ColumnsOfOneFigureShareAnAxis) {
    EXPECT_EQ(faults(head + "kind = \"history\"\ncolumns = [\"contact.hit.axial\", \"energy.kinetic\"]\n"),
              "scene.toml:48:11: 'contact.hit.axial' and 'energy.kinetic' have different units; put them "
              "into two figures");
}

TEST(FigureScene, KindsAndTheirKeys) {
    EXPECT_EQ(faults(head + "kind = \"hystory\"\n"),
              "scene.toml:47:8: unknown kind of figure 'hystory'; did you mean 'history'?");
    EXPECT_THAT(faults(head + "kind = \"energy\"\ncolumns = [\"energy.kinetic\"]\n"),
                ::testing::HasSubstr("unknown key 'columns'"));
    EXPECT_THAT(faults(head + "kind = \"mesh\"\n"), ::testing::HasSubstr("times = [0, 0.1, 0.3]"));
    EXPECT_EQ(faults(head + "kind = \"mesh\"\ntimes = [0, 0.2]\n"),
              "scene.toml:48:13: 'times[1]' is 0.2; it must be >= 0 and <= 0.1");
}

TEST(FigureScene, NamesOfBodiesEdgesPairsAndFields) {
    EXPECT_EQ(faults(head + "kind = \"space-time\"\nbody = \"rot\"\nfield = \"stress.axial\"\n"),
              "scene.toml:48:8: unknown body 'rot'; did you mean 'rod'?");
    EXPECT_EQ(faults(head + "kind = \"space-time\"\nbody = \"rod\"\nfield = \"stress.axal\"\n"),
              "scene.toml:49:9: unknown field 'stress.axal'; did you mean 'stress.axial'?");
    EXPECT_THAT(faults(head + "kind = \"surface-forces\"\nbody = \"rod\"\nedge = \"fase\"\n"),
                ::testing::HasSubstr("did you mean 'face'?"));
    EXPECT_EQ(faults(head + "kind = \"clamping\"\npairs = [\"hot\"]\n"),
              "scene.toml:48:9: unknown contact 'hot'; did you mean 'hit'?");
    EXPECT_EQ(faults("[analysis]\npull_out = { body = \"hamer\", friction = 0.3 }\n"),
              "scene.toml:46:21: unknown body 'hamer'; did you mean 'hammer'?");
}

TEST(FigureScene, LabelsLinesAndNames) {
    EXPECT_EQ(faults(head + "kind = \"history\"\ncolumns = [\"energy.kinetic\"]\nlabels = [\"a\", \"b\"]\n"),
              "scene.toml:49:10: 2 labels for 1 columns; give one for each, or leave 'labels' out");
    EXPECT_EQ(faults(head + "kind = \"space-time\"\nbody = \"rod\"\nfield = \"pressure\"\nfrom = [0, 0]\n"),
              "scene.toml:45:1: a line has two ends; write both 'from' and 'to', or neither for the body's "
              "middle line");
    EXPECT_EQ(faults(head + "kind = \"energy\"\n" + head + "kind = \"energy\"\n"),
              "scene.toml:49:8: the name 'f' is taken by line 45; give each its own name");
}

TEST(FigureScene, AHistoryFigureCanBeASideChart) {
    const std::string figure = head + "kind = \"history\"\ncolumns = [\"energy.kinetic\"]\n";
    EXPECT_EQ(faults_of(testing::changed(small_scene, "[view]", "[view]\ncharts = [\"f\"]") + figure), "");
}

}  // namespace
}  // namespace percuss
