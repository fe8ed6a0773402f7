#include "live/ghost.hpp"

#include <gtest/gtest.h>

namespace percuss::app {
namespace {

std::shared_ptr<const Snapshot> at(double time) {
    auto moment = std::make_shared<Snapshot>();
    moment->time = time;
    return moment;
}

TEST(Ghost, StaysUntilTheNewRunHasComeToItsTime) {
    Ghost ghost;
    ghost.follow(0, false);
    ghost.replaced(nullptr);
    EXPECT_FALSE(ghost.moment);
    ghost.replaced(at(90));
    ghost.follow(0, false);
    ghost.follow(89.9, false);
    ASSERT_TRUE(ghost.moment);
    EXPECT_EQ(ghost.moment->time, 90);
    ghost.follow(90, false);
    EXPECT_FALSE(ghost.moment);
    ghost.replaced(at(90));
    ghost.follow(89.9, true);
    EXPECT_FALSE(ghost.moment) << "the last steps of two runs are not equally late";
}

TEST(Ghost, RunsThatGotNowhereDoNotDisplaceIt) {
    Ghost ghost;
    ghost.replaced(at(90));
    ghost.replaced(at(3));
    EXPECT_EQ(ghost.moment->time, 90);
    ghost.replaced(at(120));
    EXPECT_EQ(ghost.moment->time, 120);
}

}  // namespace
}  // namespace percuss::app
