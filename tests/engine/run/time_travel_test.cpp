// Going back in a run, and on from there: every moment is the one that was, bit by bit.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/allocations.hpp"
#include "engine/run/change_values.hpp"
#include "engine/scene/small_scene.hpp"
#include "run/engine.hpp"
#include "run/state_history.hpp"
#include "solver.hpp"
#include "verification/kinds.hpp"

namespace percuss {
namespace {

using percuss::testing::changed;
using percuss::testing::Kind;
using percuss::testing::small_scene;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::SizeIs;

const std::string with_figures = small_scene + R"([[figure]]
name = "waves"
kind = "space-time"
body = "rod"
field = "stress.axial"
interval = 0.0003
[[figure]]
name = "faces"
kind = "surface-forces"
body = "rod"
edge = "face"
interval = 0.0007
)";

Scene small(const std::vector<std::string>& overrides = {}, const std::string& text = with_figures) {
    return parse_scene(text, "small.toml", overrides);
}

std::vector<double> all(const History& history) { return history.table(0, history.rows()); }

void go(Engine& engine, Command command) {
    engine.post(std::move(command));
    engine.wait();
}

/// @returns times of the history that is not later than the first `rows` steps.
double time_of_step(const Engine& engine, std::size_t step) { return engine.history()->values("time")[step]; }

/// Everything that two runs of one scene leave.
void expect_same_run(Engine& a, Engine& b) {
    EXPECT_EQ(a.snapshot()->step, b.snapshot()->step);
    EXPECT_EQ(a.statistics().state_hash, b.statistics().state_hash);
    EXPECT_EQ(all(*a.history()), all(*b.history()));
    ASSERT_EQ(a.traces().size(), b.traces().size());
    for (std::size_t k = 0; k < a.traces().size(); ++k)
        EXPECT_EQ(all(*a.traces()[k].rows), all(*b.traces()[k].rows)) << a.traces()[k].name;
    const RunStatistics s = a.statistics(), t = b.statistics();
    EXPECT_EQ(s.dt_min, t.dt_min);
    EXPECT_EQ(s.maximum_loss, t.maximum_loss);
    EXPECT_EQ(s.contact_solver.iterations, t.contact_solver.iterations);
    for (std::size_t p = 0; p < s.pairs.size(); ++p) {
        EXPECT_EQ(s.pairs[p].openings, t.pairs[p].openings);
        EXPECT_EQ(s.pairs[p].impulse, t.pairs[p].impulse);
        EXPECT_EQ(s.pairs[p].work, t.pairs[p].work);
    }
}

class TimeTravelOfEachKind : public ::testing::TestWithParam<Kind> {};

TEST_P(TimeTravelOfEachKind, ABranchWithoutChangesIsTheUninterruptedRun) {
    const Scene scene = GetParam().scene();
    const std::int64_t steps = std::min<std::int64_t>(GetParam().steps, 130);
    Engine whole(scene), travelled(scene);
    go(whole, command::Steps{steps});
    for (const double part : {0.9, 0.3, 0.7}) {
        go(travelled, command::Steps{steps - travelled.snapshot()->step});
        const auto step = static_cast<std::size_t>(part * static_cast<double>(steps));
        const double time = time_of_step(travelled, step);
        go(travelled, command::Seek{time});
        EXPECT_EQ(travelled.snapshot()->step, static_cast<std::int64_t>(step));
        EXPECT_EQ(travelled.snapshot()->time, time);
    }
    go(travelled, command::Steps{steps - travelled.snapshot()->step});
    expect_same_run(whole, travelled);
}

INSTANTIATE_TEST_SUITE_P(Scenes, TimeTravelOfEachKind, ::testing::ValuesIn(percuss::testing::kinds_of_runs),
                         [](const auto& kind) { return std::string(kind.param.name); });

TEST(TimeTravel, AnyMomentIsFoundWhateverIsKept) {
    for (const std::size_t memory : {std::size_t{1}, std::size_t{60000}, std::size_t{1} << 30}) {
        EngineOptions options;
        options.state_memory = memory;
        Engine engine(small(), options);
        go(engine, command::Run{});
        const auto times = engine.history()->values("time");
        Solver alone(small());
        std::vector<std::shared_ptr<Snapshot>> moments;
        for (std::size_t k = 0; k < times.size(); ++k) {
            moments.push_back(alone.snapshot());
            ASSERT_FALSE(alone.step());
        }
        const std::size_t last = times.size() - 1;
        for (const std::size_t step :
             {last / 2, last / 2 + 1, last / 2 + 30, last, std::size_t{0}, last / 3}) {
            // Just after the moment before it: the first step that reaches the time is wanted.
            const double time = step == 0 ? 0 : times[step - 1] + 1e-3 * (times[step] - times[step - 1]);
            go(engine, command::Seek{time});
            const auto found = engine.snapshot();
            ASSERT_EQ(found->step, static_cast<std::int64_t>(step)) << memory;
            EXPECT_EQ(found->position, moments[step]->position);
            EXPECT_EQ(found->stress, moments[step]->stress);
            EXPECT_EQ(found->pairs[0].force, moments[step]->pairs[0].force);
            EXPECT_EQ(found->contact_forces.size(), moments[step]->contact_forces.size());
            EXPECT_EQ(engine.status(), RunStatus::paused);
        }
    }
}

TEST(TimeTravel, StatesStayWithinTheirMemory) {
    EngineOptions options;
    options.state_memory = 100'000;
    options.frame_memory = 50'000;
    Engine engine(small({"model.duration=2"}), options);
    go(engine, command::Run{});
    const Timeline timeline = engine.timeline();
    EXPECT_GT(timeline.state_bytes, 30'000U);
    EXPECT_LE(timeline.state_bytes, 100'000U);
    EXPECT_GT(timeline.frame_bytes, 15'000U);
    EXPECT_LE(timeline.frame_bytes, 50'000U);
    for (const auto& times : {timeline.kept_states, timeline.frames}) {
        ASSERT_GE(times.size(), 3U);
        EXPECT_EQ(times.front(), 0);
        EXPECT_GT(times.back(), 1);
        EXPECT_TRUE(std::is_sorted(times.begin(), times.end()));
        for (std::size_t k = 2; k + 1 < times.size(); ++k)
            EXPECT_NEAR(times[k] - times[k - 1], times[1], 0.1 * times[1]) << "evenly";
    }
    EXPECT_EQ(timeline.frames.back(), engine.snapshot()->time);
}

TEST(TimeTravel, KeptStatesTakeWhatTheySay) {
    for (const char* scheme : {"joint", "projection"}) {
        Solver solver(testing::nail(scheme));
        for (int k = 0; k < 300; ++k) ASSERT_FALSE(solver.step());
        const RunRecord record(*solver.setup());
        const std::size_t before = testing::allocated_bytes();
        const auto kept = std::make_shared<const KeptState>(KeptState{solver.save(), record.progress()});
        const auto taken = static_cast<double>(testing::allocated_bytes() - before);
        EXPECT_NEAR(static_cast<double>(memory_of(*kept)), taken, 0.2 * taken) << scheme;
    }
}

TEST(TimeTravel, WhatCameAfterStaysReadableUntilTheRunGoesOn) {
    Engine engine(small());
    go(engine, command::Steps{100});
    const auto history = engine.history();
    const auto rows_of_trace = engine.traces()[0].rows;
    const std::vector<double> before = all(*history), traced = all(*rows_of_trace);
    const auto frames = engine.frames();
    const std::vector<double> framed = frames->times();
    const double end = engine.snapshot()->time, time = history->values("time")[40];
    EXPECT_FALSE(engine.timeline().branch_drops);
    go(engine, command::Seek{time});
    EXPECT_EQ(engine.history(), history);
    EXPECT_EQ(engine.traces()[0].rows, rows_of_trace);
    EXPECT_EQ(history->rows(), 100U);
    EXPECT_EQ(engine.timeline().present, time);
    EXPECT_EQ(engine.timeline().end, end);
    EXPECT_EQ(engine.timeline().branch_drops, (std::array<double, 2>{time, end}));
    EXPECT_EQ(engine.frame_at(end)->step, 100) << "frames, too";
    go(engine, command::Steps{0});
    go(engine, command::Run{0.5 * time});
    EXPECT_EQ(engine.history(), history) << "neither made a step";

    go(engine, command::Steps{1});
    EXPECT_NE(engine.history(), history);
    EXPECT_EQ(engine.history()->rows(), 41U);
    const auto kept = all(*engine.history());
    EXPECT_TRUE(std::equal(kept.begin(), kept.end(), before.begin()));
    EXPECT_LT(engine.traces()[0].rows->rows(), rows_of_trace->rows());
    EXPECT_FALSE(engine.timeline().branch_drops);
    EXPECT_EQ(engine.timeline().end, engine.snapshot()->time);
    EXPECT_LE(engine.frame_at(end)->step, 41);
    EXPECT_LE(engine.timeline().kept_states.back(), time);
    go(engine, command::Steps{200});
    EXPECT_EQ(all(*history), before) << "those who hold it keep it";
    EXPECT_EQ(all(*rows_of_trace), traced);
    EXPECT_EQ(frames->times(), framed);
}

TEST(TimeTravel, BackAtTheEndNothingIsDropped) {
    Engine engine(small()), whole(small());
    go(engine, command::Steps{100});
    const auto history = engine.history();
    const double end = engine.snapshot()->time;
    go(engine, command::Seek{0});
    EXPECT_EQ(engine.snapshot()->step, 0);
    for (const double time : {end, 1e9}) {
        go(engine, command::Seek{0.4 * end});
        go(engine, command::Seek{time});
        EXPECT_EQ(engine.snapshot()->step, 100);
        EXPECT_FALSE(engine.timeline().branch_drops);
    }
    go(engine, command::Steps{50});
    EXPECT_EQ(engine.history(), history);
    go(whole, command::Steps{150});
    expect_same_run(whole, engine);
}

TEST(TimeTravel, AFinishedRunCanBeSetBackAndFinishesAgain) {
    Engine engine(small());
    go(engine, command::Run{});
    const auto last = engine.snapshot();
    const std::string hash = engine.statistics().state_hash;
    go(engine, command::Seek{0.05});
    EXPECT_EQ(engine.status(), RunStatus::paused);
    EXPECT_GE(engine.snapshot()->time, 0.05 * (1 - 1e-12));
    EXPECT_EQ(engine.frame_at(last->time)->step, last->step);
    go(engine, command::Seek{1});
    EXPECT_EQ(engine.status(), RunStatus::finished);
    EXPECT_EQ(engine.snapshot()->status, RunStatus::finished);
    go(engine, command::Seek{0.03});
    go(engine, command::Run{});
    EXPECT_EQ(engine.status(), RunStatus::finished);
    EXPECT_EQ(engine.statistics().state_hash, hash);
    EXPECT_THAT(engine.take_messages(), SizeIs(0));
}

TEST(TimeTravel, ADivergedRunGoesOnFromBeforeWithASmallerStep) {
    const std::string flying = changed(small_scene, "[[0, -2], [4, -2], [4, 0], [0, 0]]",
                                       "[[0, -2.05], [4, -2.05], [4, -0.05], [0, -0.05]]");
    const std::string lagged =
        changed(flying, "duration = 0.1", "duration = 0.1\nlagged = true\nenergy_growth_limit = 1e-3");
    Engine engine(small({"model.step.courant=0.95"}, lagged));
    go(engine, command::Run{});
    ASSERT_EQ(engine.status(), RunStatus::diverged);
    const auto last = engine.snapshot();
    go(engine, command::Seek{0.5 * last->time});
    EXPECT_EQ(engine.status(), RunStatus::paused);
    EXPECT_EQ(engine.snapshot()->message, "");
    go(engine, command::Seek{last->time});
    EXPECT_EQ(engine.status(), RunStatus::diverged);
    EXPECT_EQ(engine.snapshot()->message, last->message);
    EXPECT_EQ(engine.snapshot()->position, last->position);
    go(engine, command::Seek{0});
    engine.post(command::Set{"model.step.courant", "0.05"});
    go(engine, command::Run{1.01 * last->time});
    EXPECT_EQ(engine.status(), RunStatus::paused) << engine.snapshot()->message;
    EXPECT_GT(engine.snapshot()->time, last->time);
    const auto times = engine.history()->values("time");
    EXPECT_EQ(times.size(), static_cast<std::size_t>(engine.snapshot()->step));
}

TEST(TimeTravel, StepsAreMadeAgainWithTheSizesThatTheyHad) {
    Engine engine(small());
    Solver alone(small());
    std::vector<std::vector<double>> positions;
    for (const double courant : {0.5, 0.2, 0.7}) {
        go(engine, command::Set{"model.step.courant", std::to_string(courant)});
        go(engine, command::Steps{45});
        percuss::testing::change_step(alone, courant);
        for (int k = 0; k < 45; ++k) {
            positions.push_back(alone.snapshot()->position);
            ASSERT_FALSE(alone.step());
        }
    }
    const auto times = engine.history()->values("time");
    for (const std::size_t step : {44U, 45U, 46U, 89U, 100U, 134U, 20U, 60U}) {
        go(engine, command::Seek{times[step]});
        EXPECT_EQ(engine.snapshot()->position, positions[step]) << step;
    }
    // On from there it is the present size that counts.
    go(engine, command::Seek{times[20]});
    go(engine, command::Steps{1});
    EXPECT_NEAR(engine.history()->values("step.dt").back() / engine.history()->values("step.critical").back(),
                0.7, 1e-9);
    go(engine, command::Steps{60});
    const auto position = engine.snapshot()->position;
    const double time = engine.snapshot()->time;
    go(engine, command::Seek{times[10]});
    go(engine, command::Seek{time});
    EXPECT_EQ(engine.snapshot()->position, position) << "the branch is remembered with its sizes";
}

TEST(TimeTravel, AStepSetOnTheWayActsFromTheBranchOn) {
    Engine engine(small());
    go(engine, command::Steps{100});
    const auto times = engine.history()->values("time");
    go(engine, command::Seek{times[50]});
    engine.post(command::Set{"model.step.courant", "0.25"});
    go(engine, command::Seek{times[70]});  // with the sizes of then
    Solver alone(small());
    for (int k = 0; k < 70; ++k) ASSERT_FALSE(alone.step());
    EXPECT_EQ(engine.statistics().state_hash, alone.statistics().state_hash);
    go(engine, command::Steps{30});
    percuss::testing::change_step(alone, 0.25);
    for (int k = 0; k < 30; ++k) ASSERT_FALSE(alone.step());
    EXPECT_EQ(engine.statistics().state_hash, alone.statistics().state_hash);
}

TEST(TimeTravel, ResettingForgetsTheWay) {
    Engine engine(small());
    go(engine, command::Steps{100});
    go(engine, command::Seek{0.001});
    go(engine, command::Reset{});
    EXPECT_EQ(engine.timeline().end, 0);
    EXPECT_FALSE(engine.timeline().branch_drops);
    EXPECT_EQ(engine.history()->rows(), 0U);
    EXPECT_THAT(engine.timeline().frames, ElementsAre(0));
    go(engine, command::Seek{5});
    EXPECT_EQ(engine.snapshot()->step, 0) << "a run of no steps has one moment";
    go(engine, command::Steps{3});
    EXPECT_EQ(engine.history()->rows(), 3U);
}

TEST(TimeTravel, IsRefusedWhereNothingIsKept) {
    EngineOptions options;
    options.state_memory = options.frame_memory = 0;
    Engine engine(small(), options);
    go(engine, command::Steps{70});
    go(engine, command::Seek{0});
    EXPECT_EQ(engine.snapshot()->step, 70);
    EXPECT_THAT(engine.take_messages(), ElementsAre(HasSubstr("no states are kept")));
    EXPECT_THAT(engine.timeline().kept_states, SizeIs(0));
    EXPECT_EQ(engine.frame_at(0), nullptr);
    EXPECT_EQ(engine.frames(), nullptr);
    Engine other(small());
    go(other, command::Seek{std::nan("")});
    EXPECT_THAT(other.take_messages(), SizeIs(1));
}

TEST(TimeTravel, FramesAfterABranchComeAnewAndNoneTwice) {
    std::vector<double> times;
    EngineOptions options;
    options.frame_interval = 0.001;
    options.on_frame = [&](const auto& frame) { times.push_back(frame->time); };
    Engine engine(small({"model.step={ fixed = 1e-4 }", "model.duration=0.01"}), options);
    go(engine, command::Run{0.0055});
    ASSERT_EQ(times.size(), 6U);
    go(engine, command::Seek{0.003});
    EXPECT_EQ(times.size(), 6U) << "stepping again shows nothing";
    go(engine, command::Run{});
    ASSERT_EQ(times.size(), 6U + 7U);
    EXPECT_NEAR(times[6], 0.004, 1e-9) << "that of the moment itself was given";
    EXPECT_NEAR(times.back(), 0.01, 1e-9);
}

TEST(TimeTravel, SeekingStopsARunAtOnceAndTheLastWishCounts) {
    Engine engine(small({"model.duration=1000"}));
    engine.post(command::Run{});
    while (engine.progress().step < 2000) std::this_thread::yield();
    for (int k = 200; k-- > 0;) engine.post(command::Seek{1e-5 * k + 0.001});
    engine.wait();
    EXPECT_EQ(engine.status(), RunStatus::paused);
    const auto there = engine.snapshot();
    EXPECT_GE(there->time, 0.001 * (1 - 1e-12));
    EXPECT_LT(there->time - there->dt, 0.001);
    EXPECT_EQ(engine.timeline().present, there->time);
}

TEST(TimeTravel, ASeekIsGivenUpForTheNextOne) {
    EngineOptions options;
    options.state_memory = 1;  // each goes all the way from the start
    Engine engine(small({"model.duration=1000"}), options);
    go(engine, command::Steps{8000});
    const double end = engine.snapshot()->time;
    const auto seconds = [&](int seeks) {
        const auto begin = std::chrono::steady_clock::now();
        for (int k = 0; k < seeks; ++k) engine.post(command::Seek{end * (0.9 - 0.001 * k)});
        engine.wait();
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    };
    const double one = seconds(1);
    EXPECT_LT(seconds(60), 15 * one);
    EXPECT_NEAR(engine.snapshot()->time, (0.9 - 0.001 * 59) * end, engine.snapshot()->dt);
}

// Scrubbing in a window while the engine goes on, back and forth; under ThreadSanitizer the absence of races.
TEST(TimeTravel, IsWatchedWhileTheEngineTravels) {
    EngineOptions options;
    options.state_memory = 200'000;
    options.frame_memory = 100'000;
    Engine engine(small({"model.duration=1"}), options);
    std::atomic<bool> done{false};
    std::atomic<int> wrong{0};
    std::vector<std::thread> readers;
    for (int r = 0; r < 2; ++r) {
        readers.emplace_back([&, r] {
            double time = 0;
            while (!done) {
                const Timeline timeline = engine.timeline();
                if (timeline.present > timeline.end) ++wrong;
                if (timeline.branch_drops && (*timeline.branch_drops)[0] >= (*timeline.branch_drops)[1])
                    ++wrong;
                if (!std::is_sorted(timeline.kept_states.begin(), timeline.kept_states.end())) ++wrong;
                time = std::fmod(time + 0.01 * (r + 1), timeline.end + 0.01);
                const auto frame = engine.frame_at(time);
                if (!frame || frame->time > time || frame->position.empty()) ++wrong;
                const auto history = engine.history();
                const auto times = history->values(0, 0, history->rows());
                if (!std::is_sorted(times.begin(), times.end())) ++wrong;
                for (const Trace& trace : engine.traces()) static_cast<void>(all(*trace.rows));
                static_cast<void>(engine.progress());
                static_cast<void>(engine.scene()->duration);
                static_cast<void>(engine.snapshot()->step);
            }
        });
    }
    for (int round = 0; round < 12; ++round) {
        go(engine, command::Steps{170});
        const double end = engine.snapshot()->time;
        engine.post(command::Seek{0.3 * end});
        engine.post(command::Seek{0.8 * end});
        if (round % 3 == 0) engine.wait();
        if (round % 4 == 0) engine.post(command::Run{});
        if (round % 4 == 0) std::this_thread::sleep_for(std::chrono::milliseconds(2));
        engine.post(command::Pause{});
        engine.wait();
        EXPECT_EQ(engine.history()->rows() == static_cast<std::size_t>(engine.snapshot()->step),
                  !engine.timeline().branch_drops);
    }
    done = true;
    for (auto& reader : readers) reader.join();
    EXPECT_EQ(wrong, 0);
}

TEST(KeptFrames, AreThoseOfTheirTimes) {
    EngineOptions options;
    options.frame_memory_interval = 0.002;
    Engine engine(small(), options);
    go(engine, command::Run{});
    const auto frames = engine.frames();
    EXPECT_EQ(frames->times().size(), 51U);
    Solver alone(small());
    for (const double time : {0.0, 0.0031, 0.05, 0.0999}) {
        const auto frame = engine.frame_at(time);
        EXPECT_LE(frame->time, time);
        EXPECT_GT(frame->time, time - 0.002 - frame->dt);
        while (alone.steps() < frame->step) ASSERT_FALSE(alone.step());
        EXPECT_EQ(frame->position, alone.snapshot()->position);
    }
    EXPECT_EQ(engine.frame_at(-1), nullptr);
    EXPECT_EQ(engine.frame_at(1e9)->step, engine.snapshot()->step);
    go(engine, command::Reset{});
    EXPECT_EQ(engine.frame_at(1e9)->step, 0);
    EXPECT_EQ(frames->times().size(), 51U) << "who holds them keeps them";
}

TEST(KeptFrames, SingleStepsDoNotPileThemUp) {
    Engine engine(small());
    for (int k = 0; k < 60; ++k) go(engine, command::Steps{1});
    const double interval = 0.1 / 500;
    const Timeline timeline = engine.timeline();
    EXPECT_LE(timeline.frames.size(), 3 + static_cast<std::size_t>(timeline.end / interval));
    EXPECT_EQ(timeline.frames.back(), timeline.end);
}

}  // namespace
}  // namespace percuss
