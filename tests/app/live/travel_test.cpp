#include <functional>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/program_test.hpp"
#include "live/live_run.hpp"

/// Looking back in the run of a window, branches of it, and recorded runs.
namespace percuss::app {
namespace {

using namespace std::chrono_literals;
using testing::ElementsAre;
using testing::HasSubstr;

class TravelTest : public test::ProgramTest {
  protected:
    TravelTest() {
        EngineOptions options;
        options.frame_memory_interval = 0.002;  // ten of some 150 steps
        run_ = std::make_unique<LiveRun>(options,
                                         [](const std::filesystem::path&) -> std::unique_ptr<RunSource> {
                                             return std::make_unique<Sample>();
                                         });
        run_->open(path("scene.toml"));
        EXPECT_TRUE(until([&] { return run_->snapshot() != nullptr; }));
    }
    bool until(const std::function<bool()>& holds) {
        for (int i = 0; i < 20000; ++i) {
            run_->update();
            if (holds()) return true;
            std::this_thread::sleep_for(1ms);
        }
        return false;
    }
    bool pause_at(double time) {
        run_->run(time);
        return until([&] { return run_->newest()->time >= time && run_->status() == RunStatus::paused; });
    }
    bool finish() {
        run_->run();
        return until([&] { return run_->status() == RunStatus::finished; });
    }

    class Sample final : public RunSource {
      public:
        explicit Sample(std::shared_ptr<const RunSetup> setup = test::sample_setup())
            : setup_(std::move(setup)) {}
        std::vector<double> frame_times() override { return {0, 0.1, 0.2, 0.3}; }
        std::shared_ptr<const Snapshot> frame(std::int64_t index) override {
            return std::make_shared<Snapshot>(test::sample_snapshot(setup_, static_cast<int>(index)));
        }
        std::vector<Trace> traces() override { return {}; }
        std::shared_ptr<const History> history() override {
            auto history = std::make_shared<History>(test::sample_columns());
            test::append_sample_rows(*history, 20);
            return history;
        }

      private:
        std::shared_ptr<const RunSetup> setup_;
    };

