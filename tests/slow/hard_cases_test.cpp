// The hard cases of scenes/hard over a grid of time steps. With PERCUSS_TABLE=FILE each run appends its line
// of the tables in tests/slow/HARD_CASES.md.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <tuple>

#include <gmock/gmock.h>

#include "record/summary.hpp"
#include "verification/run.hpp"

namespace percuss::testing {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> hard_cases() {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(PERCUSS_SOURCE_DIR "/scenes/hard"))
        names.push_back(entry.path().stem());
    std::sort(names.begin(), names.end());
    return names;
}

Scene hard_case(const std::string& name, const std::vector<std::string>& overrides) {
    return load_scene(PERCUSS_SOURCE_DIR "/scenes/hard/" + name + ".toml", overrides);
}

struct Outcome {
    RunStatistics statistics;
    double momentum_error;  ///< as in summary.json
};

/// Runs a scene to its end, which it has to reach with finite numbers.
Outcome outcome_of(const Scene& scene) {
    Solver solver(scene, 1);
    while (!solver.finished())
        if (const auto divergence = solver.step()) throw std::runtime_error(divergence->message);
    for (const Node& node : solver.nodes())
        for (const double value : {node.x[0], node.x[1], node.v[0], node.v[1]})
            EXPECT_TRUE(std::isfinite(value));
    const RunStatistics statistics = solver.statistics();
    const auto summary =
        make_summary(*solver.setup(), statistics, History(history_columns(scene)), *solver.snapshot());
    return {statistics, summary_value(summary, "momentum.error").value()};
}

void write_row(const std::string& name, const std::string& step, const Outcome& outcome) {
    const char* file = std::getenv("PERCUSS_TABLE");
    if (!file) return;
    const RunStatistics& s = outcome.statistics;
    double penetration = 0;
    std::int64_t events = 0, openings = 0;
    for (const PairStatistics& pair : s.pairs) {
        penetration = std::max(penetration, pair.max_penetration);
        events += pair.events;
        openings += pair.openings;
    }
    std::ofstream(file, std::ios::app) << fmt::format(
        "| {} | {} | {} | {:.0e} | {:.3f} | {:.0e} | {:.0e} | {} | {} |\n", name, step, s.steps,
        s.maximum_growth, 100 * s.maximum_loss, outcome.momentum_error, penetration, events, openings);
}

void expect_sound(const std::string& name, const std::string& step,
                  const std::vector<std::string>& overrides) {
    const Outcome outcome = outcome_of(hard_case(name, overrides));
    EXPECT_LT(outcome.statistics.maximum_growth, 1e-3);
    EXPECT_LT(outcome.momentum_error, 1e-10);
    write_row(name, step, outcome);
}

/// Two cases take two thirds of the time of the grid: one of many steps, one of a thousand rows. What they
/// are for, folds that come into touch and a matrix that stays narrow, is there at any step; instability is
/// looked for near the critical one.
std::vector<std::string> steps_of(const std::string& name) {
    if (name == "tube-crushed" || name == "one-against-thousand") return {"0.5", "0.9", "0.98"};
    return {"0.1", "0.2", "0.35", "0.5", "0.7", "0.8", "0.9", "0.95", "0.98"};
}

std::vector<std::tuple<std::string, std::string>> grid() {
    std::vector<std::tuple<std::string, std::string>> cases;
    for (const std::string& name : hard_cases())
        for (const std::string& step : steps_of(name)) cases.emplace_back(name, step);
    return cases;
}

class HardCase : public ::testing::TestWithParam<std::tuple<std::string, std::string>> {};

TEST_P(HardCase, NeitherGainsEnergyNorLosesMomentum) {
    const auto& [name, step] = GetParam();
    expect_sound(name, step, {"model.step.courant=" + step});
}

INSTANTIATE_TEST_SUITE_P(Steps, HardCase, ::testing::ValuesIn(grid()), [](const auto& of) {
    std::string name = std::get<0>(of.param) + "_at_" + std::get<1>(of.param);
    std::replace_if(
        name.begin(), name.end(), [](char c) { return c == '-' || c == '.'; }, '_');
    return name;
});

// A block at rest for a million steps.
TEST(HardCases, RestsForAMillionSteps) {
    const Outcome outcome = outcome_of(hard_case("rest", {"model.duration=330"}));
    EXPECT_GT(outcome.statistics.steps, 1'000'000);
    EXPECT_LT(outcome.statistics.maximum_growth, 1e-3);
    EXPECT_LE(outcome.statistics.pairs[0].events, 20);
    write_row("rest", "0.9", outcome);
}

// Gaps and overlaps of any part of what a step moves: whenever the faces meet within a step.
TEST(HardCases, DoNotDependOnThePhaseOfTheGap) {
    // 10 m/s over steps of 3.4e-4 ms: 3.4e-3 mm.
    for (int k = -8; k <= 8; ++k) {
        const std::string gap = fmt::format("{}", k * 3.4e-3 / 8);
        SCOPED_TRACE(gap + " mm");
        const Outcome rods =
            outcome_of(hard_case("gap", {"parameters.gap=" + fmt::format("{}", std::abs(k) * 3.4e-3 / 8)}));
        EXPECT_LT(rods.statistics.maximum_growth, 1e-3);
        EXPECT_LT(rods.statistics.maximum_loss, 0.007);
        EXPECT_EQ(rods.statistics.pairs[0].events, 2);
        const Outcome blocks = outcome_of(hard_case("overlap", {"parameters.overlap=" + gap}));
        EXPECT_LT(blocks.statistics.maximum_growth, 1e-5);
    }
}

// What is above the critical step is not begun.
TEST(HardCases, RefuseAStepAboveTheCriticalOne) {
    try {
        hard_case("gap", {"model.step.courant=1.02"});
        FAIL();
    } catch (const SceneError& error) {
        EXPECT_THAT(error.what(), ::testing::HasSubstr("1.02"));
    }
}

}  // namespace
}  // namespace percuss::testing
