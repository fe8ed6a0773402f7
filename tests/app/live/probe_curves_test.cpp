#include "live/probe_curves.hpp"

#include <chrono>
#include <functional>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/program_test.hpp"
#include "scene/parse.hpp"

namespace percuss::app {
namespace {

using namespace std::chrono_literals;
using testing::IsEmpty;
using testing::SizeIs;

class ProbeCurvesTest : public test::ProgramTest {
  protected:
    ProbeCurvesTest() {
        std::string text = test::small_scene;
        text.insert(text.find("[expect]"),
                    "[[probe]]\nname = \"p1\"\nbody = \"anvil\"\nat = [1, -0.5]\nrecord = [\"stress.y\"]\n");
        write("scene.toml", text);
        EngineOptions options;
        options.frame_memory_interval = 0.0004;
        run_.emplace(options);
        run_->open(path("scene.toml"));
    }
    bool until(const std::function<bool()>& holds) {
        for (int i = 0; i < 20000; ++i) {
            run_->update();
            curves_.follow(*run_);
            if (holds()) return true;
            std::this_thread::sleep_for(1ms);
        }
        return false;
    }
    bool steps(std::int64_t count) {
        const std::int64_t wanted = run_->snapshot()->step + count;
        run_->step(count);
        return until([&] { return run_->snapshot()->step == wanted; });
    }
    static Probe stress() { return {"a", "anvil", Vec2(1, -0.5), {"stress.y"}, {}}; }

    std::optional<LiveRun> run_;
    ProbeCurves curves_;
};

TEST_F(ProbeCurvesTest, ThePastIsReadOffKeptMomentsAndTheRestAtEachStep) {
    ASSERT_TRUE(until([&] { return run_->snapshot() != nullptr; }));
    ASSERT_TRUE(steps(40));
    run_->add_probe(stress());
    ASSERT_TRUE(until([&] { return !curves_.all().empty() && curves_.all()[0].curves->rows() > 0; }));
    Curves& own = *curves_.all()[0].curves;
    const std::size_t past = own.rows();
    EXPECT_GT(past, 5U);
    EXPECT_LT(past, 40U);
    ASSERT_TRUE(steps(30));
    Curves whole;
    whole.follow(run_->history());
    const MinMaxPyramid& expected = whole.column(run_->history()->column("probe.p1.stress.y"));
    // The moment at which it was set is a kept one and the first of the steps: it counts once.
    ASSERT_TRUE(own.rows() == past + 30 || own.rows() == past + 29) << own.rows() << ", " << past;
    for (std::size_t row = 0; row < own.rows(); ++row) {
        if (row > 0) {
            ASSERT_LT(own.times()[row - 1], own.times()[row]);
        }
        const std::size_t same = whole.row_at(own.times()[row]);
        ASSERT_EQ(whole.times()[same], own.times()[row]);
        ASSERT_NEAR(own.column(1)[row], expected[same], 1e-12);
    }
    EXPECT_NE(own.column(1)[past + 20], 0) << "nothing came: the test sees nothing";
    EXPECT_EQ(value_of(*run_->snapshot(), curves_.all()[0].readings[0]), run_->snapshot()->stress[2][1]);
}

TEST_F(ProbeCurvesTest, ANewRunOfTheFileReadsThemFromTheStart) {
    write("other.toml", test::small_scene);
    ASSERT_TRUE(until([&] { return run_->snapshot() != nullptr; }));
    run_->add_probe(stress());
    ASSERT_TRUE(steps(10));
    run_->set("model.duration", "0.015");
    ASSERT_TRUE(until([&] { return run_->builds() == 2 && run_->status() == RunStatus::finished; }));
    ASSERT_TRUE(until([&] { return curves_.all().size() == 1; }));
    EXPECT_EQ(run_->probe_rows().at(0).rows->rows(), run_->history()->rows());
    run_->remove_probe("a");
    EXPECT_TRUE(until([&] { return curves_.all().empty(); }));
    run_->add_probe(stress());
    run_->open(path("other.toml"));
    ASSERT_TRUE(until([&] { return run_->builds() == 3; }));
    EXPECT_THAT(run_->probes(), IsEmpty()) << "they belong to the scene that they were put in";
    EXPECT_THAT(run_->probe_rows(), IsEmpty());
}

TEST_F(ProbeCurvesTest, TheySpeakTheLanguageOfScenes) {
    const Scene scene = load_scene(path("scene.toml"), {});
    EXPECT_EQ(free_probe_name(scene, {}), "p2") << "p1 is the scene's";
    Probe probe = stress();
    probe.name = free_probe_name(scene, {});
    probe.at = Vec2(1.0 / 3, -0.25);
    EXPECT_EQ(free_probe_name(scene, {probe}), "p3");
    const Scene more = parse_scene(scene.text + "\n" + probes_as_scene_text({probe}), "more.toml");
    ASSERT_THAT(more.probes, SizeIs(2));
    EXPECT_EQ(more.probes[1].name, "p2");
    EXPECT_EQ(more.probes[1].body, "anvil");
    EXPECT_NEAR(more.probes[1].at.x(), 1.0 / 3, 1e-9);
    EXPECT_EQ(more.probes[1].record, probe.record);
    EXPECT_EQ(probes_as_scene_text({}), "");
}

TEST(ProbePlots, CurvesOfOneQuantityShareAPlot) {
    ProbeReading stress, speed;
    stress.field.name = "stress.y";
    stress.field.title = "stress y";
    speed.field.name = "velocity.y";
    speed.field.quantity = Quantity::velocity;
    const auto curves = std::make_shared<Curves>();
    std::vector<PlotInfo> plots{{"probes.stress.y", "probes: stress.y", Quantity::stress, {{7, "scene's"}}}};
    add_probe_plots({{Probe{"a", "b", {}, {}, {}}, {stress, speed}, curves}}, plots);
    ASSERT_THAT(plots, SizeIs(2));
    ASSERT_THAT(plots[0].curves, SizeIs(2));
    EXPECT_EQ(plots[0].curves[1].column, 1U);
    EXPECT_EQ(plots[0].curves[1].own, curves);
    EXPECT_EQ(plots[1].curves[0].column, 2U);
    EXPECT_EQ(plots[1].quantity, Quantity::velocity);
}

}  // namespace
}  // namespace percuss::app
