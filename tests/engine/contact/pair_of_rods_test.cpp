#include <cmath>
#include <fstream>
#include <sstream>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "engine/allocations.hpp"
#include "scene/parse.hpp"
#include "solver.hpp"

namespace percuss {
namespace {

std::string rods_text() {
    std::ifstream file(PERCUSS_SOURCE_DIR "/scenes/rods.toml");
    std::stringstream text;
    text << file.rdbuf();
    return text.str();
}

Solver rods(const std::vector<std::string>& overrides = {}, int threads = 1) {
    return Solver(parse_scene(rods_text(), "rods.toml", overrides), threads);
}

void run(Solver& solver) {
    while (!solver.finished()) {
        const auto divergence = solver.step();
        ASSERT_FALSE(divergence) << divergence->message;
    }
}

TEST(PairOfRods, ClosesOnceOpensOnceAndKeepsMomentum) {
    Solver solver = rods();
    run(solver);
    const RunStatistics s = solver.statistics();
    EXPECT_EQ(s.pairs[0].events, 2);
    EXPECT_EQ(s.pairs[0].closings, 6);
    EXPECT_EQ(s.pairs[0].openings, 6);
    EXPECT_EQ(s.pairs[0].negative_forces, 0);
    EXPECT_LT(s.pairs[0].max_penetration, 1e-14) << "mm";
    EXPECT_GT(s.pairs[0].max_penetration, 0) << "it was measured";
    EXPECT_LT(std::abs(s.momentum_final[1] - s.momentum_initial[1]), 1e-12 * s.momentum_scale);
    EXPECT_NEAR(s.pairs[0].impulse[1], s.momentum_final[1], 5e-3 * s.momentum_final[1])
        << "all momentum passes through the contact: the striker rests";
    EXPECT_LT(s.maximum_growth, 1e-9);
}

// The faces spread sideways by about 1e-6 of a side, unequally: alike to that order.
TEST(PairOfRods, MasterAndSlaveAreAlikeOnMatchingFaces) {
    Solver one = rods(),
           other = rods({"contact.impact.master=\"striker.face\"", "contact.impact.slave=\"rod.face\""});
    run(one);
    run(other);
    ASSERT_EQ(one.steps(), other.steps());
    for (std::size_t n = 0; n < one.nodes().size(); ++n)
        for (int d = 0; d < 2; ++d) {
            ASSERT_NEAR(one.nodes()[n].x[d], other.nodes()[n].x[d], 1e-6);
            ASSERT_NEAR(one.nodes()[n].v[d], other.nodes()[n].v[d], 1e-4);
        }
    EXPECT_NEAR(one.statistics().pairs[0].impulse[1], -other.statistics().pairs[0].impulse[1], 1e-5);
}

// Poisson's ratio moves the faces sideways, unequally: end nodes slide past each other's ends.
TEST(PairOfRods, FlushEndsThatSpreadStayInContact) {
    Solver solver = rods({"material.steel.poisson=0.3", "model.duration=0.03"});
    while (!solver.finished()) {
        ASSERT_FALSE(solver.step());
        if (solver.time() > 0.002) {
            ASSERT_EQ(solver.snapshot()->pairs[0].active, 6) << solver.time();
        }
    }
}

// At rest in the same place, in touch, both flying at 300 m/s: no force may come from rounding.
TEST(PairOfRods, TouchingBodiesThatFlyTogetherFeelNoForce) {
    Solver solver = rods({"body.striker.velocity=[0, 300]", "body.rod.velocity=[0, 300]"});
    run(solver);
    EXPECT_LT(solver.statistics().pairs[0].peak_force, 1e-6);
    EXPECT_LT(solver.statistics().pairs[0].max_penetration, 1e-12);
}

// The inner loop of every run: after the first steps nothing may be allocated, in contact or out of it.
TEST(PairOfRods, StepsWithoutAllocation) {
    for (const int threads : {1, 2}) {
        Solver solver = rods(
            {"body.striker.block.0.divisions=[20, 100]", "body.rod.block.0.divisions=[14, 100]"}, threads);
        for (int k = 0; k < 100; ++k) ASSERT_FALSE(solver.step());
        ASSERT_GT(solver.snapshot()->pairs[0].active, 0);
        const std::size_t before = testing::allocations();
        for (int k = 0; k < 300; ++k) static_cast<void>(solver.step());
        EXPECT_EQ(testing::allocations() - before, 0U);
    }
}

TEST(PairOfRods, ThreadsDoNotChangeTheState) {
    const std::vector<std::string> fine{"body.striker.block.0.divisions=[20, 100]",
                                        "body.rod.block.0.divisions=[20, 100]", "model.duration=0.002"};
    Solver one = rods(fine, 1), two = rods(fine, 2);
    run(one);
    run(two);
    EXPECT_GE(one.statistics().cells, 3000);
    EXPECT_EQ(one.statistics().state_hash, two.statistics().state_hash);
}

// A state that was saved goes on as if nothing had happened since, counts included.
TEST(PairOfRods, RestoredStateGoesOnAsBefore) {
    Solver solver = rods();
    for (int k = 0; k < 60; ++k) ASSERT_FALSE(solver.step());
    const SolverState saved = solver.save();
    run(solver);
    const RunStatistics first = solver.statistics();
    solver.restore(saved);
    run(solver);
    const RunStatistics second = solver.statistics();
    EXPECT_EQ(first.state_hash, second.state_hash);
    EXPECT_EQ(first.pairs[0].events, second.pairs[0].events);
    EXPECT_EQ(first.pairs[0].impulse, second.pairs[0].impulse);
}

}  // namespace
}  // namespace percuss
