#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "record/run_file.hpp"
#include "record/sample_run.hpp"

namespace percuss {
namespace {

Trace sample_trace(const std::string& name, std::size_t components, int rows) {
    Trace trace;
    trace.name = name;
    trace.quantity = components == 2 ? Quantity::force : Quantity::stress;
    trace.components = components;
    trace.points = {{0, 0.5}, {1, 1.5}, {0.25, 2.5}};
    trace.along = {0, 1.5, 2.75};
    auto history = std::make_shared<History>(trace_columns(trace));
    for (int f = 0; f < rows; ++f) {
        std::vector<double> row{0.5 * f};
        for (std::size_t k = 0; k < 3 * components; ++k) row.push_back(f + 0.125 * static_cast<double>(k));
        history->append(row);
    }
    trace.rows = history;
    return trace;
}

TEST(RunFileTraces, ComeBackBitByBit) {
    const test::TemporaryFolder folder;
    const auto file = folder.path() / "run.h5";
    const auto setup = test::sample_setup();
    const std::vector<Trace> traces{sample_trace("waves", 1, 200), sample_trace("along-nail", 2, 3)};
    {
        RunFileWriter writer(file, setup, test::sample_columns(), traces);
        History history(test::sample_columns());
        test::append_sample_rows(history, 2);
        writer.add_history(history);
        writer.finish("{}");
    }
    const std::vector<Trace> read = RunFile(file).traces();
    ASSERT_EQ(read.size(), 2U);
    for (std::size_t k = 0; k < 2; ++k) {
        EXPECT_EQ(read[k].name, traces[k].name);
        EXPECT_EQ(read[k].quantity, traces[k].quantity);
        EXPECT_EQ(read[k].components, traces[k].components);
        EXPECT_EQ(read[k].points, traces[k].points);
        EXPECT_EQ(read[k].along, traces[k].along);
        const std::size_t rows = traces[k].rows->rows();
        ASSERT_EQ(read[k].rows->rows(), rows);
        EXPECT_EQ(read[k].rows->table(0, rows), traces[k].rows->table(0, rows));
    }
}

TEST(RunFileTraces, ARunWithoutThemHasNone) {
    const test::TemporaryFolder folder;
    const auto file = folder.path() / "run.h5";
    { const RunFileWriter writer(file, test::sample_setup(), test::sample_columns()); }
    EXPECT_TRUE(RunFile(file).traces().empty());
}

TEST(RunFileFrames, KeepTimesAndEnergiesOfBodies) {
    const test::TemporaryFolder folder;
    const auto file = folder.path() / "run.h5";
    const auto setup = test::sample_setup();
    {
        RunFileWriter writer(file, setup, test::sample_columns());
        for (int f = 0; f < 3; ++f) {
            Snapshot snapshot = test::sample_snapshot(setup, f);
            snapshot.body_energies = {{1. + f, 2, 3, 4, 5}, {6, 7, 8, 9, 10. * f}};
            writer.add_frame(snapshot);
        }
    }
    const RunFile run(file);
    EXPECT_THAT(run.frame_times(), testing::ElementsAre(0, 0.1 * 1, 0.1 * 2));
    const auto frame = run.frame(2);
    ASSERT_EQ(frame->body_energies.size(), 2U);
    EXPECT_EQ(frame->body_energies[0].kinetic, 3);
    EXPECT_EQ(frame->body_energies[0].elastic, 2);
    EXPECT_EQ(frame->body_energies[1].plastic, 8);
    EXPECT_EQ(frame->body_energies[1].viscous, 20);
}

}  // namespace
}  // namespace percuss
