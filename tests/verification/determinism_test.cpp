// One result: whatever the threads, the repeats, the build and the instruction set.
#include <thread>

#include "verification/run.hpp"

namespace percuss::testing {
namespace {

Scene impact_of_many(double duration) {
    return scene_of(scene_head("plane strain", duration, 0.3) +
                    box_body("flyer", {1, 40, 31, 70}, {40, 41}, "velocity = [5, -30]") +
                    box_body("target", {0, 0, 60, 40}, {70, 61}, "element = \"mean-dilatation quad\"") +
                    contact_pair("hit", "flyer.bottom", "target.top"));
}

void expect_the_same_of_two_threads(const Scene& scene) {
    const auto run = [&](int threads) {
        RecordedRun r(scene, threads);
        r.to_end();
        EXPECT_EQ(r.solver.statistics().threads, threads);
        return std::pair(r.solver.statistics().state_hash, r.column("energy.balance"));
    };
    const auto one = run(1), two = run(2);
    EXPECT_EQ(one.first, two.first);
    EXPECT_EQ(one.second, two.second);
}

TEST(Determinism, OneAndTwoThreadsGiveTheSameState) {
    if (std::thread::hardware_concurrency() < 2) GTEST_SKIP() << "this machine has one processor";
    expect_the_same_of_two_threads(impact_of_many(0.005));
}

TEST(Determinism, TwoThreadsMeetBeforeNodesSumUpVolumes) {
    if (std::thread::hardware_concurrency() < 2) GTEST_SKIP() << "this machine has one processor";
    // The second thread has the last tenth of the averaged triangles, few volumes, and the nodes next to the
    // first thread's last ones: without meeting it takes the volumes of the step before.
    expect_the_same_of_two_threads(scene_of(
        scene_head("plane strain", 0.003, 0.3) +
        box_body("target", {0, 0, 60, 40}, {70, 61}, "element = \"averaged triangle\"\nvelocity = [0, 5]") +
        box_body("flyer", {1, 40, 31, 70}, {60, 60}, "element = \"triangle\"\nvelocity = [5, -30]") +
        contact_pair("hit", "flyer.bottom", "target.top")));
}

TEST(Determinism, RepeatsGiveTheSameState) {
    const auto run = [] {
        RecordedRun r(rods());
        r.to_end();
        return r.solver.statistics().state_hash;
    };
    const std::string first = run();
    EXPECT_EQ(run(), first);
}

TEST(Determinism, SavedStatesGoOnAsIfNothingHadBeen) {
    RecordedRun whole(rods());
    whole.to_end();
    RecordedRun parts(rods());
    for (int n = 0; n < 40; ++n) parts.step();
    const SolverState saved = parts.solver.save();
    for (int n = 0; n < 30; ++n) parts.step();
    parts.solver.restore(saved);
    parts.to_end();
    EXPECT_EQ(parts.solver.statistics().state_hash, whole.solver.statistics().state_hash);
}

TEST(Determinism, SavedStatesOfAveragedTrianglesGoOn) {
    // Nodal volumes are not part of the state: restoring makes them anew, also those of the lagged positions.
    for (const char* lagged : {"false", "true"}) {
        for (const char* viscosity : {"", "viscosity = { linear = 0.06, quadratic = 1.2 }\n"}) {
            RecordedRun run(
                scene_of(scene_head("axisymmetric", 0.002, 0.3, "courant = 0.5", viscosity) +
                             box_body("flyer", {0, 4, 4, 8}, {9, 9},
                                      "element = \"averaged triangle\"\nvelocity = [0, -30]") +
                             box_body("target", {0, 0, 6, 4}, {13, 9}, "element = \"averaged triangle\"") +
                             contact_pair("hit", "flyer.bottom", "target.top"),
                         {std::string("model.lagged=") + lagged}));
            for (int n = 0; n < 10; ++n) run.step();
            const SolverState saved = run.solver.save();
            const auto stress = run.solver.snapshot()->stress;
            const double error = run.solver.statistics().elastic_energy_error;
            for (int n = 0; n < 4; ++n) run.step();
            const std::string hash = run.solver.statistics().state_hash;
            for (int n = 0; n < 5; ++n) run.step();
            run.solver.restore(saved);
            EXPECT_EQ(run.solver.snapshot()->stress, stress) << lagged << viscosity;
            EXPECT_EQ(run.solver.statistics().elastic_energy_error, error) << lagged << viscosity;
            for (int n = 0; n < 4; ++n) run.step();
            EXPECT_EQ(run.solver.statistics().state_hash, hash) << lagged << viscosity;
        }
    }
}

/// Numbers of one build that all builds must give to 1e-9: Debug, Release, with and without wide registers.
TEST(Determinism, AllBuildsAgreeWithTheGoldenNumbers) {
    RecordedRun run(
        scene_of(scene_head("axisymmetric", 0.02, 0.3, "fixed = 1e-4") +
                 box_body("flyer", {0, 10, 6, 16}, {5, 6}, "velocity = [0, -30]") +
                 box_body("target", {0, 0, 12, 10}, {7, 8}, "element = \"mean-dilatation quad\"") +
                 contact_pair("hit", "flyer.bottom", "target.top")));
    run.to_end();
    const RunStatistics s = run.solver.statistics();
    const auto snapshot = run.solver.snapshot();
    const auto expect = [](double value, double golden) {
        EXPECT_NEAR(value, golden, 1e-9 * std::abs(golden)) << fmt::format("{:.17g}", value);
    };
    EXPECT_EQ(s.steps, 200);
    expect(s.pairs[0].impulse[1], 0.20998638442350134);
    expect(s.pairs[0].peak_force, 87.01905543088526);
    expect(s.pairs[0].work, -0.12074199981655163);
    expect(snapshot->bodies[0].velocity[1], 9.4201121290342353);
    expect(snapshot->bodies[1].velocity[1], -5.913016819355132);
    expect(snapshot->energy.internal, 1.030109320475761);
    expect(snapshot->position[2 * 20], 2.4030533255831998);
}

}  // namespace
}  // namespace percuss::testing
