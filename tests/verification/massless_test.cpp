// Contact nodes without mass: what they keep, what they lose, what they cannot do.
#include <gmock/gmock.h>

#include "engine/scene/small_scene.hpp"
#include "verification/schemes.hpp"

namespace percuss::testing {
namespace {

const std::string massless = "[contact_solver]\nscheme = \"massless\"\n";

/// A bar of 20 elements hits a wall that it touches.
Scene bar_on_a_wall(const std::string& solver) {
    return scene_of(scene_head("plane stress", 0.06, 0) +
                    box_body("bar", {0, 0, 2, 100}, {2, 20}, "velocity = [0, -10]") +
                    "[[wall]]\nname = \"floor\"\npoint = [0, 0]\nnormal = [0, 1]\n" + solver +
                    contact_pair("hit", "bar.bottom", "floor"));
}

// With mass, the face nodes stop dead: half an element of twenty, 1/40 of the energy. Without, the layer is
// taken for 1 % stiffer than it is, which damps its own swing: less than that part of what the face nodes
// had.
TEST(MasslessNodes, LoseNothingOnAWall) {
    RecordedRun with(bar_on_a_wall(joint_problem)), without(bar_on_a_wall(massless));
    with.to_end();
    without.to_end();
    EXPECT_NEAR(with.solver.statistics().maximum_loss, 1.0 / 40, 1e-6);
    const RunStatistics s = without.solver.statistics();
    EXPECT_LT(s.maximum_loss, 0.05 / 40);
    EXPECT_LT(s.maximum_growth, 1e-3) << "as is promised of all hard cases";
    EXPECT_EQ(s.pairs[0].events, 2);
    EXPECT_LT(momentum_error(s), 1e-12);
    // It leaves as fast as it came, but for what rings in it: v' = v (1 - r) keeps 1 - 2 r of the energy, and
    // the front, an element wide in a bar of twenty, leaves no more than that part of it behind.
    const double all = 2 * 10 * 200 * density;
    EXPECT_NEAR(s.pairs[0].impulse[1], all, 0.5 * 0.5 / 20 * 2 * all);
    EXPECT_LT(s.pairs[0].max_penetration, 1e-6);
    EXPECT_EQ(s.contact_solver.fallbacks, 0);
}

TEST(MasslessNodes, KeepMomentaAndEnergyOnFacesThatDoNotMatch) {
    for (const double nu : {0.0, 0.3}) {
        const auto scene = [nu](const std::string& solver) {
            return scene_of(scene_head("plane strain", 0.02, nu) +
                            box_body("flyer", {1, 10.003, 7, 16}, {5, 6}, "velocity = [15, -30]") +
                            box_body("target", {0, 0, 12, 10}, {7, 8}) + solver +
                            "[[contact]]\nname = \"hit\"\nbodies = [\"flyer\", \"target\"]\n");
        };
        RecordedRun run(scene(massless)), with_mass(scene(joint_problem));
        with_mass.to_end();
        const double before = run.solver.statistics().initial_energy;
        run.to_end();
        const RunStatistics s = run.solver.statistics();
        EXPECT_GT(before, 0);
        EXPECT_GT(s.pairs[0].impulse[1], 0.01);
        EXPECT_LT(momentum_error(s), 1e-12);
        EXPECT_LT(s.maximum_growth, 1e-3) << nu;
        EXPECT_LT(s.maximum_loss, 0.5 * with_mass.solver.statistics().maximum_loss) << nu;
    }
}

RunStatistics hard_case(const std::string& name, const std::string& step) {
    RecordedRun run(load_scene(PERCUSS_SOURCE_DIR "/scenes/hard/" + name + ".toml",
                               {"contact_solver.scheme=massless", "model.step.courant=" + step}));
    run.to_end();
    return run.solver.statistics();
}

// Strains of 3 % make the layer stiffer than its elastic constants say; a force that comes a step late on
// such a spring brings energy in, unless the layer is taken for stiffer still.
TEST(MasslessNodes, BringNothingInWhereTheLayerIsStrained) {
    const RunStatistics s = hard_case("hertz", "0.9");
    EXPECT_LT(s.maximum_growth, 1e-5);
    EXPECT_LT(s.maximum_loss, 1e-4);
}

// What they do bring in: where the front of a wave parts whole faces within a step, the force found for them
// closed acts on while they open, half of force times opening. It is of second order in the step, and above
// the 1e-3 that is promised of the default.
TEST(MasslessNodes, BringInHalfOfForceTimesOpeningWhereFacesPartAtOnce) {
    const RunStatistics coarse = hard_case("stacked-plates", "0.9"),
                        fine = hard_case("stacked-plates", "0.3");
    double work = 0;
    for (const PairStatistics& pair : coarse.pairs) work += pair.work;
    EXPECT_GT(work, coarse.maximum_growth * coarse.initial_energy);
    EXPECT_LT(coarse.maximum_growth, 4e-3);
    EXPECT_LT(fine.maximum_growth, 0.15 * coarse.maximum_growth);
}

TEST(MasslessNodes, FaultsAreToldWithTheirCure) {
    EXPECT_THAT(faults_of(changed(small_scene, "divisions = [4, 2]", "divisions = [4, 1]") + massless), "");
    EXPECT_THAT(
        faults_of(changed(changed(small_scene, "slave = \"hammer.top\"", "slave = \"hammer\""),
                          "divisions = [4, 2]", "divisions = [4, 1]") +
                  massless),
        ::testing::HasSubstr("the scheme \"massless\" needs two layers of elements behind a surface; at "));
    EXPECT_THAT(
        faults_of(changed(small_scene, "slave = \"hammer.top\"", "slave = \"hammer.top\"\nfriction = 0.1") +
                  massless),
        ::testing::HasSubstr("contact nodes without mass have no slip to stop; leave 'friction' out"));
    EXPECT_THAT(
        faults_of(changed(small_scene, "name = \"rod\"", "name = \"rod\"\nelement = \"averaged triangle\"") +
                  massless),
        ::testing::HasSubstr("takes no averaged triangles, and body 'rod' has them"));
}

}  // namespace
}  // namespace percuss::testing
