// The nail with friction: what holds it after the drive, and what it takes to pull it out.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "verification/run.hpp"

namespace percuss::testing {
namespace {

double mean(const std::vector<double>& time, const std::vector<double>& values, double from, double to) {
    double sum = 0, span = 0;
    for (std::size_t n = 1; n < time.size(); ++n) {
        if (time[n] < from || time[n] > to) continue;
        sum += values[n] * (time[n] - time[n - 1]);
        span += time[n] - time[n - 1];
    }
    return sum / span;
}

Scene nail(const std::vector<std::string>& overrides) {
    std::vector<std::string> all{"parameters.mesh=0.4", "parameters.piston_speed=130"};
    all.insert(all.end(), overrides.begin(), overrides.end());
    return load_scene(PERCUSS_SOURCE_DIR "/scenes/nail.toml", all);
}

TEST(NailFriction, HoldsTheNailUntilItIsPulled) {
    constexpr double mu = 0.1;
    RecordedRun run(nail({"parameters.friction=0.1", "parameters.lift_time=0.05"}));
    run.to_end();
    const auto time = run.column("time"), pull = run.column("body.nail.drive.axial"),
               press = run.column("contact.substrate-nail.radial"),
               friction = run.column("contact.substrate-nail.friction.axial"),
               active = run.column("contact.substrate-nail.active"),
               stuck = run.column("contact.substrate-nail.sticking"),
               speed = run.column("body.nail.velocity.axial");
    // After the drive the nail stands in the steel, stuck.
    EXPECT_LT(std::abs(mean(time, speed, 0.35, 0.4)), 0.5) << "m/s; without friction it comes back at 8 m/s";
    EXPECT_GT(mean(time, stuck, 0.35, 0.4), 0.8 * mean(time, active, 0.35, 0.4));
    // Lifted, it slides: friction is mu times the contact force, whose radial part is all but the cosine of
    // the cone (0.2 in 20) and of the tip's last third (0.1 to 0.2).
    const double lifted = mean(time, friction, 0.43, 0.45), pressed = mean(time, press, 0.43, 0.45);
    EXPECT_NEAR(lifted, mu * pressed, 0.03 * mu * pressed);
    EXPECT_LT(mean(time, stuck, 0.43, 0.45), 0.05 * mean(time, active, 0.43, 0.45));
    // The tip helps to push the nail out: the pull stays below friction alone, by the sheets as well.
    const double force = mean(time, pull, 0.43, 0.45);
    EXPECT_GT(force, 0.3 * lifted);
    EXPECT_LT(force, 1.2 * lifted);
    const RunStatistics s = run.solver.statistics();
    EXPECT_EQ(s.contact_solver.unsettled, 0);
    EXPECT_EQ(s.contact_solver.fallbacks, 0);
    EXPECT_LT(s.maximum_growth, 1e-5);
    EXPECT_LT(run.unexplained_energy(), 1e-9 * s.initial_energy);
    for (const PairStatistics& pair : s.pairs) EXPECT_LE(pair.friction_work, 0);
}

TEST(NailFriction, WithoutItTheNailComesOutByItself) {
    RecordedRun run(nail({"parameters.piston_speed=90"}));  // faster it would go through
    run.to_end();
    EXPECT_GT(mean(run.column("time"), run.column("body.nail.velocity.axial"), 0.35, 0.4), 5);
}

}  // namespace
}  // namespace percuss::testing
