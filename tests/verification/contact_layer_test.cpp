// Viscosity in the layers at a contact face: what it takes and what it books.
#include <algorithm>
#include <cmath>

#include "verification/schemes.hpp"

namespace percuss::testing {
namespace {

Scene rods_with(const std::string& layer, double courant = 0.9, const std::string& geometry = "plane stress",
                const std::string& element = "one-point quad") {
    return scene_of(
        scene_head(geometry, 0.02, 0, fmt::format("courant = {}", courant)) +
        box_body("striker", {0, -40, 4, 0}, {2, 20}, "velocity = [0, 10]\nelement = \"" + element + "\"") +
        box_body("rod", {0, 0, 4, 80}, {2, 40}) + joint_problem +
        contact_pair("hit", "striker.top", "rod.bottom") + layer);
}

/// Highest compression in the rod over that of the plane wave, minus one.
double overshoot(RecordedRun& run) {
    const double wave = 0.5 * 10 * std::sqrt(young * density);
    double most = 0;
    while (!run.solver.finished()) {
        run.step();
        if (run.solver.steps() % 2 == 0)
            for (const auto& s : run.solver.snapshot()->stress) most = std::max(most, -s[1] / wave);
    }
    return most - 1;
}

TEST(ContactLayer, LowersTheOvershootForLittleEnergy) {
    RecordedRun without(rods_with("")), with(rods_with("layer = { viscosity = 0.06, layers = 3 }\n"));
    const double before = overshoot(without), after = overshoot(with);
    RecordProperty("overshoot", fmt::format("{:.4f} to {:.4f}", before, after));
    EXPECT_LT(after, before - 0.015);
    const RunStatistics s = with.solver.statistics();
    const double viscous = with.column("energy.viscous").back();
    RecordProperty("taken", fmt::format("{:.5f}", viscous / s.initial_energy));
    EXPECT_GT(viscous, 0);
    EXPECT_LT(viscous, 0.01 * s.initial_energy);
    EXPECT_LT(with.unexplained_energy(), 1e-12 * s.initial_energy);
    EXPECT_LT(s.elastic_energy_error, 2 * without.solver.statistics().elastic_energy_error + 1e-12)
        << "viscous work is told from the energy of strains";
    EXPECT_LT(momentum_error(s), 1e-12);
    double of_bodies = 0;
    for (const BodyEnergies& body : s.bodies) of_bodies += body.viscous;
    EXPECT_NEAR(of_bodies, viscous, 0.01 * viscous) << "one of them a step later";
}

TEST(ContactLayer, OfAllLayersIsTheViscosityOfTheMaterial) {
    for (const char* geometry : {"plane strain", "axisymmetric"}) {
        for (const char* element : {"one-point quad", "triangle"}) {
            Scene layered = rods_with("layer = { viscosity = 0.1, layers = 100 }\n", 0.5, geometry, element);
            Scene scene = rods_with("", 0.5, geometry, element);
            scene.materials[0].viscosity = BulkViscosity{0.1, 0};
            layered.step.fixed = scene.step.fixed = 1e-4;
            RecordedRun layers(layered), material(scene);
            layers.to_end();
            material.to_end();
            const auto one = layers.column("contact.hit." + std::string(geometry[0] == 'a' ? "axial" : "y")),
                       other =
                           material.column("contact.hit." + std::string(geometry[0] == 'a' ? "axial" : "y"));
            const double peak = -*std::min_element(other.begin(), other.end());
            ASSERT_GT(peak, 0);
            EXPECT_LE(layers.solver.critical_step(), 1.001 * material.solver.critical_step());
            EXPECT_GE(layers.solver.critical_step(), 0.9 * material.solver.critical_step());
            ASSERT_EQ(one.size(), other.size());
            for (std::size_t n = 0; n < one.size(); ++n) ASSERT_NEAR(one[n], other[n], 0.02 * peak) << n;
            EXPECT_NEAR(layers.column("energy.viscous").back(), material.column("energy.viscous").back(),
                        0.02 * material.column("energy.viscous").back());
        }
    }
}

TEST(ContactLayer, StaysStableAtTheCriticalStep) {
    RecordedRun run(rods_with("layer = { viscosity = 1.5, layers = 2 }\n", 0.98));
    const double with = run.solver.critical_step(), without = Solver(rods_with("", 0.98)).critical_step();
    EXPECT_LT(with, 0.6 * without) << "2 xi more of damping than the frequency bears";
    run.to_end();
    EXPECT_LT(run.solver.statistics().maximum_growth, 1e-9);
}

TEST(ContactLayer, IsRefusedWhereViscosityIsAlready) {
    Scene scene = rods_with("layer = { viscosity = 0.06 }\n");
    scene.materials[0].viscosity = BulkViscosity{0.06, 0};
    try {
        Solver solver(scene);
        FAIL();
    } catch (const SceneError& error) {
        EXPECT_NE(std::string(error.what()).find("has a material with viscosity already"), std::string::npos)
            << error.what();
    }
}

}  // namespace
}  // namespace percuss::testing
