// Speed, and changes in flight.
#include <chrono>
#include <cmath>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/scene/small_scene.hpp"
#include "run/engine.hpp"

namespace percuss {
namespace {

using percuss::testing::small_scene;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::SizeIs;
using Clock = std::chrono::steady_clock;

Scene small(const std::vector<std::string>& overrides = {}) {
    return parse_scene(small_scene, "small.toml", overrides);
}

double seconds_since(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

// Bounds are wide: other programs may hold this one up, but nothing makes it faster than asked.
TEST(RunSpeed, IsHeldAndMeasured) {
    Engine engine(small({"model.duration=1000"}));
    engine.post(command::SetSpeed{0.1});
    const auto begin = Clock::now();
    engine.post(command::Run{});
    double measured = 0;
    while (seconds_since(begin) < 0.4) {
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
        static_cast<void>(engine.snapshot());
        measured = engine.progress().speed;
    }
    EXPECT_EQ(engine.progress().target_speed, 0.1);
    EXPECT_EQ(engine.progress().status, RunStatus::running);
    engine.post(command::Pause{});
    engine.wait();
    const double wall = seconds_since(begin), time = engine.snapshot()->time;
    EXPECT_LT(time, 0.1 * wall * 1.1 + 0.002);
    EXPECT_GT(time, 0);
    EXPECT_GT(measured, 0);
    EXPECT_LT(measured, 0.15);
    EXPECT_EQ(engine.progress().speed, 0) << "a paused run has none";
    EXPECT_EQ(engine.progress().time, time);
    EXPECT_EQ(engine.progress().step, engine.snapshot()->step);
}

TEST(RunSpeed, NoCommandWaitsForASlowRun) {
    const auto begin = Clock::now();
    {
        Engine engine(small());
        engine.post(command::SetSpeed{1e-12});  // years
        engine.post(command::Run{});
        while (engine.progress().step < 1) std::this_thread::yield();
        engine.post(command::Pause{});
        engine.wait();
        EXPECT_EQ(engine.status(), RunStatus::paused);
        EXPECT_EQ(engine.snapshot()->step, 1) << "its first step was due at once";
        engine.post(command::Steps{30});
        engine.wait();
        EXPECT_EQ(engine.snapshot()->step, 31) << "steps are not held back";
        engine.post(command::Run{});
        engine.post(command::Seek{0});
        engine.wait();
        EXPECT_EQ(engine.snapshot()->step, 0);
        engine.post(command::Run{});
        engine.post(command::SetSpeed{});
        engine.wait();
        EXPECT_EQ(engine.status(), RunStatus::finished) << "let go, it runs";
        engine.post(command::Reset{});
        engine.post(command::SetSpeed{1e-12});
        engine.post(command::Run{});
        while (engine.status() != RunStatus::running) std::this_thread::yield();
    }  // ends a run that waits
    EXPECT_LT(seconds_since(begin), 5);
}

// A picture of a slow run is that of its last step, not of the one before.
TEST(RunSpeed, ASlowRunShowsItsLastStep) {
    Engine engine(small());
    engine.post(command::SetSpeed{1e-12});
    engine.post(command::Run{});
    while (engine.progress().step < 1) std::this_thread::yield();
    const auto begin = Clock::now();
    while (engine.snapshot()->step < 1) {
        ASSERT_LT(seconds_since(begin), 5);
        std::this_thread::yield();
    }
}

TEST(RunSpeed, MustBePositive) {
    Engine engine(small());
    for (const double speed : {0.0, -1.0, std::nan(""), HUGE_VAL}) engine.post(command::SetSpeed{speed});
    engine.wait();
    EXPECT_THAT(engine.take_messages(), SizeIs(4));
    EXPECT_EQ(engine.progress().target_speed, std::nullopt);
}

TEST(SetInFlight, WhatTheRunDoesNotReadLeavesItRunning) {
    Engine engine(small());
    engine.post(command::Steps{9});
    engine.wait();
    const auto history = engine.history();
    engine.post(command::Set{"view.field", "pressure"});
    engine.post(command::Set{"record.frames", "0.01"});
    engine.wait();
    EXPECT_THAT(engine.take_messages(), SizeIs(0));
    EXPECT_EQ(engine.snapshot()->step, 9);
    EXPECT_EQ(engine.history(), history);
    EXPECT_EQ(engine.scene()->view.field, "pressure");
    EXPECT_EQ(engine.scene()->record.frames, 0.01);
    EXPECT_THAT(engine.scene()->overrides, ElementsAre("view.field=pressure", "record.frames=0.01"));
    engine.post(command::Set{"view.field", "presure"});
    engine.wait();
    EXPECT_THAT(engine.take_messages(), ElementsAre(HasSubstr("presure")));
    EXPECT_EQ(engine.scene()->view.field, "pressure");
    engine.post(command::Set{"material.steel.young", "100"});
    engine.wait();
    EXPECT_EQ(engine.snapshot()->step, 0);
    EXPECT_EQ(engine.scene()->view.field, "pressure") << "a rebuild keeps what was set";
    EXPECT_EQ(engine.snapshot()->setup->scene.view.field, "pressure");
    EXPECT_EQ(engine.scene()->materials[0].young, 100);
}

}  // namespace
}  // namespace percuss
