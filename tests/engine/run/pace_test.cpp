#include "run/pace.hpp"

#include <gtest/gtest.h>

namespace percuss {
namespace {

using namespace std::chrono_literals;

const Pace::Clock::time_point noon{12h};

/// Steps of `dt` that take `step` of wall time each, held back as asked. @returns wall seconds.
double walk(Pace& pace, double& time, double dt, std::chrono::microseconds step, int steps,
            Pace::Clock::time_point& now) {
    const auto begin = now;
    for (int k = 0; k < steps; ++k) {
        if (const auto until = pace.wait_until(time, now)) now = *until;
        now += step;
        time += dt;
        pace.count(time, now);
    }
    return std::chrono::duration<double>(now - begin).count();
}

TEST(Pace, WithoutATargetNothingWaitsAndTheSpeedIsMeasured) {
    Pace pace;
    auto now = noon;
    double time = 0;
    pace.start(time, now);
    EXPECT_EQ(pace.speed(), 0);
    EXPECT_NEAR(walk(pace, time, 1e-3, 100us, 10000, now), 1.0, 1e-9);
    EXPECT_NEAR(pace.speed(), 10, 1e-6);
}

TEST(Pace, HoldsARunToItsTarget) {
    Pace pace;
    auto now = noon;
    double time = 5;
    pace.start(time, now);
    pace.set_target(2.0, time, now);
    EXPECT_FALSE(pace.wait_until(time, now)) << "the first step is due at once";
    EXPECT_NEAR(walk(pace, time, 1e-3, 100us, 2000, now), 1.0, 0.003);
    EXPECT_NEAR(pace.speed(), 2, 0.02);
    pace.set_target(std::nullopt, time, now);
    EXPECT_NEAR(walk(pace, time, 1e-3, 100us, 2000, now), 0.2, 1e-9);
}

TEST(Pace, WaitsForEachStepWhereStepsAreRare) {
    Pace pace;
    auto now = noon;
    double time = 0;
    pace.start(time, now);
    pace.set_target(0.5, time, now);
    EXPECT_NEAR(walk(pace, time, 1, 100us, 5, now), 8, 0.001) << "four waits of two seconds";
    EXPECT_NEAR(pace.speed(), 0.5, 0.001);
}

TEST(Pace, LostTimeIsNotMadeUpFor) {
    Pace pace;
    auto now = noon;
    double time = 0;
    pace.start(time, now);
    pace.set_target(1.0, time, now);
    walk(pace, time, 1e-3, 100us, 100, now);
    now += 10s;  // something else took the processor
    EXPECT_GT(walk(pace, time, 1e-3, 100us, 1000, now), 0.95);
}

TEST(Pace, SpeedIsThatOfTheLastHalfSecond) {
    Pace pace;
    auto now = noon;
    double time = 0;
    pace.start(time, now);
    walk(pace, time, 1e-3, 100us, 20000, now);
    walk(pace, time, 1e-3, 1000us, 520, now);
    EXPECT_NEAR(pace.speed(), 1, 0.01);
    pace.start(time, now);
    EXPECT_EQ(pace.speed(), 0);
}

TEST(Pace, NoTargetOverflowsTheClock) {
    Pace pace;
    pace.start(0, noon);
    pace.set_target(1e-300, 0, noon);
    const auto until = pace.wait_until(1, noon);
    ASSERT_TRUE(until);
    EXPECT_EQ(*until, noon + 1h);
    pace.set_target(1e300, 0, noon);
    EXPECT_FALSE(pace.wait_until(1, noon));
}

}  // namespace
}  // namespace percuss
