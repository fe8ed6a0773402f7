#include "live/playhead.hpp"

#include <gtest/gtest.h>

namespace percuss::app {
namespace {

using namespace std::chrono_literals;

const Playhead::Clock::time_point start{};

TEST(Playhead, PlaysAtItsSpeedUpToTheEndAndStays) {
    Playhead head;
    EXPECT_TRUE(head.live());
    head.look_at(2);
    EXPECT_FALSE(head.live());
    EXPECT_FALSE(head.advance(start + 1s, 3, 100)) << "it only looks";
    EXPECT_EQ(head.time(), 2);
    head.play(start + 1s);
    EXPECT_FALSE(head.advance(start + 2s, 3, 100));
    EXPECT_DOUBLE_EQ(head.time(), 5);
    EXPECT_FALSE(head.advance(start + 2500ms, 10, 100)) << "the speed may change";
    EXPECT_DOUBLE_EQ(head.time(), 10);
    EXPECT_TRUE(head.advance(start + 60s, 10, 100));
    EXPECT_EQ(head.time(), 100);
    EXPECT_FALSE(head.playing());
    EXPECT_FALSE(head.advance(start + 70s, 10, 200)) << "one that has stopped stays";
    EXPECT_EQ(head.time(), 100);
}

TEST(Playhead, GoesOnFromWhereItIsPut) {
    Playhead head;
    head.play(start);
    EXPECT_FALSE(head.playing()) << "the newest moment is not played";
    head.look_at(1);
    head.play(start);
    head.look_at(50);
    head.advance(start + 1s, 2, 100);
    EXPECT_DOUBLE_EQ(head.time(), 52);
    head.pause();
    head.advance(start + 9s, 2, 100);
    EXPECT_DOUBLE_EQ(head.time(), 52);
    head.play(start + 9s);
    head.go_live();
    EXPECT_FALSE(head.playing());
}

}  // namespace
}  // namespace percuss::app
