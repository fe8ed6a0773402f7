// Leaving out what no wave has reached changes no bit of a run.
#include "verification/kinds.hpp"

namespace percuss::testing {
namespace {

struct Outcome {
    std::string hash;
    std::vector<std::vector<double>> rows;
    double visited;
};

Outcome run(const Scene& scene, std::int64_t steps, bool skip, int threads = 1) {
    RecordedRun r(scene, threads);
    if (!skip) r.solver.visit_all();
    Outcome outcome;
    while (!r.solver.finished() && r.solver.steps() < steps) {
        r.step();
        const auto row = r.solver.history_row();
        outcome.rows.emplace_back(row.begin(), row.end());
    }
    const RunStatistics statistics = r.solver.statistics();
    outcome.hash = statistics.state_hash;
    outcome.visited = statistics.visited_share;
    return outcome;
}

/// The share of blocks that were visited.
double expect_the_same_bits(const Scene& scene, std::int64_t steps, int threads = 1) {
    const Outcome all = run(scene, steps, false), some = run(scene, steps, true, threads);
    EXPECT_EQ(some.hash, all.hash);
    EXPECT_TRUE(some.rows == all.rows) << "histories differ";
    EXPECT_EQ(all.visited, 1);
    return some.visited;
}

class QuietRegionsOf : public ::testing::TestWithParam<Kind> {};

TEST_P(QuietRegionsOf, GiveTheSameBits) { expect_the_same_bits(GetParam().scene(), GetParam().steps); }

INSTANTIATE_TEST_SUITE_P(All, QuietRegionsOf, ::testing::ValuesIn(kinds_of_runs),
                         [](const auto& of) { return std::string(of.param.name); });

/// A bar at rest of 200 x 10, hit at its lower end by a plate of 5 x 10 for as long as a wave takes through
/// two thirds of it.
std::string struck_bar(const std::string& geometry, const std::string& element, double nu,
                       const std::string& material = "") {
    return scene_head(geometry, 0.026, nu, "courant = 0.9", material) +
           box_body("plate", {0, -5, 10, 0}, {5, 2}, "velocity = [0, 10]\nelement = \"" + element + "\"") +
           box_body("bar", {0, 0, 10, 200}, {5, 100}, "element = \"" + element + "\"") +
           contact_pair("hit", "plate.top", "bar.bottom");
}

/// Signals of the mesh travel one row of elements a step, and eight elements, 1.6 rows, are visited at a
/// time: after n steps no more than n
/// + 3 rows of the 100 and the plate's 2.
void expect_the_front_of_a_struck_bar(const std::string& text) {
    const Scene scene = scene_of(text);
    const double visited = expect_the_same_bits(scene, 1000);
    RecordedRun r(scene);
    r.to_end();
    double most = 0;
    const auto steps = static_cast<double>(r.solver.steps());
    for (int n = 0; n < r.solver.steps(); ++n) most += std::min(1.0, (n + 5) / 102.0) / steps;
    EXPECT_LT(visited, most);
    EXPECT_GT(visited, most - 0.08);
}

TEST(QuietRegions, LeaveOutWhatTheFrontOfAStruckBarHasNotReached) {
    for (const char* element : {"one-point quad", "mean-dilatation quad", "triangle"}) {
        for (const char* geometry : {"axisymmetric", "plane strain", "plane stress"}) {
            for (const double nu : {0.0, 0.3}) {
                SCOPED_TRACE(::testing::Message() << element << ' ' << geometry << ' ' << nu);
                expect_the_front_of_a_struck_bar(struck_bar(geometry, element, nu));
            }
        }
    }
}

TEST(QuietRegions, LeaveOutWhatMayFlowOrIsDamped) {
    const char* flows =
        "viscosity = { linear = 0.06, quadratic = 1.2 }\n"
        "[material.plastic]\nyield = 0.05\nsaturation = 0.1\nrate = 10\n";
    expect_the_front_of_a_struck_bar(struck_bar("axisymmetric", "one-point quad", 0.3, flows));
}

TEST(QuietRegions, AreTheSameForTwoThreads) {
    const Scene scene = scene_of(scene_head("plane strain", 0.004, 0.3) +
                                 box_body("flyer", {20, 40, 40, 50}, {40, 20}, "velocity = [5, -30]") +
                                 box_body("target", {0, 0, 60, 40}, {80, 60}) +
                                 contact_pair("hit", "flyer.bottom", "target.top"));
    EXPECT_LT(expect_the_same_bits(scene, 10000, 2), 0.9);
}

TEST(QuietRegions, WakeUnderLateLoadsAndDrives) {
    const std::string bar = scene_head("axisymmetric", 0.03, 0.3);
    const Scene pressed =
        scene_of(bar + box_body("bar", {0, 0, 10, 200}, {5, 100}, "",
                                "[[body.load]]\nedge = \"top\"\npressure = [[0.005, 0], [0.006, 0.1]]"));
    EXPECT_LT(expect_the_same_bits(pressed, 1000), 0.6);
    const Scene driven = scene_of(
        bar +
        box_body(
            "bar", {0, 0, 10, 200}, {5, 100}, "",
            "[[body.prescribed]]\nedge = \"bottom\"\ndirection = \"axial\"\nvelocity = 2\nfrom = 0.005"));
    EXPECT_LT(expect_the_same_bits(driven, 1000), 0.6);
}

TEST(QuietRegions, TouchedFarFromWhatMovesInTheSameBody) {
    // The flyer comes down on the middle of the target while a wave runs in from its left end.
    const Scene scene = scene_of(scene_head("plane strain", 0.005, 0.3) +
                                 box_body("hammer", {-10, 0, 0, 10}, {5, 5}, "velocity = [5, 0]") +
                                 box_body("flyer", {60, 10.02, 70, 20}, {5, 5}, "velocity = [0, -20]") +
                                 box_body("target", {0, 0, 120, 10}, {60, 5}) +
                                 contact_pair("left", "hammer.right", "target.left") +
                                 contact_pair("top", "flyer.bottom", "target.top"));
    EXPECT_LT(expect_the_same_bits(scene, 1000), 0.8);
}

TEST(QuietRegions, SavedStatesKnowThem) {
    const Scene scene = scene_of(struck_bar("axisymmetric", "one-point quad", 0.3));
    RecordedRun whole(scene), parts(scene), other(scene);
    whole.to_end();
    for (int n = 0; n < 20; ++n) parts.step();
    const SolverState early = parts.solver.save();
    for (int n = 0; n < 50; ++n) parts.step();
    parts.solver.restore(early);
    parts.to_end();
    EXPECT_EQ(parts.solver.statistics().state_hash, whole.solver.statistics().state_hash);
    EXPECT_EQ(parts.solver.statistics().visited_share, whole.solver.statistics().visited_share);
    other.solver.restore(early);
    other.to_end();
    EXPECT_EQ(other.solver.statistics().state_hash, whole.solver.statistics().state_hash);
}

TEST(QuietRegions, BodiesAtRestHaveNoStress) {
    // Not even of rounding: meshes of odd sizes, curved or far from the origin.
    for (const char* scene : {"rods", "nail", "taylor"}) {
        Solver solver(load_scene(PERCUSS_SOURCE_DIR "/scenes/" + std::string(scene) + ".toml"));
        const auto snapshot = solver.snapshot();
        for (const auto& stress : snapshot->stress)
            for (const double component : stress) EXPECT_NEAR(component, 0, 1e-12);
    }
    RecordedRun alone(scene_of(scene_head("axisymmetric", 0.01, 0.3) +
                               box_body("far", {123.4, 77.7, 139.1, 91.3}, {13, 11})));
    for (int n = 0; n < 20; ++n) alone.step();
    EXPECT_EQ(alone.solver.statistics().visited_share, 0);
    alone.solver.visit_all();
    for (int n = 0; n < 20; ++n) alone.step();
    for (const Node& node : alone.solver.nodes()) {
        EXPECT_EQ(node.v[0], 0);
        EXPECT_EQ(node.v[1], 0);
    }
}

}  // namespace
}  // namespace percuss::testing
