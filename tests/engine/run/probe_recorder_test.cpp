// Probes that are set while a run goes on read what those of the scene do.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/scene/small_scene.hpp"
#include "run/engine.hpp"

namespace percuss {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

/// The scene's probe p reads a cell and a node.
Scene scene() {
    return parse_scene(testing::changed(testing::small_scene, "record = [\"stress.axial\"]",
                                        "record = [\"stress.axial\", \"velocity.axial\"]"),
                       "small.toml");
}

Probe like_p(const std::string& name) {
    return {name, "rod", Vec2(1, 2), {"stress.axial", "velocity.axial"}, {}};
}

void go(Engine& engine, Command command) {
    engine.post(std::move(command));
    engine.wait();
}

std::vector<double> column(const History& rows, std::size_t index) {
    return rows.values(index, 0, rows.rows());
}

/// Each row of the probe is that of p in the history at the same time, and none is missing from `first` on.
void expect_rows_of_p(const Engine& engine, std::size_t probe, std::size_t first) {
    const auto history = engine.history();
    const auto rows = engine.probes().at(probe).rows;
    ASSERT_EQ(rows->rows() + first, history->rows());
    const auto tail = [&](std::string_view name) {
        return history->values(history->column(name), first, history->rows());
    };
    EXPECT_EQ(column(*rows, 0), tail("time"));
    EXPECT_EQ(column(*rows, 1), tail("probe.p.stress.axial"));
    EXPECT_EQ(column(*rows, 2), tail("probe.p.velocity.axial"));
}

TEST(SetProbes, ReadWhatAProbeOfTheSceneReads) {
    Engine engine(scene());
    go(engine, command::AddProbe{like_p("first")});
    go(engine, command::Steps{30});
    go(engine, command::AddProbe{like_p("second")});
    go(engine, command::Steps{40});
    expect_rows_of_p(engine, 0, 0);
    expect_rows_of_p(engine, 1, 30);
    const auto rows = engine.probes()[1].rows;
    EXPECT_EQ(rows->columns()[1].name, "probe.second.stress.axial");
    EXPECT_EQ(rows->columns()[2].quantity, Quantity::velocity);
    EXPECT_GT(std::abs(column(*rows, 1).back()), 0) << "the wave has not come: the test sees nothing";
}

TEST(SetProbes, ABranchDropsWhatCameLater) {
    Engine engine(scene());
    go(engine, command::Steps{20});
    go(engine, command::AddProbe{like_p("a")});
    go(engine, command::Steps{60});
    go(engine, command::AddProbe{like_p("late")});
    go(engine, command::Steps{10});
    const auto before = engine.probes()[0].rows;
    const double time = engine.history()->values("time")[50];
    go(engine, command::Seek{time});
    EXPECT_EQ(engine.probes()[0].rows->rows(), 70U) << "nothing is dropped before the run goes on";
    go(engine, command::Steps{25});
    expect_rows_of_p(engine, 0, 20);
    expect_rows_of_p(engine, 1, 50);
    EXPECT_EQ(before->rows(), 70U) << "who holds the former rows keeps them";
    // Back at the end without a branch: nothing is read twice.
    go(engine, command::Seek{time});
    go(engine, command::Seek{1e9});
    go(engine, command::Steps{5});
    expect_rows_of_p(engine, 0, 20);
}

TEST(SetProbes, AResetTakesThemAlong) {
    Engine engine(scene());
    go(engine, command::Steps{20});
    go(engine, command::AddProbe{like_p("a")});
    go(engine, command::Steps{5});
    go(engine, command::Reset{});
    EXPECT_EQ(engine.probes().at(0).rows->rows(), 0U);
    go(engine, command::Steps{12});
    expect_rows_of_p(engine, 0, 0);
    go(engine, command::RemoveProbe{"a"});
    EXPECT_THAT(engine.probes(), IsEmpty());
}

TEST(SetProbes, WhatCannotBeReadIsRefused) {
    Engine engine(scene());
    Probe nowhere = like_p("x"), nothing = like_p("y");
    nowhere.body = "rot";
    nothing.record = {"temperature"};
    for (const Probe& probe : {nowhere, nothing, like_p("p")}) go(engine, command::AddProbe{probe});
    go(engine, command::AddProbe{like_p("a")});
    go(engine, command::AddProbe{like_p("a")});
    EXPECT_THAT(engine.take_messages(),
                ElementsAre(HasSubstr("unknown body 'rot'; did you mean 'rod'?"),
                            HasSubstr("needs a body whose material"), HasSubstr("a probe 'p' already"),
                            HasSubstr("a probe 'a' already")));
    EXPECT_THAT(engine.probes(), SizeIs(1));
}

TEST(SetProbes, DoNotTouchTheRun) {
    Engine plain(scene()), read(scene());
    go(read, command::AddProbe{like_p("a")});
    go(plain, command::Run{});
    go(read, command::Run{});
    EXPECT_EQ(plain.statistics().state_hash, read.statistics().state_hash);
    EXPECT_FALSE(read.statistics().state_hash.empty());
    // A finished run keeps its complete statistics.
    go(read, command::AddProbe{like_p("b")});
    EXPECT_EQ(plain.statistics().state_hash, read.statistics().state_hash);
}

TEST(ContactChanges, CountOpeningsAndClosings) {
    Engine engine(scene());
    go(engine, command::Run{});
    const auto history = engine.history();
    const auto counts = history->values("contact.hit.changes"),
               active = history->values("contact.hit.active");
    const PairStatistics pair = engine.statistics().pairs.at(0);
    EXPECT_EQ(counts.back(), static_cast<double>(pair.openings + pair.closings));
    EXPECT_GT(pair.closings, 0);
    for (std::size_t k = 1; k < counts.size(); ++k)
        ASSERT_GE(counts[k] - counts[k - 1], std::abs(active[k] - active[k - 1])) << "row " << k;
}

}  // namespace
}  // namespace percuss
