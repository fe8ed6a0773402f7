#include "run/engine.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/run/change_values.hpp"
#include "engine/scene/small_scene.hpp"
#include "solver.hpp"

namespace percuss {
namespace {

using percuss::testing::small_scene;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

Scene small(const std::vector<std::string>& overrides = {}, const std::string& text = small_scene) {
    return parse_scene(text, "small.toml", overrides);
}

/// A rod squeezed between its held top and a bottom driven into it.
Scene squeezed(double velocity, const std::vector<std::string>& overrides = {}) {
    std::string text = small_scene.substr(0, small_scene.find("[[contact]]"));
    text += "[[body.prescribed]]\nedge = \"face\"\ndirection = \"axial\"\nvelocity = " +
            std::to_string(velocity) + "\n";
    return parse_scene(text, "squeezed.toml", overrides);
}

/// Waits until a run has made that many steps, ten seconds at most.
::testing::AssertionResult has_run(Engine& engine, std::size_t steps) {
    const auto latest = std::chrono::steady_clock::now() + std::chrono::seconds(10);
    while (engine.history()->rows() < steps) {
        if (std::chrono::steady_clock::now() > latest)
            return ::testing::AssertionFailure() << engine.snapshot()->message;
        std::this_thread::yield();
    }
    return ::testing::AssertionSuccess();
}

/// Messages count elements in their body, snapshots in the mesh.
bool names_the_failed_element(const Snapshot& s) {
    for (const MeshBody& body : s.setup->mesh.bodies)
        if (s.failed_cell >= body.cell_begin && s.failed_cell < body.cell_end)
            return s.message.find("element " + std::to_string(s.failed_cell - body.cell_begin) +
                                  " of body '" + body.name + "'") != std::string::npos;
    return false;
}

bool finite(const Snapshot& snapshot) {
    const auto good = [](double x) { return std::isfinite(x); };
    return std::all_of(snapshot.position.begin(), snapshot.position.end(), good) &&
           std::all_of(snapshot.velocity.begin(), snapshot.velocity.end(), good) &&
           std::all_of(snapshot.stress.begin(), snapshot.stress.end(),
                       [&](const StressMean& s) { return std::all_of(s.begin(), s.end(), good); });
}

TEST(Engine, StartsPausedAtZeroWithASnapshot) {
    Engine engine(small());
    engine.wait();
    const auto snapshot = engine.snapshot();
    EXPECT_EQ(engine.status(), RunStatus::paused);
    EXPECT_EQ(snapshot->step, 0);
    EXPECT_EQ(snapshot->time, 0);
    EXPECT_EQ(engine.history()->rows(), 0U);
    EXPECT_EQ(snapshot->position.size(), 2 * snapshot->setup->mesh.nodes.size());
}

TEST(Engine, RunsToTheEndAndStaysThere) {
    Engine engine(small());
    engine.post(command::Run{});
    engine.wait();
    const auto last = engine.snapshot();
    EXPECT_EQ(engine.status(), RunStatus::finished);
    EXPECT_EQ(last->status, RunStatus::finished);
    EXPECT_GE(last->time, 0.1 * (1 - 1e-12));
    EXPECT_EQ(engine.history()->rows(), static_cast<std::size_t>(last->step)) << "one row a step";
    EXPECT_EQ(engine.statistics().steps, last->step);
    EXPECT_EQ(engine.statistics().state_hash.size(), 16U);

    engine.post(command::Run{});
    engine.wait();
    EXPECT_EQ(engine.snapshot()->step, last->step);
    EXPECT_THAT(engine.take_messages(), ElementsAre(HasSubstr("the run has ended")));
    EXPECT_THAT(engine.take_messages(), ElementsAre()) << "taken";
}

TEST(Engine, StepsAddUpHoweverTheyArrive) {
    Engine engine(small());
    engine.post(command::Steps{});
    engine.wait();
    EXPECT_EQ(engine.snapshot()->step, 1);
    for (int k = 0; k < 10; ++k) engine.post(command::Steps{3});
    engine.wait();
    EXPECT_EQ(engine.snapshot()->step, 31);
    engine.post(command::Steps{0});
    engine.post(command::Steps{-2});
    engine.wait();
    EXPECT_EQ(engine.snapshot()->step, 31);
    EXPECT_EQ(engine.status(), RunStatus::paused);
}

TEST(Engine, RunsUntilATimeAndNotBeyond) {
    Engine engine(small());
    engine.post(command::Run{0.01});
    engine.wait();
    const auto there = engine.snapshot();
    EXPECT_EQ(engine.status(), RunStatus::paused);
    EXPECT_GE(there->time, 0.01 * (1 - 1e-12));
    EXPECT_LT(there->time - there->dt, 0.01);
    engine.post(command::Run{0.01});
    engine.post(command::Run{0.005});
    engine.wait();
    EXPECT_EQ(engine.snapshot()->step, there->step) << "that time has been reached";
    engine.post(command::Run{});
    engine.wait();
    EXPECT_EQ(engine.status(), RunStatus::finished);
}

TEST(Engine, PausesInFlightAndGoesOnWithoutATrace) {
    Engine engine(small({"model.duration=2"}));
    engine.post(command::Run{});
    ASSERT_TRUE(has_run(engine, 50));
    engine.post(command::Pause{});
    engine.wait();
    const auto paused = engine.snapshot();
    EXPECT_EQ(engine.status(), RunStatus::paused);
    EXPECT_EQ(paused->step, static_cast<std::int64_t>(engine.history()->rows()));
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    EXPECT_EQ(engine.history()->rows(), static_cast<std::size_t>(paused->step)) << "it stands";
    engine.post(command::Steps{200});
    engine.wait();

    Solver alone(small({"model.duration=2"}));
    for (std::int64_t k = 0; k < paused->step + 200; ++k) ASSERT_FALSE(alone.step());
    EXPECT_EQ(engine.statistics().state_hash, alone.statistics().state_hash) << "pausing changes nothing";
}

TEST(Engine, ResetBeginsANewRun) {
    Engine engine(small());
    engine.post(command::Steps{40});
    engine.wait();
    const auto before = engine.history();
    const std::string hash = engine.statistics().state_hash;
    engine.post(command::Reset{});
    engine.wait();
    EXPECT_EQ(engine.snapshot()->step, 0);
    EXPECT_EQ(engine.status(), RunStatus::paused);
    EXPECT_EQ(engine.history()->rows(), 0U);
    EXPECT_EQ(before->rows(), 40U) << "the old history still belongs to its holder";
    engine.post(command::Steps{40});
    engine.wait();
    EXPECT_EQ(engine.statistics().state_hash, hash);
}

TEST(Engine, SnapshotsDoNotChange) {
    Engine engine(small());
    engine.post(command::Steps{10});
    engine.wait();
    const auto held = engine.snapshot();
    const Snapshot copy = *held;
    engine.post(command::Run{});
    engine.wait();
    engine.post(command::Reset{});
    engine.wait();
    EXPECT_EQ(held->step, 10);
    EXPECT_EQ(held->position, copy.position);
    EXPECT_EQ(held->velocity, copy.velocity);
    EXPECT_EQ(held->stress, copy.stress);
    EXPECT_EQ(held->energy.kinetic, copy.energy.kinetic);
}

TEST(Engine, GivesAFrameAtEveryMultipleOfTheIntervalAndAtTheEnd) {
    std::vector<std::shared_ptr<const Snapshot>> frames;
    EngineOptions options;
    options.frame_interval = 0.01;
    options.on_frame = [&](auto frame) { frames.push_back(std::move(frame)); };
    Engine engine(small(), options);
    // Commands in between lose and repeat nothing.
    for (int k = 0; k < 30; ++k) engine.post(command::Steps{5});
    engine.wait();
    engine.post(command::Run{0.03});
    engine.wait();
    engine.post(command::Run{});
    engine.wait();
    ASSERT_EQ(frames.size(), 11U);
    for (std::size_t k = 0; k < frames.size(); ++k) {
        const double due = 0.01 * static_cast<double>(k);
        EXPECT_GE(frames[k]->time, due * (1 - 1e-9));
        EXPECT_LT(frames[k]->time - frames[k]->dt, std::max(due, 1e-12)) << "the first step that reaches it";
    }
    EXPECT_EQ(frames.back()->status, RunStatus::finished);
}

TEST(Engine, AnIntervalSmallerThanAStepGivesEveryStepOnce) {
    std::vector<std::int64_t> steps;
    EngineOptions options;
    options.frame_interval = 1e-7;
    options.on_frame = [&](const auto& frame) { steps.push_back(frame->step); };
    Engine engine(small({"model.duration=0.002"}), options);
    engine.post(command::Run{});
    engine.wait();
    ASSERT_EQ(steps.size(), static_cast<std::size_t>(engine.snapshot()->step) + 1);
    for (std::size_t k = 0; k < steps.size(); ++k) EXPECT_EQ(steps[k], static_cast<std::int64_t>(k));
}

TEST(Engine, FramesFallOnStepsThatReachTheirTimeUpToRounding) {
    std::vector<std::int64_t> steps;
    EngineOptions options;
    options.frame_interval = 1e-3;
    options.on_frame = [&](const auto& frame) { steps.push_back(frame->step); };
    Engine engine(small({"model.step={ fixed = 1e-4 }", "model.duration=0.05"}), options);
    engine.post(command::Run{});
    engine.wait();
    ASSERT_EQ(steps.size(), 51U);
    for (std::size_t k = 0; k < steps.size(); ++k) EXPECT_EQ(steps[k], static_cast<std::int64_t>(10 * k));
}

// Steps that jumped over frame times must not be made up for by a burst of frames when they become smaller.
TEST(Engine, JumpedFramesAreNotMadeUpFor) {
    int frames = 0;
    EngineOptions options;
    options.frame_interval = 1e-5;
    options.on_frame = [&](const auto&) { ++frames; };
    Engine engine(small({"model.step={ fixed = 1e-4 }"}), options);
    engine.post(command::Steps{20});
    engine.wait();
    EXPECT_EQ(frames, 20);
    engine.post(command::Set{"model.step.fixed", "1e-6"});
    engine.post(command::Steps{101});
    engine.wait();
    EXPECT_EQ(frames, 20 + 11);
}

TEST(Engine, ASlowReceiverOfFramesSlowsTheRunAndLosesNone) {
    int frames = 0;
    EngineOptions options;
    options.frame_interval = 0.01;
    options.on_frame = [&](const auto&) {
        std::this_thread::sleep_for(std::chrono::milliseconds(3));
        ++frames;
    };
    Engine engine(small(), options);
    engine.post(command::Run{});
    engine.wait();
    EXPECT_EQ(frames, 11);
}

TEST(Engine, AnExceptionInAFrameEndsTheRunWithItsMessage) {
    EngineOptions options;
    options.frame_interval = 0.01;
    options.on_frame = [](const auto& frame) {
        if (frame->time > 0.02) throw std::runtime_error("no space left on device");
    };
    Engine engine(small(), options);
    engine.post(command::Run{});
    engine.wait();
    EXPECT_EQ(engine.status(), RunStatus::diverged);
    EXPECT_EQ(engine.snapshot()->message, "no space left on device");
    EXPECT_TRUE(finite(*engine.snapshot()));
    EXPECT_LT(engine.snapshot()->time, 0.03);
    engine.post(command::Reset{});
    engine.post(command::Run{});
    engine.wait();
    EXPECT_EQ(engine.status(), RunStatus::finished) << "the program goes on";
}

TEST(Engine, ABadSettingLeavesTheRunAsItWas) {
    Engine engine(small());
    engine.post(command::Steps{7});
    engine.wait();
    engine.post(command::Set{"model.step.corant", "0.5"});
    engine.post(command::Set{"model.step.courant", "1.5"});
    engine.post(command::Set{"model.step.fixed", "1"});
    engine.post(command::Set{"material.steel.young", "-1"});
    engine.wait();
    const auto messages = engine.take_messages();
    ASSERT_GE(messages.size(), 4U);
    EXPECT_THAT(messages[0], HasSubstr("courant"));
    EXPECT_EQ(engine.snapshot()->step, 7);
    EXPECT_EQ(engine.history()->rows(), 7U);
    engine.post(command::Steps{1});
    engine.wait();
    Solver alone(small());
    for (int k = 0; k < 8; ++k) ASSERT_FALSE(alone.step());
    EXPECT_EQ(engine.statistics().state_hash, alone.statistics().state_hash) << "nothing of them was kept";
}

TEST(Engine, TheTimeStepChangesInFlight) {
    Engine engine(small());
    engine.post(command::Steps{5});
    engine.wait();
    engine.post(command::Set{"model.step.courant", "0.25"});
    engine.post(command::Steps{5});
    engine.wait();
    const auto dt = engine.history()->values("step.dt");
    const auto critical = engine.history()->values("step.critical");
    ASSERT_EQ(dt.size(), 10U) << "the run was not reset";
    EXPECT_NEAR(dt.back() / critical.back(), 0.25, 1e-12);
    EXPECT_NEAR(dt.front() / critical.front(), 0.5, 1e-12);
}

TEST(Engine, AMaterialValueResetsTheRun) {
    Engine engine(small());
    engine.post(command::Steps{5});
    engine.wait();
    const double before = engine.snapshot()->critical_step;
    engine.post(command::Set{"material.steel.young", "52.5"});
    engine.wait();
    EXPECT_EQ(engine.snapshot()->step, 0);
    EXPECT_EQ(engine.history()->rows(), 0U);
    EXPECT_NEAR(engine.snapshot()->critical_step, 2 * before, 1e-3 * before) << "half the wave speed";
    engine.post(command::Reset{});
    engine.post(command::Steps{1});
    engine.wait();
    EXPECT_NEAR(engine.snapshot()->critical_step, 2 * before, 1e-3 * before) << "a reset keeps what was set";
}

TEST(Engine, AnInvertedElementEndsTheRunAtItsLastGoodStep) {
    std::vector<RunStatus> frames;
    EngineOptions options;
    options.on_frame = [&](const auto& frame) { frames.push_back(frame->status); };
    Engine engine(squeezed(500, {"model.energy_growth_limit=1e9"}), options);
    engine.post(command::Run{});
    engine.wait();
    const auto last = engine.snapshot();
    EXPECT_EQ(engine.status(), RunStatus::diverged);
    EXPECT_THAT(last->message, HasSubstr("element "));
    EXPECT_THAT(last->message, HasSubstr("of body 'rod' turned inside out at "));
    EXPECT_TRUE(names_the_failed_element(*last));
    EXPECT_TRUE(finite(*last));
    EXPECT_GT(last->step, 0);
    EXPECT_GE(last->step + 3, static_cast<std::int64_t>(engine.history()->rows()))
        << "not far before the failure";
    EXPECT_THAT(frames, ElementsAre(RunStatus::diverged)) << "the last state is a frame too";
    for (const double time : engine.history()->table(0, engine.history()->rows()))
        ASSERT_TRUE(std::isfinite(time));
    engine.post(command::Run{});
    engine.wait();
    EXPECT_EQ(engine.take_messages().size(), 1U);
}

TEST(Engine, EnergyGrowthEndsTheRun) {
    const std::string lagged = percuss::testing::changed(
        small_scene, "duration = 0.1", "duration = 0.1\nlagged = true\nenergy_growth_limit = 1e-3");
    Engine engine(small({"model.step.courant=0.95"}, lagged));
    engine.post(command::Run{});
    engine.wait();
    ASSERT_EQ(engine.status(), RunStatus::diverged);
    EXPECT_THAT(engine.snapshot()->message, HasSubstr("energy grew by "));
    EXPECT_THAT(engine.snapshot()->message, HasSubstr("element "));
    EXPECT_THAT(engine.snapshot()->message, HasSubstr("of body '"));
    EXPECT_TRUE(names_the_failed_element(*engine.snapshot()));
    EXPECT_TRUE(finite(*engine.snapshot()));
    const auto times = engine.history()->values("time");
    EXPECT_TRUE(std::adjacent_find(times.begin(), times.end(), std::greater_equal<>()) == times.end())
        << "no row twice";
}

// A fixed step that the deforming mesh overtakes: found before the step is made.
TEST(Engine, AStepAboveTheCriticalOneEndsTheRun) {
    Engine engine(squeezed(500, {"model.energy_growth_limit=1e9"}));
    engine.post(command::Steps{1});
    engine.wait();
    engine.post(command::Set{"model.step",
                             "{ fixed = " + std::to_string(0.99 * engine.snapshot()->critical_step) + " }"});
    engine.post(command::Run{});
    engine.wait();
    ASSERT_EQ(engine.status(), RunStatus::diverged) << ::testing::PrintToString(engine.take_messages());
    EXPECT_THAT(engine.snapshot()->message, HasSubstr("the critical step fell to "));
    const auto times = engine.history()->values("time");
    EXPECT_TRUE(std::adjacent_find(times.begin(), times.end(), std::greater_equal<>()) == times.end())
        << "no row twice";
}

// Going back repeats the steps since the last copy of the state: the step size must be the same.
TEST(Engine, TheLastGoodStepIsTheOneThatWasMade) {
    const Scene scene = squeezed(5000, {"model.energy_growth_limit=1e9"});
    Engine engine(scene);
    engine.post(command::Steps{5});
    engine.wait();
    engine.post(command::Set{"model.step.courant", "0.3"});
    engine.post(command::Run{});
    engine.wait();
    ASSERT_EQ(engine.status(), RunStatus::diverged);

    Solver alone(scene);
    const std::int64_t last = engine.snapshot()->step;
    ASSERT_GT(last, 5);
    ASSERT_LT(last, 250) << "before the second copy";
    while (alone.steps() < last) {
        if (alone.steps() == 5) percuss::testing::change_step(alone, 0.3);
        ASSERT_FALSE(alone.step());
    }
    EXPECT_EQ(engine.statistics().state_hash, alone.statistics().state_hash);
}

TEST(Engine, NumbersBeyondAllMeasureEndTheRunAndStayOutOfTheHistory) {
    const std::string text =
        percuss::testing::changed(small_scene, "velocity = [0, 10]", "velocity = [0, 1e160]");
    Engine engine(small({}, text));
    engine.post(command::Run{});
    engine.wait();
    EXPECT_EQ(engine.status(), RunStatus::diverged);
    EXPECT_THAT(engine.snapshot()->message, HasSubstr("no longer finite at "));
    EXPECT_TRUE(finite(*engine.snapshot()));
    for (const double number : engine.history()->table(0, engine.history()->rows()))
        ASSERT_TRUE(std::isfinite(number));
}

TEST(Engine, EndsWhileRunning) {
    for (int round = 0; round < 5; ++round) {
        Engine engine(small({"model.duration=1000"}));
        engine.post(command::Run{});
        ASSERT_TRUE(has_run(engine, static_cast<std::size_t>(round)));
    }
}

TEST(Engine, StopEndsTheThreadAndLaterCommandsAreIgnored) {
    Engine engine(small({"model.duration=1000"}));
    engine.post(command::Run{});
    engine.post(command::Stop{});
    engine.post(command::Run{});
    engine.wait();
    EXPECT_EQ(engine.status(), RunStatus::paused);
    const auto rows = engine.history()->rows();
    engine.post(command::Steps{5});
    engine.wait();
    EXPECT_EQ(engine.history()->rows(), rows);
    EXPECT_EQ(engine.snapshot()->step, static_cast<std::int64_t>(rows));
}

// A window, a recorder and a script at once; under ThreadSanitizer this proves the absence of races.
TEST(Engine, IsReadAndCommandedFromManyThreads) {
    std::atomic<int> frames{0}, wrong{0};
    EngineOptions options;
    options.frame_interval = 0.001;
    options.on_frame = [&](const auto&) { ++frames; };
    Engine engine(small({"model.duration=0.2"}), options);
    std::atomic<bool> done{false};
    std::vector<std::thread> readers;
    for (int r = 0; r < 2; ++r) {
        readers.emplace_back([&] {
            while (!done) {
                const auto snapshot = engine.snapshot();
                if (!finite(*snapshot)) ++wrong;
                const auto history = engine.history();
                const auto times = history->values(0, 0, history->rows());
                if (!std::is_sorted(times.begin(), times.end())) ++wrong;
                if (engine.status() == RunStatus::finished &&
                    engine.snapshot()->status != RunStatus::finished)
                    ++wrong;
                static_cast<void>(engine.statistics());
                static_cast<void>(engine.take_messages());
            }
        });
    }
    std::vector<std::thread> commanders;
    for (int c = 0; c < 3; ++c) {
        commanders.emplace_back([&] {
            for (int k = 0; k < 40; ++k) engine.post(command::Steps{2});
        });
    }
    for (auto& thread : commanders) thread.join();
    engine.wait();
    EXPECT_EQ(engine.snapshot()->step, 240);
    engine.post(command::Run{});
    engine.wait();
    EXPECT_EQ(engine.status(), RunStatus::finished);
    done = true;
    for (auto& thread : readers) thread.join();
    EXPECT_EQ(wrong, 0);
    EXPECT_EQ(frames, 201);
}

TEST(Engine, RefusesASceneThatCannotRun) { EXPECT_THROW(Engine(small({"model.step.fixed=1"})), SceneError); }

}  // namespace
}  // namespace percuss
