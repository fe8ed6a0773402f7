#include <chrono>
#include <csignal>
#include <thread>

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "record/run_file.hpp"
#include "record/sample_run.hpp"

namespace percuss {
namespace {

[[noreturn]] void write_until_killed(const std::filesystem::path& file) {
    const auto setup = test::sample_setup();
    RunFileWriter writer(file, setup, test::sample_columns());
    History history(test::sample_columns());
    for (int frame = 0;; ++frame) {
        test::append_sample_rows(history, 37);
        writer.add_history(history);
        writer.add_frame(test::sample_snapshot(setup, frame));
    }
}

// A process that writes without pause is killed at moments spread over its work, most of them amid a frame.
TEST(KilledRun, IsReadableToItsLastCompleteFrame) {
    using namespace std::chrono_literals;
    const auto setup = test::sample_setup();
    std::int64_t most = 0;
    for (int attempt = 0; attempt < 12; ++attempt) {
        const test::TemporaryFolder folder;
        const auto file = folder.path() / "run.h5";
        const pid_t writer = fork();
        ASSERT_GE(writer, 0);
        if (writer == 0) write_until_killed(file);
        const bool wrote = test::wait_for_frames(file, 1);
        std::this_thread::sleep_for(attempt * 7777us);
        kill(writer, SIGKILL);
        int status = 0;
        ASSERT_EQ(waitpid(writer, &status, 0), writer);
        ASSERT_TRUE(wrote);
        ASSERT_TRUE(WIFSIGNALED(status)) << "the writer ended by itself";

        const RunFile run(file);
        most = std::max(most, run.frames());
        for (std::int64_t f = 0; f < run.frames(); ++f) {
            const Snapshot expected = test::sample_snapshot(setup, static_cast<int>(f));
            const auto frame = run.frame(f);
            ASSERT_EQ(frame->position, expected.position) << "frame " << f << " of " << run.frames();
            ASSERT_EQ(frame->stress, expected.stress) << "frame " << f;
            ASSERT_EQ(frame->contact_forces.size(), expected.contact_forces.size()) << "frame " << f;
            ASSERT_EQ(frame->energy.external, expected.energy.external) << "frame " << f;
        }
        const auto history = run.history();
        ASSERT_GE(history->rows(), 37 * static_cast<std::size_t>(run.frames()));
        History expected(test::sample_columns());
        test::append_sample_rows(expected, static_cast<int>(history->rows()));
        ASSERT_EQ(history->table(0, history->rows()), expected.table(0, expected.rows()));
    }
    EXPECT_GT(most, 2) << "the writers were killed before they wrote anything worth reading";
}

}  // namespace
}  // namespace percuss
