#include <cmath>
#include <thread>

#include "app/program_test.hpp"
#include "record/run_file.hpp"

namespace percuss {
namespace {

using test::Outcome;
using test::text_of;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

class RunTest : public test::ProgramTest {};

TEST_F(RunTest, LeavesRecordHistorySummaryAndFrames) {
    const Outcome outcome =
        run({"run", "scene.toml", "--out", "out", "--frames", "0.005", "--set", "view.size=[320, 200]"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_THAT(files("out"), ElementsAre("frames/000000.png", "frames/000001.png", "frames/000002.png",
                                          "frames/000003.png", "frames/000004.png", "history.csv", "run.h5",
                                          "summary.json"));
    EXPECT_THAT(text_of(path("out/history.csv")), StartsWith("time [ms],"));
    EXPECT_THAT(text_of(path("out/history.csv")), HasSubstr("contact.impact.y [kN]"));
    const auto result = summary("out");
    EXPECT_EQ(result["status"], "finished");
    EXPECT_EQ(result["elements"], 3);
    EXPECT_GT(result["steps"], 50);
    EXPECT_GT(result["wall_seconds"]["render"], 0);
    EXPECT_GT(result["wall_seconds"]["record"], 0);
    EXPECT_GE(result["wall_seconds"]["total"], result["wall_seconds"]["render"]);
    EXPECT_THAT(outcome.out, HasSubstr("✓ steps is "));
    EXPECT_THAT(outcome.out, HasSubstr("out/summary.json"));
    EXPECT_THAT(outcome.err, HasSubstr("100 %"));  // no terminal: a line each tenth of the way
}

TEST_F(RunTest, RecordsWhatCanBeReadBack) {
    ASSERT_EQ(
        run({"run", "scene.toml", "--out", "out", "--no-render", "--set", "model.duration=0.03"}).status, 0);
    EXPECT_THAT(files("out"), ElementsAre("history.csv", "run.h5", "summary.json"));
    const RunFile record(path("out/run.h5"));
    EXPECT_EQ(record.setup()->scene.duration, 0.03);
    EXPECT_EQ(record.frames(), 101);  // by default a hundredth of the duration apart
    EXPECT_EQ(record.frame(0)->time, 0);
    EXPECT_NEAR(record.frame(record.frames() - 1)->time, 0.03, 2e-4);
    EXPECT_EQ(nlohmann::json::parse(record.summary()), summary("out"));
    const auto lines = text_of(path("out/history.csv"));
    EXPECT_EQ(static_cast<std::size_t>(std::count(lines.begin(), lines.end(), '\n')),
              record.history()->rows() + 1);
}

TEST_F(RunTest, KeepsEveryNthRowOfTheHistory) {
    const auto lines = [&](const std::string& every) {
        const Outcome outcome = run({"run", "scene.toml", "--out", "every-" + every, "--no-render", "--set",
                                     "record.history_every=" + every});
        EXPECT_EQ(outcome.status, 0) << outcome.err;
        const std::string text = text_of(path("every-" + every + "/history.csv"));
        return std::count(text.begin(), text.end(), '\n');
    };
    const auto rows = lines("1") - 1;  // without the header
    EXPECT_EQ(rows, summary("every-1")["steps"]);
    EXPECT_EQ(lines("4") - 1, (rows + 3) / 4);
    EXPECT_EQ(RunFile(path("every-4/run.h5")).history()->rows(), static_cast<std::size_t>((rows + 3) / 4));
}

TEST_F(RunTest, StepsWithTheThreadsAskedForToTheSameState) {
    if (std::thread::hardware_concurrency() < 2) GTEST_SKIP() << "this machine has one processor";
    std::string text = test::small_scene;  // more elements, so that a second thread is worth its while
    text.replace(text.find("divisions = [2, 1]"), 18, "divisions = [60, 52]");
    write("fine.toml", text);
    for (const std::string threads : {"1", "2"}) {
        const Outcome outcome = run({"run", "fine.toml", "--out", threads, "--no-render", "--threads",
                                     threads, "--set", "model.duration=1e-4"});
        ASSERT_EQ(outcome.status, 0) << outcome.err;
        EXPECT_EQ(summary(threads)["threads"], std::stoi(threads));
    }
    EXPECT_EQ(summary("1")["state_hash"], summary("2")["state_hash"]);
}

TEST_F(RunTest, SaysWhyItDivergedAndKeepsTheLastState) {
    // Half of the wave speed: the first elements to meet turn inside out.
    const Outcome outcome = run(
        {"run", "scene.toml", "--out", "out", "--no-render", "--set", "body.striker.velocity=[0, -3000]"});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_THAT(outcome.out, StartsWith("DIVERGED at "));
    const auto result = summary("out");
    EXPECT_EQ(result["status"], "diverged");
    const std::string message = result["message"];
    EXPECT_FALSE(message.empty());
    EXPECT_THAT(outcome.err, HasSubstr("percuss: " + message));
    const RunFile record(path("out/run.h5"));
    const auto last = record.frame(record.frames() - 1);
    EXPECT_EQ(last->status, RunStatus::diverged);
    EXPECT_EQ(last->message, message);
    EXPECT_TRUE(
        std::all_of(last->position.begin(), last->position.end(), [](double x) { return std::isfinite(x); }));
}

TEST_F(RunTest, RefusesToOverwriteWithoutForce) {
    std::filesystem::create_directories(path("out/frames"));
    write("out/mine.txt", "precious");
    write("out/frames/000777.png", "of an earlier run");
    write("out/frames/drawing.png", "precious");
    const Outcome refused = run({"run", "scene.toml", "--out", "out", "--no-render"});
    EXPECT_EQ(refused.status, 2);
    EXPECT_EQ(refused.err,
              "percuss: --out out: the directory is not empty; choose another, or replace the run in it "
              "with --force\n");
    EXPECT_THAT(files("out"), ElementsAre("frames/000777.png", "frames/drawing.png", "mine.txt"));

    const Outcome forced = run({"run", "scene.toml", "--out", "out", "--no-render", "--force"});
    EXPECT_EQ(forced.status, 0) << forced.err;
    EXPECT_THAT(files("out"),
                ElementsAre("frames/drawing.png", "history.csv", "mine.txt", "run.h5", "summary.json"));
    EXPECT_EQ(run({"run", "scene.toml", "--out", "out", "--no-render", "--force"}).status, 0);
}

TEST_F(RunTest, LeavesNoDirectoryBehindForABadScene) {
    write("bad.toml", std::string(test::small_scene) + "[wrong]\n");
    const Outcome outcome = run({"run", "bad.toml", "--out", "out"});
    EXPECT_EQ(outcome.status, 2);
    EXPECT_THAT(outcome.err, StartsWith("bad.toml:"));
    EXPECT_THAT(outcome.err, HasSubstr("wrong"));
    EXPECT_FALSE(exists("out"));
    EXPECT_EQ(run({"run", "scene.toml", "--out", "out", "--set", "model.step={fixed=1.0}"}).status,
              2);  // above critical
    EXPECT_FALSE(exists("out"));
    EXPECT_EQ(run({"run", "none.toml", "--out", "out"}).status, 2);
    EXPECT_FALSE(exists("out"));
    EXPECT_EQ(run({"run", "scene.toml", "--out", "out", "--set", "nonsense=1"}).status, 2);
    EXPECT_FALSE(exists("out"));
}

TEST_F(RunTest, TellsOfBrokenPromises) {
    const std::vector<std::string> command{"run",         "scene.toml", "--out", "out",
                                           "--no-render", "--force",    "--set", "expect.steps={max=1}"};
    const Outcome outcome = run(command);
    EXPECT_EQ(outcome.status, 0);
    EXPECT_THAT(outcome.out, HasSubstr("✗ steps is "));
    EXPECT_THAT(outcome.out, HasSubstr(", promised at most 1"));
    EXPECT_THAT(outcome.err, HasSubstr("percuss: warning: the run does not keep what its scene promises"));
    std::vector<std::string> strict = command;
    strict.emplace_back("--strict");
    EXPECT_EQ(run(strict).status, 3);
}

TEST_F(RunTest, JudgesPromisesOfASceneAsItIsWrittenOnly) {
    const Outcome changed = run({"run", "scene.toml", "--out", "out", "--no-render", "--force", "--set",
                                 "expect.steps={max=1}", "--set", "model.step.courant=0.5"});
    EXPECT_EQ(changed.status, 0);
    EXPECT_EQ(changed.out.find("promised"), std::string::npos);
    EXPECT_EQ(run({"run", "scene.toml", "--out", "out", "--no-render", "--force", "--strict", "--set",
                   "expect.steps={max=1}", "--set", "model.step.courant=0.5"})
                  .status,
              3);
}

TEST_F(RunTest, FailsWhereTheDiskFails) {
    write("file", "");
    const Outcome outcome = run({"run", "scene.toml", "--out", "file/out", "--no-render"});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_THAT(outcome.err, StartsWith("percuss: "));
    EXPECT_EQ(run({"run", "scene.toml", "--out", "file", "--no-render"}).status, 2);
}

TEST_F(RunTest, EndsCleanlyOnInterrupt) {
    test::Program program(folder_.path(),
                          {"run", "scene.toml", "--out", "out", "--no-render", "--set", "model.duration=1e5",
                           "--frames", "0.05", "--set", "record.history_every=100000"});
    ASSERT_TRUE(test::wait_for_frames(path("out/run.h5"), 3));
    program.send(SIGINT);
    const Outcome outcome = program.wait();
    EXPECT_EQ(outcome.status, 130) << outcome.err;
    EXPECT_THAT(outcome.out, StartsWith("interrupted at "));
    EXPECT_EQ(summary("out")["status"], "interrupted");
    const RunFile record(path("out/run.h5"));
    EXPECT_GT(record.frames(), 1);
    EXPECT_EQ(nlohmann::json::parse(record.summary()), summary("out"));
    EXPECT_EQ(record.frame(record.frames() - 1)->step, summary("out")["steps"]);
}

TEST_F(RunTest, KilledLeavesNoSummaryAndAReadableRecord) {
    // Not even that of an earlier run, which has fewer frames than are waited for.
    ASSERT_EQ(run({"run", "scene.toml", "--out", "out", "--no-render", "--frames", "0.02"}).status, 0);
    ASSERT_EQ(RunFile(path("out/run.h5")).frames(), 2);
    test::Program program(folder_.path(),
                          {"run", "scene.toml", "--out", "out", "--no-render", "--force", "--set",
                           "model.duration=1e5", "--frames", "0.05", "--set", "record.history_every=100000"});
    ASSERT_TRUE(test::wait_for_frames(path("out/run.h5"), 3));
    program.send(SIGKILL);
    EXPECT_EQ(program.wait().status, 128 + SIGKILL);
    EXPECT_THAT(files("out"), ElementsAre("run.h5"));
    EXPECT_GT(RunFile(path("out/run.h5")).frames(), 1);
    const Outcome drawn = run({"render", "out", "--frame", "0", "--frame", "-1", "--size", "320x200"});
    EXPECT_EQ(drawn.status, 0) << drawn.err;
    EXPECT_TRUE(exists("out/redrawn/000000.png"));
}

}  // namespace
}  // namespace percuss
