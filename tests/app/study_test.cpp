#include <chrono>
#include <sstream>
#include <thread>

#include "app/program_test.hpp"
#include "image.hpp"

namespace percuss {
namespace {

namespace fs = std::filesystem;
using test::Outcome;
using testing::HasSubstr;
using testing::Not;

/// Long enough to be killed: some seconds on any machine.
const std::string long_study = R"(
[[study.vary]]
key = "model.step.courant"
values = [0.9, 0.8, 0.7, 0.6, 0.5, 0.4]

[[study.quantity]]
of = "contact.impact.peak_force"

[[study.quantity]]
of = "contact.impact.y"
)";

class StudyTest : public test::ProgramTest {
  protected:
    using Table = std::vector<std::vector<std::string>>;
    [[nodiscard]] Table table(const std::string& directory) const {
        std::istringstream lines(test::text_of(path(directory) / "study.csv"));
        Table rows;
        for (std::string line; std::getline(lines, line);) {
            rows.emplace_back();
            std::istringstream cells(line);
            for (std::string cell; std::getline(cells, cell, ',');) rows.back().push_back(cell);
        }
        return rows;
    }
    /// Values and errors: all up to the times, which no two runs have alike.
    [[nodiscard]] Table answers(const std::string& directory) const {
        Table rows = table(directory);
        const auto times = std::find(rows[0].begin(), rows[0].end(), "seconds") - rows[0].begin();
        for (auto& row : rows) row.resize(static_cast<std::size_t>(times));
        return rows;
    }
    [[nodiscard]] std::vector<fs::path> results(const std::string& directory) const {
        std::vector<fs::path> found;
        if (!fs::exists(path(directory) / "cases")) return found;
        for (const auto& entry : fs::directory_iterator(path(directory) / "cases"))
            if (entry.path().extension() == ".json" && entry.path().filename().string()[0] != '.')
                found.push_back(entry.path());
        std::sort(found.begin(), found.end());
        return found;
    }
};

TEST_F(StudyTest, OnePageOfAGrid) {
    const Outcome outcome = run({"study", "scene.toml", "--vary", "model.step.courant=0.9,0.3", "--vary",
                                 "scheme=projection,joint", "--quantity", "contact.impact.peak_force",
                                 "--quantity", "body.striker.velocity.y=-0.4", "--out", "out"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const Table rows = table("out");
    ASSERT_EQ(rows.size(), 5U);
    EXPECT_EQ(rows[0][0], "model.step.courant");
    // The numbers are those of the runs themselves.
    ASSERT_EQ(run({"run", "scene.toml", "--out", "single", "--no-render", "--set", "model.step.courant=0.3",
                   "--set", "contact_solver.scheme=joint"})
                  .status,
              0);
    const auto summary = this->summary("single");
    EXPECT_EQ(rows[4][0] + rows[4][1] + rows[4][2], "0.3jointfinished");
    EXPECT_NEAR(std::stod(rows[4][3]), summary["contact"]["impact"]["peak_force"].get<double>(), 1e-8);
    const double velocity = summary["body"]["striker"]["velocity"]["y"].get<double>();
    EXPECT_NEAR(std::stod(rows[4][6]), std::abs(velocity + 0.4) / 0.4, 1e-8);
    const std::string page = test::text_of(path("out/study.html"));
    EXPECT_THAT(page, HasSubstr("<img alt=\"Error against time\" src=\"data:image/png;base64,iVBORw0KGgo"));
    EXPECT_THAT(page, HasSubstr("At step 0.9, projection a run takes"));
    EXPECT_THAT(page, Not(HasSubstr("<script")));
    EXPECT_THAT(page, Not(HasSubstr("http")));
    EXPECT_GT(render::read_png(path("out/cost.png")).pixels.size(), 1000U);
    EXPECT_THAT(outcome.out, HasSubstr("out/study.html"));
}

TEST_F(StudyTest, WhatIsThereIsNotRunAgain) {
    write("scene.toml", test::small_scene + long_study);
    ASSERT_EQ(run({"study", "scene.toml", "--out", "out"}).status, 0);
    const Table first = answers("out");
    const auto there = results("out");
    ASSERT_EQ(there.size(), 6U);
    for (std::size_t i = 0; i < there.size(); i += 2) fs::remove(there[i]);
    const auto kept = fs::last_write_time(there[1]);
    const Outcome again = run({"study", "scene.toml", "--out", "out"});
    ASSERT_EQ(again.status, 0) << again.err;
    EXPECT_THAT(again.err, HasSubstr("3 of 6 cases are there already"));
    EXPECT_EQ(answers("out"), first);
    EXPECT_EQ(fs::last_write_time(there[1]), kept);
    // Half a result is none.
    std::ofstream(there[2]) << "{\"state\":\"finished\",";
    EXPECT_THAT(run({"study", "scene.toml", "--out", "out"}).err,
                HasSubstr("5 of 6 cases are there already"));
    EXPECT_EQ(answers("out"), first);
    // A changed scene has nothing in common with it.
    write("scene.toml", test::small_scene + long_study + "# changed\n");
    EXPECT_THAT(run({"study", "scene.toml", "--out", "out"}).err, Not(HasSubstr("already")));
}

TEST_F(StudyTest, AKilledStudyGoesOn) {
    using namespace std::chrono_literals;
    write("scene.toml", test::small_scene + long_study);
    // Long enough cases that the kill comes between.
    const std::vector<std::string> command{"study", "scene.toml",       "--out",  "out",
                                           "--set", "model.duration=2", "--jobs", "1"};
    {
        test::Program program(folder_.path(), command);
        for (int i = 0; i < 3000 && results("out").empty(); ++i) std::this_thread::sleep_for(10ms);
        program.send(SIGKILL);
        EXPECT_EQ(program.wait().status, 128 + SIGKILL);
    }
    std::this_thread::sleep_for(300ms);
    const std::size_t there = results("out").size();
    EXPECT_GE(there, 1U);
    EXPECT_LT(there, 6U);
    EXPECT_FALSE(exists("out/study.csv"));
    std::this_thread::sleep_for(500ms);
    EXPECT_EQ(results("out").size(), there) << "its cases ended with it";
    const Outcome on = run(command);
    ASSERT_EQ(on.status, 0) << on.err;
    EXPECT_THAT(on.err, HasSubstr(std::to_string(there) + " of 6 cases are there already"));
    auto whole = command;
    whole[3] = "whole";
    ASSERT_EQ(run(whole).status, 0);
    EXPECT_EQ(answers("out"), answers("whole"));
}

TEST_F(StudyTest, AnInterruptedStudySaysHowToGoOn) {
    using namespace std::chrono_literals;
    write("scene.toml", test::small_scene + long_study);
    test::Program program(
        folder_.path(), {"study", "scene.toml", "--out", "out", "--set", "model.duration=5", "--jobs", "1"});
    for (int i = 0; i < 1000 && !exists("out/plan.json"); ++i) std::this_thread::sleep_for(10ms);
    std::this_thread::sleep_for(100ms);
    program.send(SIGTERM);
    const Outcome outcome = program.wait();
    EXPECT_EQ(outcome.status, 130);
    EXPECT_THAT(outcome.err, HasSubstr("the same command goes on"));
}

TEST_F(StudyTest, ACaseThatFailsIsARowAndTheOthersAreRunAllTheSame) {
    // Above the critical step of this mesh, which shows when the case is built.
    const Outcome outcome = run({"study", "scene.toml", "--vary", "model.step.fixed=1e-5,1,2e-5",
                                 "--quantity", "contact.impact.peak_force", "--out", "out"});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_THAT(outcome.err, HasSubstr("fixed 1: refused: "));
    const Table rows = table("out");
    EXPECT_EQ(rows[1][1], "finished");
    EXPECT_EQ(rows[2][1], "refused");
    EXPECT_EQ(rows[3][1], "finished");
    EXPECT_THAT(test::text_of(path("out/study.html")), HasSubstr("Cases that did not finish"));
}

TEST_F(StudyTest, AProcessThatLeavesNoResultIsAFailedCase) {
    const std::vector<std::string> command{"study",      "scene.toml", "--vary", "model.step.courant=0.9,0.5",
                                           "--quantity", "steps",      "--out",  "out"};
    ASSERT_EQ(run(command).status, 0);
    // Its result cannot be written where a directory is.
    const fs::path blocked = results("out")[0];
    fs::remove(blocked);
    fs::create_directories(blocked / "in the way");
    const Outcome outcome = run(command);
    EXPECT_EQ(outcome.status, 1);
    EXPECT_THAT(outcome.err, HasSubstr("failed: ended with exit status 1: percuss: "));
    fs::remove_all(blocked);
    EXPECT_EQ(run(command).status, 0) << "a failed case is tried again";
}

/// Debian's sbatch as far as a study uses it: --parsable --wait, and the array in this shell.
const char* const sbatch = R"(#!/bin/sh
for script; do :; done
count=$(sed -n 's/^#SBATCH --array=1-\([0-9]*\).*/\1/p' "$script")
echo 4711
i=1
while [ "$i" -le "$count" ]; do
  SLURM_ARRAY_TASK_ID=$i sh "$script"
  i=$((i + 1))
done
)";

TEST_F(StudyTest, ASlurmArrayGivesTheSameTable) {
    write("scene.toml", test::small_scene + long_study);
    ASSERT_EQ(run({"study", "scene.toml", "--out", "local"}).status, 0);
    fs::create_directory(path("bin"));
    write("bin/sbatch", sbatch);
    fs::permissions(path("bin/sbatch"), fs::perms::owner_all);
    const std::string before = getenv("PATH");
    setenv("PATH", (path("bin").string() + ":" + before).c_str(), 1);
    const Outcome outcome = run({"study", "scene.toml", "--out", "slurm", "--executor", "slurm"});
    setenv("PATH", before.c_str(), 1);
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(answers("slurm"), answers("local"));
    EXPECT_THAT(test::text_of(path("slurm/slurm.sh")), HasSubstr("#SBATCH --array=1-6\n"));
}

TEST_F(StudyTest, ARunChoosesStepAndMeshByTheStudy) {
    const auto with = [](double tolerance) {
        return test::small_scene + std::string(R"([[study.vary]]
key = "model.step.courant"
values = [0.9, 0.3]
[[study.vary]]
key = "scheme"
values = ["projection", "joint"]
[[study.quantity]]
of = "steps"
exact = 479
[accuracy]
target = { quantity = "steps", tolerance = )") +
               std::to_string(tolerance) + " }\n";
    };
    write("scene.toml", with(0.01));
    ASSERT_EQ(run({"study", "scene.toml"}).status, 0);
    const Outcome fine = run({"run", "scene.toml", "--out", "fine", "--no-render"});
    ASSERT_EQ(fine.status, 0) << fine.err;
    EXPECT_THAT(fine.err, HasSubstr("2 of 2 cases are there already")) << "the study's cases count";
    EXPECT_THAT(fine.out, HasSubstr("accuracy: step 0.3, of 2 cases"));
    EXPECT_EQ(summary("fine")["steps"], 479);
    EXPECT_EQ(summary("fine")["accuracy"]["chosen"], "step 0.3");
    write("scene.toml", with(1));
    const Outcome coarse = run({"run", "scene.toml", "--out", "coarse", "--no-render"});
    ASSERT_EQ(coarse.status, 0) << coarse.err;
    EXPECT_LT(summary("coarse")["steps"], 200);
    // What is set is not chosen.
    const Outcome set =
        run({"run", "scene.toml", "--out", "set", "--no-render", "--set", "model.step.courant=0.5"});
    EXPECT_THAT(set.out, Not(HasSubstr("accuracy")));
    EXPECT_FALSE(summary("set").contains("accuracy"));
    const Outcome none = run({"run", "scene.toml", "--out", "none", "--no-render", "--set",
                              "model.duration=0.025", "--set", "accuracy.target.tolerance=1e-6"});
    EXPECT_THAT(none.err, HasSubstr("none is within"));
}

TEST_F(StudyTest, WithoutSlurmItSaysSo) {
    write("scene.toml", test::small_scene + long_study);
    const std::string before = getenv("PATH");
    setenv("PATH", path("nowhere").c_str(), 1);
    const Outcome outcome = run({"study", "scene.toml", "--out", "out", "--executor", "slurm"});
    setenv("PATH", before.c_str(), 1);
    EXPECT_EQ(outcome.status, 1);
    EXPECT_THAT(outcome.err, HasSubstr("sbatch: cannot be started"));
}

TEST_F(StudyTest, ToldWhatIsWrong) {
    const auto complaint = [&](std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), {"study", "scene.toml"});
        if (std::find(arguments.begin(), arguments.end(), "--out") == arguments.end())
            arguments.insert(arguments.end(), {"--out", "out"});
        const Outcome outcome = run(arguments);
        EXPECT_EQ(outcome.status, 2) << outcome.out;
        return outcome.err;
    };
    EXPECT_THAT(complaint({}), HasSubstr("nothing is varied; add --vary KEY=VALUE,VALUE"));
    EXPECT_THAT(complaint({"--vary", "model.step.courant"}), HasSubstr("write KEY=VALUE,VALUE"));
    EXPECT_THAT(complaint({"--vary", "model.step.corant=0.5,0.9"}), HasSubstr("did you mean 'courant'?"));
    EXPECT_THAT(complaint({"--vary", "model.step.courant=0.5,1.5"}),
                HasSubstr("no case can be read with model.step.courant=1.5"));
    EXPECT_THAT(complaint({"--vary", "scheme=joint,projektion"}), HasSubstr("did you mean 'projection'?"));
    EXPECT_THAT(complaint({"--vary", "model.step.courant=0.5,0.9", "--quantity", "steps=many"}),
                HasSubstr("write PATH or PATH=NUMBER"));
    EXPECT_FALSE(exists("out"));
    fs::create_directory(path("full"));
    write("full/note.txt", "mine");
    EXPECT_THAT(complaint({"--vary", "model.step.courant=0.5,0.9", "--out", "full"}),
                HasSubstr("is not empty and holds no study"));
    // Told after the first case.
    EXPECT_THAT(
        complaint({"--vary", "model.step.courant=0.5,0.9", "--quantity", "contact.impact.peek_force"}),
        HasSubstr("the nearest is 'contact.impact.peak_force'"));
}

TEST_F(StudyTest, ListsTheCasesOfTheScenesThatProposeAStudy) {
    for (const char* scene : {"rods", "nail"}) {
        const Outcome outcome =
            run({"study", std::string(PERCUSS_SOURCE_DIR) + "/scenes/" + scene + ".toml", "--list"});
        EXPECT_EQ(outcome.status, 0) << outcome.err;
        EXPECT_THAT(outcome.out, HasSubstr(std::string("cases into out/") + scene + "-study"));
        EXPECT_THAT(outcome.out, Not(HasSubstr("cannot be read")));
        EXPECT_FALSE(exists("out"));
    }
}

TEST_F(StudyTest, HelpExplainsIt) {
    EXPECT_THAT(run({"--help"}).out, HasSubstr("percuss study scenes/rods.toml"));
    const std::string help = run({"study", "--help"}).out;
    for (const char* text : {"--vary", "--executor", "Richardson", "killed study", "Examples:"})
        EXPECT_THAT(help, HasSubstr(text));
    EXPECT_THAT(run({"--help"}).out, Not(HasSubstr("study-case")));
}

}  // namespace
}  // namespace percuss
