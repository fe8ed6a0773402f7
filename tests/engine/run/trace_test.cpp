#include "run/trace.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/scene/small_scene.hpp"
#include "run/engine.hpp"
#include "run/force_density.hpp"
#include "run/series.hpp"
#include "solver.hpp"

namespace percuss {
namespace {

using ::testing::ElementsAre;

std::string with(const std::string& figure) { return testing::small_scene + figure; }

RunSetup setup_of(const std::string& text) {
    RunSetup setup;
    setup.scene = parse_scene(text, "scene.toml", {});
    setup.mesh = build_mesh(setup.scene);
    return setup;
}

const std::string space_time = R"([[figure]]
name = "waves"
kind = "space-time"
body = "rod"
field = "stress.axial"
)";

TEST(TraceRecorder, ALineCrossesItsCellsInOrder) {
    const TraceRecorder recorder(setup_of(with(space_time + "from = [0.5, 7.5]\nto = [0.5, 2.5]\n")));
    ASSERT_EQ(recorder.traces().size(), 1U);
    const Trace& trace = recorder.traces()[0];
    EXPECT_EQ(trace.name, "waves");
    EXPECT_EQ(trace.components, 1U);
    // Cells of 1 mm; the first and the last are crossed by half.
    ASSERT_EQ(trace.points.size(), 6U);
    EXPECT_NEAR(trace.points[0].y(), 7.25, 1e-12);
    EXPECT_NEAR(trace.points[1].y(), 6.5, 1e-12);
    EXPECT_NEAR(trace.points[5].y(), 2.75, 1e-12);
    EXPECT_NEAR(trace.along[1], 1.0, 1e-12);
}

TEST(TraceRecorder, ALineAlongSidesOfCellsSeesEachPlaceOnce) {
    const TraceRecorder recorder(setup_of(with(space_time + "from = [2, 0]\nto = [2, 8]\n")));
    EXPECT_EQ(recorder.traces()[0].points.size(), 8U);
}

TEST(TraceRecorder, WithoutEndsTheLineIsTheAxis) {
    const TraceRecorder recorder(setup_of(with(space_time)));
    const Trace& trace = recorder.traces()[0];
    ASSERT_EQ(trace.points.size(), 8U);
    EXPECT_EQ(trace.points[0].x(), 0);
    EXPECT_NEAR(trace.points[0].y(), 0.5, 1e-12);
    EXPECT_NEAR(trace.points[7].y(), 7.5, 1e-12);
}

TEST(TraceRecorder, ALineBesideItsBodyIsAFaultWithItsPlace) {
    try {
        const TraceRecorder recorder(setup_of(with(space_time + "from = [5, 0]\nto = [5, 8]\n")));
        FAIL() << "a line beside the body was taken";
    } catch (const SceneError& error) {
        EXPECT_STREQ(error.what(),
                     "scene.toml:45:1: the line of figure 'waves' does not cross body 'rod'; give ends "
                     "'from' and 'to' "
                     "inside it, or leave both out");
    }
}

/// Runs to the end; fields sampled by traces against those of frames at the same steps.
struct WholeRun {
    explicit WholeRun(const std::string& text)
        : engine(parse_scene(text, "scene.toml", {}), options(frames)) {
        engine.post(command::Run{});
        engine.wait();
    }
    static EngineOptions options(std::vector<std::shared_ptr<const Snapshot>>& frames) {
        EngineOptions options;
        options.frame_interval = 0.001;
        options.on_frame = [&frames](std::shared_ptr<const Snapshot> frame) {
            frames.push_back(std::move(frame));
        };
        return options;
    }
    std::vector<std::shared_ptr<const Snapshot>> frames;
    Engine engine;
};

std::string short_run(std::string text) {
    return testing::changed(std::move(text), "duration = 0.1", "duration = 0.005");
}

TEST(TraceRecorder, RowsHoldTheFieldsOfTheFramesOfTheirTimes) {
    WholeRun run(short_run(with(space_time + "from = [0.5, 0.5]\nto = [0.5, 7.5]\ninterval = 0.001\n")));
    const Trace trace = run.engine.traces().at(0);
    const Mesh& mesh = run.frames[0]->setup->mesh;
    ASSERT_GE(trace.rows->rows(), 5U);
    const std::vector<double> times = trace.rows->values("time");
    for (std::size_t f = 0; f < 5; ++f) {
        ASSERT_EQ(times[f], run.frames[f]->time);
        // The point at z = 1.5 lies in the cell of the second row and the first column.
        const auto cell = static_cast<std::size_t>(mesh.bodies[1].cell_begin + 4);
        EXPECT_EQ(trace.rows->table(f, f + 1)[2], run.frames[f]->stress[cell][1]) << f;
    }
    EXPECT_NE(trace.rows->table(4, 5)[1], 0);
}

TEST(TraceRecorder, FieldsOfNodesAreMeansOfTheCorners) {
    const std::string text = testing::changed(space_time, "stress.axial", "velocity.axial");
    WholeRun run(short_run(with(testing::changed(text, "\"rod\"", "\"hammer\""))));
    const Trace trace = run.engine.traces().at(0);
    for (std::size_t k = 1; k <= trace.points.size(); ++k) EXPECT_EQ(trace.rows->table(0, 1)[k], 10);
    EXPECT_LT(trace.rows->table(trace.rows->rows() - 1, trace.rows->rows())[2], 9.9);
}

TEST(TraceRecorder, SurfaceForcesKeepEveryImpulse) {
    WholeRun run(short_run(with(R"([[figure]]
name = "face"
kind = "surface-forces"
body = "rod"
edge = "face"
interval = 0.0004
)")));
    const Trace trace = run.engine.traces().at(0);
    EXPECT_EQ(trace.components, 2U);
    ASSERT_EQ(trace.points.size(), 5U);
    EXPECT_THAT(trace.along, ElementsAre(0, 1, 2, 3, 4));
    const auto history = run.engine.history();
    const auto times = history->values("time"), force = history->values("contact.hit.axial");
    double of_pair = 0, of_nodes = 0;
    const std::size_t rows = trace.rows->rows();
    double begin = 0;
    for (std::size_t f = 0; f < rows; ++f) {
        const std::vector<double> row = trace.rows->table(f, f + 1);
        const double length = 2 * (row[0] - begin);
        for (std::size_t k = 0; k < 5; ++k) of_nodes += length * row[2 + 2 * k];
        begin += length;
    }
    for (std::size_t k = 0; k + 1 < times.size() && times[k] < begin * (1 - 1e-9); ++k)
        of_pair += force[k] * (times[k + 1] - times[k]);
    ASSERT_GT(of_pair, 0.01);
    EXPECT_NEAR(of_nodes / of_pair, 1, 1e-9);
}

TEST(ForceDensity, BinsTimesWidthsGiveTheWholeForceWhateverTheBins) {
    Trace trace;
    trace.components = 2;
    trace.quantity = Quantity::force;
    trace.points = {{0, 0}, {0.5, 0.1}, {1, 1}, {1, 3}, {1, 3.5}};
    trace.along = {0, 0.51, 1.54, 3.54, 4.04};
    auto rows = std::make_shared<History>(trace_columns(trace));
    rows->append(std::vector<double>{0.1, 1, -2, 3, -4, 5, -6, 7, -8, 9, -10});
    trace.rows = rows;
    for (const auto along : {std::optional<std::size_t>(), std::optional<std::size_t>(1)})
        for (const int bins : {2, 7, 40}) {
            const ForceDensity radial = force_density(trace, 0, along, bins),
                               axial = force_density(trace, 1, along, bins);
            double sum = 0, other = 0;
            for (std::size_t b = 0; b < static_cast<std::size_t>(bins); ++b) {
                sum += radial.values[b] * (radial.edges[b + 1] - radial.edges[b]);
                other += axial.values[b] * (axial.edges[b + 1] - axial.edges[b]);
            }
            EXPECT_NEAR(sum, 25, 1e-9) << bins;
            EXPECT_NEAR(other, -30, 1e-9) << bins;
            EXPECT_EQ(radial.edges.size(), static_cast<std::size_t>(bins) + 1);
        }
    // A node's force lies around it: that of the last one above z = 3.25 only.
    const ForceDensity fine = force_density(trace, 0, 1, 14);
    EXPECT_NEAR(fine.values[13], 9 / 0.25, 1e-9);
}

}  // namespace
}  // namespace percuss
