// Coulomb friction in every scheme that knows it: a block that slides to a stop, and one that an incline
// holds.
#include <algorithm>
#include <cmath>
#include <limits>

#include "verification/schemes.hpp"

namespace percuss::testing {
namespace {

class FrictionOfSchemes : public ::testing::TestWithParam<SchemeChoice> {
  protected:
    static Scene block(double friction, double angle, double speed, double duration,
                       const std::string& material = "") {
        const double c = std::cos(angle), s = std::sin(angle);
        const auto corner = [&](double along, double up) {
            return fmt::format("[{:.17g}, {:.17g}]", along * c - up * s, along * s + up * c);
        };
        return scene_of(
            scene_head("plane strain", duration, 0.3, "courant = 0.9", material) +
            fmt::format("[[body]]\nname = \"block\"\nmaterial = \"steel\"\nbody_force = [0, -1]\nvelocity = "
                        "[{:.17g}, "
                        "0]\n[[body.block]]\ncorners = [{}, {}, {}, {}]\ndivisions = [6, 2]\n",
                        speed, corner(0, 0), corner(6, 0), corner(6, 2), corner(0, 2)) +
            fmt::format("[[wall]]\nname = \"floor\"\npoint = [0, 0]\nnormal = [{:.17g}, {:.17g}]\n", -s, c) +
            bodies_pair("sole", "block", "floor", GetParam()) +
            fmt::format("friction = {:.17g}\n", friction));
    }
};

// While all nodes slide one way, friction is the coefficient times the contact force in every step: the mass
// centre's velocities obey m dv_x = -mu (m dv_y + m g dt) to rounding, however the block bounces.
TEST_P(FrictionOfSchemes, SlidesToAStop) {
    constexpr double mu = 0.3, speed = 0.15, stop = speed / mu;
    RecordedRun run(block(mu, 0, speed, 1.2 * stop));
    run.to_end();
    const auto time = run.column("time"), vx = run.column("body.block.velocity.x"),
               vy = run.column("body.block.velocity.y"), friction = run.column("energy.friction");
    // Means of two velocities obey it as long as the step does not change, as springs make it. Otherwise each
    // step rounds stresses by eps K, hence velocities by eps c, and these errors make a random walk.
    const double eps = std::numeric_limits<double>::epsilon();
    const double walk = eps * std::sqrt(young / density) * std::sqrt(static_cast<double>(time.size()));
    const double tolerance = std::string(GetParam().name) == "penalty" ? 1e-6 : walk;
    for (std::size_t n = 0; n < time.size() && time[n] < 0.9 * stop; ++n)
        ASSERT_NEAR(vx[n], speed - mu * (time[n] + vy[n]), tolerance) << n;
    // The shear that friction had caused swings on: mu g h / c_s; the bounce by mu v_y.
    const double mass = 12 * density, vibration = mu * 2 / std::sqrt(young / 2.6 / density);
    EXPECT_NEAR(vx.back(), 0, 2 * vibration);
    EXPECT_NEAR(friction.back(), -0.5 * mass * speed * speed, 0.01 * 0.5 * mass * speed * speed);
    EXPECT_LT(run.unexplained_energy(), 1e-12 * 0.5 * mass * speed * speed);
    EXPECT_EQ(run.solver.statistics().contact_solver.unsettled, 0);
}

TEST_P(FrictionOfSchemes, InclineHoldsBelowTheAngleOfFriction) {
    RecordedRun run(block(0.7, M_PI / 6, 0, 0.3, "viscosity = { linear = 1.0, quadratic = 0 }"));
    run.to_end();
    const auto vx = run.column("body.block.velocity.x"), vy = run.column("body.block.velocity.y"),
               fx = run.column("contact.sole.x"), fy = run.column("contact.sole.y");
    const double weight = 12 * density;
    double sideways = 0, upwards = 0, x = 0;
    const std::size_t half = fx.size() / 2;
    const auto dt = run.column("step.dt");
    for (std::size_t n = half; n < fx.size(); ++n) {
        sideways += fx[n] / static_cast<double>(fx.size() - half);
        upwards += fy[n] / static_cast<double>(fx.size() - half);
        x += dt[n] * std::hypot(vx[n], vy[n]);
    }
    EXPECT_NEAR(sideways, 0, 0.02 * weight);
    EXPECT_NEAR(upwards, weight, 0.02 * weight);
    // Free, it would have gone down by (sin 30) t^2/2 = 0.0225 mm.
    EXPECT_LT(x, 0.05 * 0.0225);
}

INSTANTIATE_TEST_SUITE_P(Schemes, FrictionOfSchemes,
                         ::testing::Values(SchemeChoice{"velocity", "node-to-side", "level = \"velocity\"\n"},
                                           SchemeChoice{"penalty", "node-to-side", "",
                                                        "[contact_solver]\nscheme = \"penalty\"\n"},
                                           SchemeChoice{"bipenalty", "node-to-side", "",
                                                        "[contact_solver]\nscheme = \"bipenalty\"\n"}),
                         [](const auto& scheme) { return std::string(scheme.param.name); });

}  // namespace
}  // namespace percuss::testing
