#include "dynamics/team.hpp"

#include <chrono>
#include <ctime>
#include <numeric>

#include <gtest/gtest.h>

namespace percuss {
namespace {

TEST(Team, RunsEveryPartOnceAndReturnsWhenAllAreDone) {
    for (const int size : {1, 2, 3, 5}) {
        Team team(size);
        EXPECT_EQ(team.size(), size);
        std::vector<int> runs(
            static_cast<std::size_t>(size));  // plain numbers: a race would show under ThreadSanitizer
        for (int round = 1; round <= 500; ++round) {
            team.run([&](int part) { ++runs[static_cast<std::size_t>(part)]; });
            ASSERT_EQ(std::accumulate(runs.begin(), runs.end(), 0), round * size);
        }
        for (const int count : runs) EXPECT_EQ(count, 500);
    }
}

TEST(Team, WhatOnePartWroteAllPartsSeeInTheNextRound) {
    Team team(3);
    std::vector<double> from{1, 2, 3}, to(3);
    for (int round = 0; round < 300; ++round) {
        team.run([&](int part) {
            to[static_cast<std::size_t>(part)] = from[static_cast<std::size_t>((part + 1) % 3)];
        });
        team.run(
            [&](int part) { from[static_cast<std::size_t>(part)] = to[static_cast<std::size_t>(part)]; });
    }
    EXPECT_EQ(from, (std::vector<double>{1, 2, 3})) << "300 turns of three";
}

double processor_seconds() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// A paused window may stand open for hours: helpers must not burn their cores meanwhile, and must wake again.
TEST(Team, SleepsWhenNothingComes) {
    Team team(3);
    int sum = 0;
    team.run([](int) {});
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    const double before = processor_seconds();
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    EXPECT_LT(processor_seconds() - before, 0.02);
    std::vector<int> part_sums(3);
    team.run([&](int part) { part_sums[static_cast<std::size_t>(part)] = part + 1; });
    for (const int part : part_sums) sum += part;
    EXPECT_EQ(sum, 6);
}

TEST(Team, EndsWhileItsHelpersSleepOrSpin) {
    for (int round = 0; round < 50; ++round) Team team(3);
    Team team(3);
    std::this_thread::sleep_for(std::chrono::milliseconds(30));
}

}  // namespace
}  // namespace percuss
