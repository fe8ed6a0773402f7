#include "contact/joint/massless_system.hpp"

#include <gtest/gtest.h>

#include "engine/allocations.hpp"
#include "verification/schemes.hpp"

namespace percuss::testing {
namespace {

/// A block falls on the joint of two others, whose faces it does not match: rows come and go.
Scene falling() {
    return scene_of(
        scene_head("plane strain", 0.02, 0.3) +
        box_body("plate", {-6, 0.01, 7, 4.01}, {13, 4}, "velocity = [2, -20]") +
        box_body("left", {-8, -6, 0, 0}, {7, 5}) + box_body("right", {0, -6, 8, 0}, {9, 6}) +
        "[contact_solver]\nscheme = \"massless\"\n[[contact]]\nname = \"any\"\nbodies = \"all\"\n");
}

TEST(MasslessSystem, StepsAllocateNothingHoweverRowsComeAndGo) {
    Solver solver(falling());
    for (int k = 0; k < 5; ++k) ASSERT_FALSE(solver.step());
    const std::size_t before = allocations();
    while (!solver.finished()) ASSERT_FALSE(solver.step());
    EXPECT_EQ(allocations() - before, 0U);
    const RunStatistics s = solver.statistics();
    EXPECT_GT(s.contact_solver.most_rows, 20);
    EXPECT_GT(s.pairs[0].openings + s.pairs[1].openings, 10);
}

}  // namespace
}  // namespace percuss::testing
