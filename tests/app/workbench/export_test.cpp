#include <set>

#include "app/workbench/window_fixture.hpp"

/// What leaves the window as files.
namespace percuss {
namespace {

using test::Outcome;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr unsigned viridis_middle = 0x21918c;

class ExportTest : public test::WindowTest {
  protected:
    /// What a script prints.
    std::string printed(const std::string& script, const std::vector<std::string>& more = {}) {
        write("script.txt", script);
        std::vector<std::string> command{"view", "scene.toml", "--headless", "--script", "script.txt"};
        command.insert(command.end(), more.begin(), more.end());
        const Outcome outcome = run(command);
        EXPECT_EQ(outcome.status, 0) << outcome.err;
        return outcome.out;
    }
    [[nodiscard]] static std::vector<std::string> lines_of(const std::string& text) {
        std::istringstream in(text);
        std::vector<std::string> lines;
        for (std::string line; std::getline(in, line);) lines.push_back(line);
        return lines;
    }
    /// A column of a CSV, as written.
    [[nodiscard]] std::vector<std::string> column(const std::string& file, const std::string& name) const {
        std::vector<std::string> values;
        std::size_t place = std::string::npos;
        for (const std::string& line : lines_of(test::text_of(path(file)))) {
            std::istringstream in(line);
            std::vector<std::string> cells;
            for (std::string cell; std::getline(in, cell, ',');) cells.push_back(cell);
            if (place == std::string::npos)
                place = static_cast<std::size_t>(std::find(cells.begin(), cells.end(), name) - cells.begin());
            else
                values.push_back(place < cells.size() ? cells[place] : "");
        }
        return values;
    }
    [[nodiscard]] int pixels(const std::string& file, unsigned colour) const {
        const render::Image image = render::read_png(path(file));
        int found = 0;
        for (std::size_t i = 0; i + 2 < image.pixels.size(); i += 3)
            found += test::near(image.pixels.data() + i, colour);
        return found;
    }
    /// Names in the folder that are none of the test's own.
    [[nodiscard]] std::set<std::string> left() const {
        std::set<std::string> names;
        for (const std::string& name : files("."))
            if (name != "scene.toml" && name != "bad.toml" && name != "script.txt" &&
                !name.starts_with(".std"))
                names.insert(name);
        return names;
    }
};

TEST_F(ExportTest, PlotsLeaveEveryStepOfWhatTheyShow) {
    ASSERT_EQ(run({"run", "scene.toml", "--out", "whole"}).status, 0);
    play(R"(
wait time = 0
do run.toggle
wait status = finished
click "plots.velocities.y/anvil"
click plots.forces.y.menu
click plots.forces.y.menu.csv
do export.plots-png
click plots.velocities.y.menu
click plots.velocities.y.menu.csv
wait exporting = 0
expect export.faults = ""
wheel plots.forces.y 8 0.3 0.5
frames 1
do export.plots-csv
wait exporting = 0
)");
    const auto times = column("whole/history.csv", "time [ms]"),
               forces = column("whole/history.csv", "contact.impact.y [kN]");
    ASSERT_GT(times.size(), 100U);
    EXPECT_EQ(column("scene-forces.y.csv", "time [ms]"), times) << "all steps, bit by bit";
    EXPECT_EQ(column("scene-forces.y.csv", "contact.impact.y [kN]"), forces);
    const std::string head = lines_of(test::text_of(path("scene-velocities.y.csv")))[0];
    EXPECT_EQ(head, "time [ms],body.striker.velocity.y [m/s]") << "the anvil's is hidden";
    const render::Image picture = render::read_png(path("scene-forces.y.png"));
    EXPECT_GE(picture.width, 1600);
    EXPECT_GT(pixels("scene-forces.y.png", 0x0072b2), 300);
    EXPECT_TRUE(exists("scene-energies.png"));
    const auto zoomed = column("scene-forces.y-2.csv", "time [ms]");
    ASSERT_GT(zoomed.size(), 5U) << "a name that is taken gets a number";
    EXPECT_LT(zoomed.size(), times.size() / 2);
    EXPECT_NE(std::search(times.begin(), times.end(), zoomed.begin(), zoomed.end()), times.end())
        << "the zoomed part, without gaps";
    EXPECT_FALSE(exists("scene-step.csv")) << "that plot is folded";
}

TEST_F(ExportTest, AReferenceHasColumnsOfItsOwn) {
    play(R"(
wait time = 0
do run.toggle
wait status = finished
key B
set parameters.speed 4
wait builds = 2
wait status = finished
frames 2
do export.plots-csv
wait exporting = 0
)");
    EXPECT_EQ(lines_of(test::text_of(path("scene-forces.y.csv")))[0],
              "time [ms],contact.impact.y [kN],reference time [ms],reference contact.impact.y [kN]");
    const auto now = column("scene-forces.y.csv", "contact.impact.y [kN]"),
               then = column("scene-forces.y.csv", "reference contact.impact.y [kN]");
    const auto peak = [](const std::vector<std::string>& values) {
        double most = 0;
        for (const std::string& value : values)
            if (!value.empty()) most = std::max(most, std::abs(std::stod(value)));
        return most;
    };
    EXPECT_NEAR(peak(now), 4 * peak(then), 0.3 * peak(now));
}

TEST_F(ExportTest, APictureIsTheViewportEnlarged) {
    play(R"(
wait time = 0
do view.forces
do view.velocities
frames 3
widgets
screenshot window.png
do export.picture
wait exporting = 0
expect export.written = scene.png
)");
    const auto [left, top, right, bottom] = widgets_.at("viewport");
    const render::Image picture = render::read_png(path("scene.png"));
    EXPECT_EQ(picture.width, 2 * (right - left));
    EXPECT_EQ(picture.height, 2 * (bottom - top));
    const int shown = count("window.png", "viewport", viridis_middle);
    EXPECT_NEAR(pixels("scene.png", viridis_middle), 4 * shown, 0.12 * shown)
        << "the mesh has the same part of the picture";
}

TEST_F(ExportTest, SequencesAndFilmsShowTheRunSoFar) {
    play(R"(
wait time = 0
until 0.01
do run.until
wait time >= 0.01
wait status = paused
frames 2
widgets
click view.range.all
do export.panel
frames 3
click export.count
key Ctrl+A
type 5
key Enter
frames 1
screenshot end.png
do export.sequence
frames 2
expect exporting = 1
wait exporting = 0
do export.film
do run.reset
wait exporting = 0
expect export.faults = ""
expect steps = 0
)");
    std::vector<std::string> pictures = files("scene-frames");
    EXPECT_THAT(pictures, ElementsAre("000000.png", "000001.png", "000002.png", "000003.png", "000004.png"));
    EXPECT_GT(pixels("scene-frames/000000.png", 0x440154), 20000)
        << "nothing is stressed yet, in the colours of all times";
    const render::Image last = render::read_png(path("scene-frames/000004.png"));
    const auto [left, top, right, bottom] = widgets_.at("viewport");
    EXPECT_EQ(last.width, right - left);
    EXPECT_EQ(last.height, bottom - top);
    for (const unsigned colour : {0xfde725U, 0x440154U}) {
        const int shown = count("end.png", "viewport", colour);
        EXPECT_NEAR(pixels("scene-frames/000004.png", colour), shown, 0.1 * shown + 50)
            << "the last one is the moment shown";
    }
    EXPECT_EQ(test::text_of(path("scene.mp4")).substr(4, 4), "ftyp") << "though the run was reset meanwhile";
}

TEST_F(ExportTest, WhatIsCancelledLeavesNothing) {
    play(R"(
wait time = 0
do run.toggle
wait status = finished
frames 2
do export.panel
frames 3
click export.count
key Ctrl+A
type 9999
key Enter
do export.film
frames 6
expect export.progress > 0
expect export.progress < 0.5
click export.cancel
wait exporting = 0
do export.sequence
frames 6
)");
    EXPECT_THAT(left(), IsEmpty()) << "nor does what was not done when the window closed";
}

TEST_F(ExportTest, ARecordingIsWhatTheViewportShows) {
    play(R"(
wait time = 0
frames 3
do export.record
expect recording = 1
do run.toggle
wait status = finished
frames 3
do export.record
expect recording = 0
wait exporting = 0
expect export.faults = ""
expect export.written = scene-live.mp4
do export.record
frames 2
)");
    EXPECT_EQ(test::text_of(path("scene-live.mp4")).substr(4, 4), "ftyp");
    EXPECT_THAT(left(), ElementsAre("scene-live.mp4"))
        << "one that goes on when the window closes is dropped";
}

TEST_F(ExportTest, FiguresAreThoseOfARecordedRun) {
    std::string text = test::text_of(path("scene.toml"));
    text.insert(text.find("[expect]"),
                "[[figure]]\nname = \"speeds\"\nkind = \"history\"\ntitle = \"Speeds\"\ncolumns = "
                "[\"body.striker.velocity.y\"]\n[[figure]]\nname = \"waves\"\nkind = \"space-time\"\ntitle = "
                "\"Waves\"\nbody = \"anvil\"\nfield = \"stress.y\"\ninterval = 1e-4\n");
    write("scene.toml", text);
    play(R"(
wait time = 0
do export.figures
expect export.faults contains "no histories"
do run.toggle
wait status = finished
do export.figures
wait exporting = 0
)");
    for (const char* name :
         {"speeds.png", "waves.png", "mesh.png", "clamping.png", "energy.png", "energy.csv"})
        EXPECT_TRUE(exists(std::string("scene-figures/") + name)) << name;
    EXPECT_GT(pixels("scene-figures/speeds.png", 0x0072b2), 300);
}

TEST_F(ExportTest, TheSceneIsSavedWithWhatWasSet) {
    const std::string source = test::text_of(path("scene.toml"));
    play(R"(
wait time = 0
set parameters.speed 4
wait builds = 2
set model.step.courant 0.5
click view.colours
click view.colours.cividis
do scene.save
wait exporting = 0
expect export.written = scene-1.toml
do export.panel
frames 3
click scene.save-view
click scene.save
wait exporting = 0
expect export.written contains scene-2.toml
click scene.save-name
key Ctrl+A
type scene.toml
key Enter
click scene.save
expect export.faults contains "there is one already"
frames 2
widgets
screenshot refused.png
click messages.dismiss
expect export.faults = ""
)");
    EXPECT_EQ(test::text_of(path("scene.toml")), source) << "nothing is replaced unasked";
    EXPECT_GT(count("refused.png", "messages", 0xffedeb), 2000);
    std::string expected = source;
    expected.replace(expected.find("value = 1,"), 10, "value = 4,");
    expected.replace(expected.find("courant = 0.9"), 13, "courant = 0.5");
    EXPECT_EQ(test::text_of(path("scene-1.toml")), expected);
    EXPECT_EQ(test::text_of(path("scene-2.toml")), expected + "\n[view]\ncolour_map = \"cividis\"\n");
    ASSERT_EQ(run({"run", "scene-1.toml", "--out", "saved"}).status, 0);
    ASSERT_EQ(run({"run", "scene.toml", "--out", "set", "--set", "parameters.speed=4", "--set",
                   "model.step.courant=0.5"})
                  .status,
              0);
    EXPECT_EQ(summary("saved")["state_hash"], summary("set")["state_hash"]);
}

TEST_F(ExportTest, TheSourceIsReplacedWhenThatIsAskedFor) {
    play(R"(
wait time = 0
set parameters.speed 4
wait builds = 2
do export.panel
frames 3
click scene.save-name
key Ctrl+A
type scene
key Enter
click scene.save-replace
click scene.save
wait exporting = 0
expect export.faults = ""
)");
    EXPECT_THAT(test::text_of(path("scene.toml")), HasSubstr("value = 4,"));
}

TEST_F(ExportTest, WhatCannotBeWrittenIsSaid) {
    play(R"(
wait time = 0
do run.step
wait steps = 1
do export.panel
frames 3
click export.name
key Ctrl+A
type scene.toml/picture
key Enter
do export.picture
wait exporting = 0
expect export.faults contains scene.toml
do export.plots-csv
do export.film
wait exporting = 0
frames 2
expect export.written = ""
click messages.dismiss
expect export.faults = ""
)");
    EXPECT_THAT(left(), IsEmpty());
}

}  // namespace
}  // namespace percuss
