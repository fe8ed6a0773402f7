#include "live/live_run.hpp"

#include <condition_variable>
#include <functional>
#include <future>
#include <mutex>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/program_test.hpp"

namespace percuss::app {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;

class LiveRunTest : public test::ProgramTest {
  protected:
    LiveRunTest() {
        std::string text = test::small_scene;
        const std::string parameter = "[parameters]\nspeed = { value = 1, range = [0, 5], unit = \"m/s\" }\n";
        text.insert(text.find("[units]"), parameter);
        text.replace(text.find("velocity = [0.0, -1.0]"), 22, "velocity = [0.0, \"= -speed\"]");
        write("scene.toml", text);
        text.replace(text.find("\"steel\""), 7, "steel");
        write("bad.toml", text);
    }
    /// Updates as frames do until something holds.
    static bool until(LiveRun& run, const std::function<bool()>& holds) {
        for (int i = 0; i < 20000; ++i) {
            run.update();
            if (holds()) return true;
            std::this_thread::sleep_for(1ms);
        }
        return false;
    }
    static double speed_of(const LiveRun& run) { return run.snapshot()->setup->scene.parameters.at(0).value; }
};

TEST_F(LiveRunTest, ABadSceneLeavesTheOldOneRunning) {
    LiveRun run;
    run.open(path("scene.toml"));
    EXPECT_FALSE(run.has_engine()) << "open() waited for the engine";
    ASSERT_TRUE(until(run, [&] { return run.snapshot() != nullptr; }));
    run.step(10);
    ASSERT_TRUE(until(run, [&] { return run.snapshot()->step == 10; }));
    run.open(path("bad.toml"));
    ASSERT_TRUE(until(run, [&] { return !run.building(); }));
    ASSERT_EQ(run.messages().size(), 1U);
    EXPECT_THAT(run.messages()[0], HasSubstr("bad.toml:14:"));
    EXPECT_EQ(run.snapshot()->step, 10);
    EXPECT_EQ(run.file(), path("scene.toml"));
    run.step(1);
    EXPECT_TRUE(until(run, [&] { return run.snapshot()->step == 11; }));
    EXPECT_FALSE(run.file_changed()) << "a file that was refused is not read again before it changes";
    write("bad.toml", test::small_scene);
    std::filesystem::last_write_time(path("bad.toml"), std::filesystem::file_time_type::clock::now() + 1h);
    EXPECT_TRUE(run.file_changed());
    run.reload();
    EXPECT_TRUE(until(run, [&] { return run.builds() == 2; }));
    EXPECT_TRUE(run.messages().empty());
    EXPECT_EQ(run.file(), path("bad.toml"));
}

TEST_F(LiveRunTest, ASettingBuildsAnewAndTheLastOneCounts) {
    LiveRun run;
    run.open(path("scene.toml"));
    ASSERT_TRUE(until(run, [&] { return run.snapshot() != nullptr; }));
    for (const char* speed : {"2", "3", "4"}) run.set("parameters.speed", speed);
    EXPECT_EQ(run.setting("parameters.speed"), "4");
    ASSERT_TRUE(until(run, [&] { return !run.building(); }));
    EXPECT_EQ(run.builds(), 3) << "the middle value of three should be passed over";
    ASSERT_TRUE(until(run, [&] { return speed_of(run) == 4; }));
    EXPECT_EQ(run.snapshot()->step, 0) << "a run that waits at its beginning waits on";
    run.set("parameters.speed", "7");
    ASSERT_TRUE(until(run, [&] { return !run.building(); }));
    EXPECT_THAT(run.messages().at(0), HasSubstr("speed"));
    EXPECT_EQ(speed_of(run), 4);
    run.forget_settings();
    EXPECT_TRUE(until(run, [&] { return speed_of(run) == 1; }));
}

TEST_F(LiveRunTest, WhatHasBegunGoesOnWithTheNewDesign) {
    LiveRun run;
    run.open(path("scene.toml"));
    ASSERT_TRUE(until(run, [&] { return run.snapshot() != nullptr; }));
    run.step(5);
    ASSERT_TRUE(until(run, [&] { return run.snapshot()->step == 5; }));
    run.set("parameters.speed", "2");
    EXPECT_TRUE(until(run, [&] { return run.builds() == 2 && run.status() == RunStatus::finished; }));
}

TEST_F(LiveRunTest, TheStepFractionChangesInFlight) {
    LiveRun run;
    run.open(path("scene.toml"));
    ASSERT_TRUE(until(run, [&] { return run.snapshot() != nullptr; }));
    run.step(5);
    ASSERT_TRUE(until(run, [&] { return run.snapshot()->step == 5; }));
    run.set("model.step.courant", "0.3");
    run.step(5);
    ASSERT_TRUE(until(run, [&] { return run.snapshot()->step == 10; }));
    EXPECT_NEAR(run.snapshot()->dt / run.snapshot()->critical_step, 0.3, 1e-6);
    EXPECT_EQ(run.builds(), 1);
}

TEST_F(LiveRunTest, ReadsTheFileAnewWhenItChanged) {
    LiveRun run;
    run.open(path("scene.toml"));
    ASSERT_TRUE(until(run, [&] { return run.snapshot() != nullptr; }));
    EXPECT_FALSE(run.file_changed());
    std::filesystem::last_write_time(path("scene.toml"), std::filesystem::file_time_type::clock::now() + 1h);
    EXPECT_TRUE(run.file_changed());
    run.reload();
    ASSERT_TRUE(until(run, [&] { return run.builds() == 2; }));
    EXPECT_FALSE(run.file_changed());
}

/// The engine's thread is held within a step: whatever a frame does must go on without it.
TEST_F(LiveRunTest, TheWindowNeverWaitsForTheEngine) {
    std::mutex mutex;
    std::condition_variable changed;
    bool held = false, released = false;
    EngineOptions options;
    options.frame_interval = 1e-4;
    options.on_frame = [&](const std::shared_ptr<const Snapshot>&) {
        std::unique_lock lock(mutex);
        held = true;
        changed.notify_all();
        changed.wait(lock, [&] { return released; });
    };
    {
        LiveRun run(options);
        run.open(path("scene.toml"));
        ASSERT_TRUE(until(run, [&] { return run.snapshot() != nullptr; }));
        run.run();
        {
            std::unique_lock lock(mutex);
            ASSERT_TRUE(changed.wait_for(lock, 20s, [&] { return held; }));
        }
        auto frames = std::async(std::launch::async, [&] {
            for (int i = 0; i < 1000; ++i) {
                run.update();
                run.pause();
                run.set("model.step.courant", "0.5");
                run.run(0.01);
            }
            run.reload();  // a second engine, while the first one cannot end
            while (run.building()) run.update();
            run.update();
        });
        EXPECT_EQ(frames.wait_for(20s), std::future_status::ready) << "a frame waits for the engine's step";
        {
            const std::lock_guard lock(mutex);
            released = true;
        }
        changed.notify_all();
        frames.wait();
        EXPECT_EQ(run.builds(), 2);
    }
}

}  // namespace
}  // namespace percuss::app
