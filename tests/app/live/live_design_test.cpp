// The design of a live run: what acts at once, what builds anew, and what may happen in between.
#include <algorithm>
#include <atomic>
#include <functional>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/program_test.hpp"
#include "live/live_run.hpp"

namespace percuss::app {
namespace {

using namespace std::chrono_literals;

class LiveDesignTest : public test::ProgramTest {
  protected:
    LiveDesignTest() {
        std::string text = test::small_scene;
        text.insert(
            text.find("[units]"),
            "[parameters]\nspeed = { value = 1, range = [0, 5] }\nsoft = { value = 0.1, range = [0, 1] }\n");
        text.replace(text.find("velocity = [0.0, -1.0]"), 22,
                     "velocity = [0.0, \"= -speed\"]\nhourglass = \"= soft\"");
        text.replace(text.find("poisson = 0.3"), 13, "poisson = 0.3\nviscosity = { linear = 0.06 }");
        write("scene.toml", text);
    }
    static bool until(LiveRun& run, const std::function<bool()>& holds) {
        for (int i = 0; i < 20000; ++i) {
            run.update();
            if (holds()) return true;
            std::this_thread::sleep_for(1ms);
        }
        return false;
    }
    void open(LiveRun& run) const {
        run.open(path("scene.toml"));
        ASSERT_TRUE(until(run, [&] { return run.snapshot() != nullptr; }));
    }
    static double number(const LiveRun& run, const std::string& key) { return run.design_value(key)->number; }
};

TEST_F(LiveDesignTest, WhatCanActAtOnceLeavesTheRunAsItIs) {
    LiveRun run;
    open(run);
    EXPECT_EQ(run.design_value("parameters.soft")->effect, ChangeEffect::next_step);
    EXPECT_EQ(run.design_value("parameters.speed")->effect, ChangeEffect::rebuild);
    run.step(20);
    ASSERT_TRUE(until(run, [&] { return run.snapshot()->step == 20; }));
    const auto history = run.history();
    run.set("material.steel.viscosity.linear", "0.3");
    ASSERT_TRUE(until(run, [&] { return !run.building(); }));
    EXPECT_EQ(number(run, "material.steel.viscosity.linear"), 0.3);
    run.set("parameters.soft", "0.2");
    ASSERT_TRUE(until(run, [&] { return !run.building(); }));
    EXPECT_EQ(number(run, "body.striker.hourglass"), 0.2);
    EXPECT_EQ(run.builds(), 1);
    EXPECT_EQ(run.history(), history);
    run.step(1);
    ASSERT_TRUE(until(run, [&] { return run.snapshot()->step == 21; }));

    // The same run by the engine alone.
    Engine engine(load_scene(path("scene.toml")));
    engine.post(command::Steps{20});
    engine.wait();
    engine.post(command::Set{"material.steel.viscosity.linear", "0.3"});
    engine.post(command::Set{"parameters.soft", "0.2"});
    engine.post(command::Steps{1});
    engine.wait();
    EXPECT_EQ(run.snapshot()->velocity, engine.snapshot()->velocity);
    EXPECT_EQ(run.snapshot()->dt, engine.snapshot()->dt);

    run.forget_settings();
    ASSERT_TRUE(until(run, [&] { return !run.building(); }));
    EXPECT_EQ(number(run, "material.steel.viscosity.linear"), 0.06);
    EXPECT_EQ(run.builds(), 1) << "back to the file at once, too";
    EXPECT_TRUE(run.messages().empty());
}

TEST_F(LiveDesignTest, BothKindsOfChangesTogetherBuildAnew) {
    LiveRun run;
    open(run);
    run.step(3);
    ASSERT_TRUE(until(run, [&] { return run.snapshot()->step == 3; }));
    run.set("parameters.soft", "0.3");  // is being looked at
    run.set("parameters.speed", "2");   // waits for it
    run.set("parameters.soft", "0.4");  // and so does this
    ASSERT_TRUE(until(run, [&] { return !run.building(); }));
    EXPECT_EQ(run.builds(), 2);
    EXPECT_EQ(number(run, "parameters.soft"), 0.4);
    EXPECT_EQ(run.snapshot()->setup->scene.bodies[0].hourglass, 0.4);
    EXPECT_GT(run.built_for(), std::chrono::steady_clock::now() - 1min);
    run.set("material.steel.young", "100");
    ASSERT_TRUE(until(run, [&] { return run.builds() == 3; }));
    EXPECT_EQ(run.snapshot()->setup->scene.materials[0].young, 100);
}

/// A slider that is dragged asks for the next design before the last one has made a step.
TEST_F(LiveDesignTest, ARunGoesOnThroughOneDesignAfterTheOther) {
    LiveRun run;
    open(run);
    run.run();
    for (int k = 0; k < 8; ++k) {
        const int builds = run.builds();
        run.set("parameters.speed", std::to_string(2 + 0.1 * k));
        // At once when it is there, in the very frame.
        ASSERT_TRUE(until(run, [&] { return run.builds() > builds; }));
    }
    EXPECT_TRUE(until(run, [&] { return run.snapshot()->step > 0; }));
    run.reset();
    ASSERT_TRUE(until(run, [&] { return run.snapshot()->step == 0; }));
    run.set("parameters.speed", "1");
    ASSERT_TRUE(until(run, [&] { return !run.building(); }));
    std::this_thread::sleep_for(20ms);
    run.update();
    EXPECT_EQ(run.snapshot()->step, 0) << "a run that waits at its beginning waits on";
}

TEST_F(LiveDesignTest, WhatTheEngineRefusesLeavesTheRun) {
    LiveRun run;
    open(run);
    run.step(2);
    ASSERT_TRUE(until(run, [&] { return run.snapshot()->step == 2; }));
    run.set("material.steel.viscosity.linear", "-1");
    ASSERT_TRUE(until(run, [&] { return !run.building(); }));
    ASSERT_FALSE(run.messages().empty());
    EXPECT_FALSE(run.setting("material.steel.viscosity.linear"));
    EXPECT_EQ(run.snapshot()->step, 2);
    EXPECT_EQ(run.builds(), 1);
}

/// For the thread sanitizer: everything at once, and the end in the middle of it.
TEST_F(LiveDesignTest, AnythingAtAnyTimeAndTheEndInTheMiddle) {
    for (int round = 0; round < 4; ++round) {
        LiveRun run;
        run.open(path("scene.toml"));
        for (int frame = 0; frame < 120 + 15 * round; ++frame) {
            run.update();
            switch (frame % 12) {
                case 0:
                    run.run();
                    break;
                case 2:
                    run.set("parameters.soft", std::to_string(0.1 + 0.001 * frame));
                    break;
                case 4:
                    run.set("model.step.courant", std::to_string(0.5 + 0.001 * frame));
                    break;
                case 5:
                    run.set("contact_solver.scheme", frame % 24 == 5 ? "joint" : "projection");
                    break;
                case 6:
                    run.set("parameters.speed", std::to_string(1 + 0.01 * frame));
                    break;
                case 8:
                    run.forget("parameters.speed");
                    break;
                case 10:
                    run.reset();
                    break;
                default:
                    break;
            }
            if (run.snapshot()) {
                const Timeline timeline = run.timeline();
                static_cast<void>(run.frame_at(0.5 * timeline.end));
                const auto times = run.history()->values(0, 0, run.history()->rows());
                EXPECT_TRUE(std::is_sorted(times.begin(), times.end()));
                for (const DesignValue& value : run.design()) EXPECT_FALSE(value.key.empty());
            }
            std::this_thread::sleep_for(frame % 7 == 0 ? 3ms : 300us);
        }
    }
}

/// Likewise for the engine: one posts, others read.
TEST_F(LiveDesignTest, ReadersNeverDisturbARunThatTravelsAndChanges) {
    Engine engine(load_scene(path("scene.toml")));
    std::atomic<bool> done{false};
    std::vector<std::thread> readers;
    for (int k = 0; k < 2; ++k)
        readers.emplace_back([&] {
            while (!done) {
                const auto snapshot = engine.snapshot();
                const Timeline timeline = engine.timeline();
                static_cast<void>(engine.frame_at(0.3 * timeline.end));
                EXPECT_GE(timeline.end, timeline.present);
                EXPECT_EQ(snapshot->velocity.size(), snapshot->position.size());
                static_cast<void>(engine.scene()->materials.size());
                const auto history = engine.history();
                static_cast<void>(history->table(0, history->rows()));
            }
        });
    for (int k = 0; k < 60; ++k) {
        engine.post(command::Steps{30});
        engine.post(command::Set{"material.steel.viscosity.linear", std::to_string(0.05 + 0.001 * k)});
        engine.post(command::Seek{0.0002 * (k % 9)});
        engine.post(command::Steps{5});
        if (k % 20 == 19) engine.post(command::Reset{});
        if (k % 5 == 4) engine.wait();
    }
    engine.wait();
    done = true;
    for (std::thread& reader : readers) reader.join();
    EXPECT_TRUE(engine.take_messages().empty());
}

}  // namespace
}  // namespace percuss::app
