// A bar on a rigid wall: stress rho c v, duration 2 L / c, restitution 1.
#include <cmath>

#include "verification/run.hpp"

namespace percuss::testing {
namespace {

// Slow, so that strains of 2e-4 do not change the wave speed by more than the mesh does.
constexpr double length = 100, speed = 1, width = 2;
constexpr int elements = 100;
const double wave_speed = std::sqrt(young / density);

Scene bounce() {
    return scene_of(
        scene_head("plane stress", 0.05, 0) +
        box_body("bar", {0, 0, width, length}, {1, elements}, "velocity = [0, -1]") +
        box_body("wall", {-5, -5, 7, 0}, {3, 1}, "", "[[body.constraint]]\nfixed = [\"x\", \"y\"]") +
        contact_pair("hit", "bar.bottom", "wall.top") +
        "[[probe]]\nname = \"middle\"\nbody = \"bar\"\nat = [1, 20.5]\nrecord = [\"stress.y\"]\n");
}

TEST(WallImpact, HasTheForceDurationAndRestitutionOfTheBar) {
    RecordedRun run(bounce());
    run.to_end();
    const auto time = run.column("time"), force = run.column("contact.hit.y");
    const double exact = density * wave_speed * speed * width, pulse = 2 * length / wave_speed;
    // Dispersion of 100 elements: as for the rods, less by the finer mesh.
    EXPECT_LT(force_error(time, force, {{0, 0}, {0, exact}, {pulse, exact}, {pulse, 0}}, 0.8e-3, 0.05), 0.03);
    double last = 0;
    for (std::size_t n = 0; n < force.size(); ++n)
        if (force[n] > 0) last = time[n];
    EXPECT_NEAR(last, pulse, 3 * length / elements / wave_speed);
    // Half of one element's momentum goes with the plastic stop and about as much stays as vibration.
    EXPECT_NEAR(run.solver.snapshot()->bodies[0].velocity[1], speed, 1.5 / elements * speed);
    EXPECT_EQ(run.solver.statistics().pairs[0].events, 2);
}

TEST(WallImpact, StressIsTheImpedanceTimesTheSpeed) {
    RecordedRun run(bounce());
    run.to_end();
    const auto time = run.column("time"), stress = run.column("probe.middle.stress.y");
    double sum = 0;
    int count = 0;
    for (std::size_t n = 0; n < time.size(); ++n) {
        if (time[n] * wave_speed < 30 || time[n] * wave_speed > 170)
            continue;  // front passed, its reflection not there yet
        sum += stress[n];
        ++count;
    }
    EXPECT_NEAR(sum / count, -density * wave_speed * speed, 0.005 * density * wave_speed * speed);
}

}  // namespace
}  // namespace percuss::testing