    std::unique_ptr<LiveRun> run_;
};

TEST_F(TravelTest, LookingBackDisturbsNothing) {
    ASSERT_TRUE(finish());
    const auto newest = run_->newest();
    const auto history = run_->history();
    EXPECT_TRUE(run_->live());
    run_->look_at(0.0111);
    run_->update();
    EXPECT_FALSE(run_->live());
    EXPECT_NEAR(run_->snapshot()->time, 0.01, 2e-4) << "the kept moment before";
    EXPECT_LT(run_->snapshot()->step, newest->step);
    EXPECT_EQ(run_->newest(), newest);
    EXPECT_EQ(run_->history(), history);
    EXPECT_EQ(run_->status(), RunStatus::finished);
    run_->look_at(1);
    run_->update();
    EXPECT_TRUE(run_->live()) << "the end is the newest moment";
    EXPECT_EQ(run_->snapshot(), newest);
}

TEST_F(TravelTest, AnEngineThatWaitsGoesToTheVeryStepAndBack) {
    ASSERT_TRUE(finish());
    const auto end = run_->newest();
    run_->look_at(0.0111);
    run_->settle();
    EXPECT_TRUE(until([&] { return run_->snapshot()->time >= 0.0111; }));
    EXPECT_LT(run_->snapshot()->time - run_->snapshot()->dt, 0.0111) << "the first step that reaches it";
    EXPECT_EQ(run_->newest()->step, end->step);
    EXPECT_EQ(run_->status(), RunStatus::finished);
    EXPECT_EQ(run_->timeline().end, end->time);
    run_->look_at(0.005);
    run_->update();
    EXPECT_NEAR(run_->snapshot()->time, 0.004, 2e-4) << "again what was kept, at once";
    run_->go_live();
    run_->update();
    EXPECT_EQ(run_->snapshot()->step, end->step);
    EXPECT_TRUE(until([&] { return !run_->timeline().branch_drops; })) << "the engine goes back, too";
    EXPECT_EQ(run_->snapshot()->position, end->position);
    EXPECT_EQ(run_->status(), RunStatus::finished);
}

TEST_F(TravelTest, WhatGoesOnGoesOnFromTheNewestMoment) {
    ASSERT_TRUE(pause_at(0.01));
    const std::int64_t step = run_->newest()->step;
    const auto history = run_->history();
    run_->look_at(0.004);
    run_->settle();
    ASSERT_TRUE(until([&] { return run_->timeline().branch_drops.has_value(); }));
    run_->step(1);
    EXPECT_TRUE(until([&] { return run_->newest()->step == step + 1; }));
    EXPECT_TRUE(run_->live());
    EXPECT_EQ(run_->history(), history) << "nothing was dropped";
    run_->look_at(0.004);
    run_->settle();
    ASSERT_TRUE(finish());
    EXPECT_EQ(run_->history(), history);
    EXPECT_THAT(run_->messages(), testing::IsEmpty());
}

TEST_F(TravelTest, ABranchSaysWhatItDropsAndDropsItWhenConfirmed) {
    ASSERT_TRUE(finish());
    const auto end = run_->newest();
    const auto history = run_->history();
    run_->look_at(0.0121);
    run_->update();
    const double from = run_->snapshot()->time;
    EXPECT_FALSE(run_->branch_drops());
    run_->confirm_branch();  // not asked
    run_->ask_branch();
    ASSERT_TRUE(until([&] { return run_->branch_drops().has_value(); }));
    EXPECT_EQ((*run_->branch_drops())[0], from) << "the moment that is shown";
    EXPECT_EQ((*run_->branch_drops())[1], end->time);
    run_->cancel_branch();
    run_->go_live();
    ASSERT_TRUE(until([&] { return !run_->timeline().branch_drops; }));
    EXPECT_EQ(run_->history(), history);
    EXPECT_EQ(run_->status(), RunStatus::finished);

    run_->look_at(0.0121);
    run_->update();
    run_->ask_branch();
    ASSERT_TRUE(until([&] { return run_->branch_drops().has_value(); }));
    run_->confirm_branch();
    ASSERT_TRUE(until([&] { return run_->live() && run_->status() == RunStatus::finished; }));
    EXPECT_NE(run_->history(), history) << "a branch has histories of its own";
    EXPECT_EQ(run_->history()->rows(), history->rows());
    EXPECT_EQ(run_->newest()->position, end->position) << "with nothing changed it is the same run";
}

TEST_F(TravelTest, TheQuestionHoldsARunThatGoesOnAndNoLetsItGo) {
    run_->set_speed(0.005);
    run_->run();
    ASSERT_TRUE(until([&] { return run_->newest()->time > 0.002; }));
    run_->look_at(0.0005);
    run_->update();
    EXPECT_EQ(run_->snapshot()->step, 0);
    const double before = run_->newest()->time;
    ASSERT_TRUE(until([&] { return run_->newest()->time > before + 5e-4; })) << "it goes on meanwhile";
    run_->ask_branch();
    ASSERT_TRUE(until([&] { return run_->branch_drops().has_value(); }));
    EXPECT_EQ(run_->status(), RunStatus::paused);
    const double held = run_->newest()->time;
    EXPECT_EQ((*run_->branch_drops())[1], held);
    run_->look_at(0.0009);  // anything else means no
    EXPECT_FALSE(run_->branch_asked());
    EXPECT_TRUE(until([&] { return run_->newest()->time > held + 2e-4; }));
    EXPECT_FALSE(run_->live());
    run_->set_speed(std::nullopt);
    EXPECT_TRUE(until([&] { return run_->status() == RunStatus::finished; }));
}

TEST_F(TravelTest, StepsThroughKeptMoments) {
    ASSERT_TRUE(finish());
    run_->look_step(1);
    EXPECT_TRUE(run_->live()) << "there is nothing after the newest";
    std::vector<std::int64_t> steps;
    for (int i = 0; i < 3; ++i) {
        run_->look_step(-1);
        run_->update();
        steps.push_back(run_->snapshot()->step);
    }
    EXPECT_GT(run_->newest()->step, steps[0]);
    EXPECT_GT(steps[0], steps[1]);
    EXPECT_GT(steps[1], steps[2]);
    run_->look_step(2);
    run_->update();
    EXPECT_EQ(run_->snapshot()->step, steps[0]);
    run_->look_step(-100);
    run_->update();
    EXPECT_EQ(run_->snapshot()->step, 0);
    run_->look_step(100);
    EXPECT_TRUE(run_->live());
}

TEST_F(TravelTest, PlaysWhatItLooksBackAtUpToTheNewest) {
    ASSERT_TRUE(finish());
    run_->set_speed(0.1);
    run_->look_at(0.001);
    run_->play();
    std::int64_t last = 0;
    EXPECT_TRUE(until([&] {
        EXPECT_GE(run_->snapshot()->step, last);
        last = run_->snapshot()->step;
        return run_->live();
    }));
    EXPECT_EQ(last, run_->newest()->step);
    EXPECT_FALSE(run_->playing());
}

TEST_F(TravelTest, MomentsOutliveTheRun) {
    ASSERT_TRUE(finish());
    const auto moments = run_->moments();
    const auto shown = moments(0.0111);
    ASSERT_TRUE(shown);
    run_->reload();
    ASSERT_TRUE(until([&] { return run_->builds() == 2; }));
    EXPECT_EQ(moments(0.0111), shown);
    EXPECT_NE(run_->frame_at(0.0111), shown);
}

TEST_F(TravelTest, SpeedHoldsForRunsThatAreBuiltLater) {
    run_->set_speed(0.004);
    run_->run();
    ASSERT_TRUE(until([&] { return run_->newest()->step > 0; }));
    run_->reload();
    ASSERT_TRUE(until([&] { return run_->builds() == 2; }));
    const auto begin = std::chrono::steady_clock::now();
    ASSERT_TRUE(until([&] { return run_->newest()->time > 0.002; }));
    EXPECT_GT(std::chrono::steady_clock::now() - begin, 250ms);
}

TEST_F(TravelTest, ARecordedRunIsLookedAtAndPlayed) {
    write("run.h5", "");
    run_->open(path("run.h5"));
    ASSERT_TRUE(until([&] { return run_->recorded(); }));
    EXPECT_FALSE(run_->has_engine());
    EXPECT_EQ(run_->snapshot()->step, 0) << "its beginning";
    EXPECT_EQ(run_->history()->rows(), 20U);
    EXPECT_FALSE(run_->live());
    EXPECT_EQ(run_->timeline().end, 0.3);
    run_->look_at(0.25);
    EXPECT_TRUE(until([&] { return run_->snapshot()->step == 14; }));
    run_->look_step(-1);
    EXPECT_TRUE(until([&] { return run_->snapshot()->step == 7; }));
    run_->go_live();
    EXPECT_TRUE(until([&] { return run_->snapshot()->step == 21; }));
    EXPECT_EQ(run_->status(), RunStatus::paused);
    run_->set_speed(2);
    run_->run();  // from the beginning, as it stands at the end
    std::set<std::int64_t> seen;
    EXPECT_TRUE(until([&] {
        seen.insert(run_->snapshot()->step);
        return !run_->playing() && run_->snapshot()->step == 21;
    }));
    EXPECT_TRUE(seen.contains(0) || seen.contains(7)) << "it began anew";
    run_->set("parameters.speed", "2");
    ASSERT_EQ(run_->messages().size(), 1U);
    EXPECT_THAT(run_->messages()[0], HasSubstr("recorded"));
    EXPECT_FALSE(run_->building());
    EXPECT_FALSE(run_->file_changed()) << "one that is being written is not opened anew all the time";
    run_->dismiss_messages();
    run_->open(path("scene.toml"));
    ASSERT_TRUE(until([&] { return run_->has_engine(); }));
    EXPECT_TRUE(run_->live());
    EXPECT_FALSE(run_->recorded());
    run_->open(folder_.path());
    EXPECT_TRUE(until([&] { return run_->recorded(); })) << "a directory with run.h5 in it";
}

TEST_F(TravelTest, AProbeThatTheFileHasNoPlaceForAnyMoreIsDropped) {
    write("run.h5", "");
    auto setup = std::make_shared<RunSetup>(*test::sample_setup());
    LiveRun run({}, [&](const std::filesystem::path&) { return std::make_unique<Sample>(setup); });
    const auto read = [&](int builds) {
        for (int i = 0; i < 20000 && run.builds() < builds; ++i) {
            run.update();
            std::this_thread::sleep_for(1ms);
        }
        return run.builds() == builds;
    };
    run.open(path("run.h5"));
    ASSERT_TRUE(read(1));
    run.add_probe({"a", "striker", Vec2(1, 0), {"velocity.y"}, {}});
    run.add_probe({"b", "anvil", Vec2(1, 0), {"velocity.y"}, {}});
    run.add_probe({"c", "anvil", Vec2(1, 0), {"velocity.y"}, {}});
    ASSERT_EQ(run.probe_rows().size(), 3U);
    EXPECT_TRUE(run.messages().empty());

    setup = std::make_shared<RunSetup>(*setup);  // the scene was changed and run again
    setup->mesh.bodies[0].name = "hammer";
    setup->scene.probes = {{"c", "anvil", Vec2(1, 0), {"velocity.y"}, {}}};
    run.reload();
    ASSERT_TRUE(read(2));
    ASSERT_EQ(run.probes().size(), 1U);
    EXPECT_EQ(run.probes()[0].name, "b");
    EXPECT_EQ(run.probe_rows().size(), 1U);
    EXPECT_THAT(run.messages(),
                ElementsAre(HasSubstr("unknown body 'striker'"), HasSubstr("a probe 'c' already")));

    run.dismiss_messages();
    run.add_probe({"d", "striker", Vec2(1, 0), {"velocity.y"}, {}});
    EXPECT_EQ(run.probes().size(), 1U);
    EXPECT_THAT(run.messages(), ElementsAre(HasSubstr("unknown body 'striker'")));
}

TEST_F(TravelTest, ADirectoryWithoutARunIsRefused) {
    run_->open(folder_.path());
    ASSERT_TRUE(until([&] { return !run_->building(); }));
    ASSERT_EQ(run_->messages().size(), 1U);
    EXPECT_THAT(run_->messages()[0], HasSubstr("no run"));
    EXPECT_TRUE(run_->has_engine()) << "the old one stays";
}

}  // namespace
}  // namespace percuss::app
