// Coulomb friction against closed forms: block, incline, oscillator, shear wave.
#include <algorithm>
#include <cmath>

#include "verification/run.hpp"

namespace percuss::testing {
namespace {

constexpr const char* joint = "[contact_solver]\nscheme = \"joint\"\n";

std::string floor_with(const std::string& master, double friction, double angle = 0) {
    return joint +
           fmt::format("[[wall]]\nname = \"floor\"\npoint = [0, 0]\nnormal = [{:.17g}, {:.17g}]\n",
                       -std::sin(angle), std::cos(angle)) +
           contact_pair("sole", master, "floor") + fmt::format("friction = {:.17g}\n", friction);
}

/// A block that slides on a floor under a weight of 1 mm/ms^2.
Scene sliding_block(double friction, double speed, double duration,
                    const std::vector<std::string>& overrides = {}) {
    return scene_of(scene_head("plane strain", duration, 0.3) +
                        box_body("block", {0, 0, 6, 2}, {6, 2},
                                 fmt::format("velocity = [{:.17g}, 0]\nbody_force = [0, -1]", speed)) +
                        floor_with("block.bottom", friction),
                    overrides);
}

// While all nodes slide one way, friction is the coefficient times the contact force in every step: the mass
// centre's velocities obey m dv_x = -mu (m dv_y + m g dt) to rounding, however the block bounces.
TEST(Friction, BlockSlidesToAStop) {
    constexpr double mu = 0.3, speed = 0.15, stop = speed / mu;
    RecordedRun run(sliding_block(mu, speed, 1.2 * stop));
    run.to_end();
    const auto time = run.column("time"), vx = run.column("body.block.velocity.x"),
               vy = run.column("body.block.velocity.y"), stuck = run.column("contact.sole.sticking");
    const auto friction = run.column("energy.friction"), push = run.column("contact.sole.friction.x"),
               press = run.column("contact.sole.y");
    double position = 0, slowest = speed;
    for (std::size_t n = 0; n < time.size(); ++n) {
        if (n > 0) position += 0.5 * (vx[n - 1] + vx[n]) * (time[n] - time[n - 1]);
        if (time[n] < 0.9 * stop) {
            ASSERT_NEAR(vx[n], speed - mu * (time[n] + vy[n]), 1e-11) << n;
            ASSERT_NEAR(push[n], -mu * press[n], 1e-12 * (1 + press[n]));
            ASSERT_EQ(stuck[n], 0);
        }
        slowest = std::min(slowest, vx[n]);
    }
    // After the stop only vibrations of the shear that friction had caused, mu rho g h / (rho c_s) = mu g h /
    // c_s, and of the bounces are left.
    const double shear_wave = std::sqrt(young / 2.6 / density), vibration = mu * 2 / shear_wave;
    EXPECT_NEAR(vx.back(), 0, 2 * vibration);
    EXPECT_GT(slowest, -2 * vibration) << "friction stops the block and does not turn it";
    // Until the stop the block may have bounced by v_y: mu times that is what the way may be off.
    EXPECT_NEAR(position, 0.5 * speed * stop, 0.01 * speed * stop);
    const double mass = 12 * density;
    EXPECT_NEAR(friction.back(), -0.5 * mass * speed * speed, 0.01 * 0.5 * mass * speed * speed);
    EXPECT_LT(run.unexplained_energy(), 1e-12 * 0.5 * mass * speed * speed);
    EXPECT_GT(*std::max_element(stuck.begin(), stuck.end()), 6);
    EXPECT_EQ(run.solver.statistics().contact_solver.unsettled, 0);
}

/// A block on a wall inclined by 30 degrees, its sides along and across the wall, under a weight of 1
/// mm/ms^2.
Scene incline(double friction, const std::string& viscosity = "") {
    constexpr double angle = M_PI / 6;
    const double c = std::cos(angle), s = std::sin(angle);
    const auto corner = [&](double along, double up) {
        return fmt::format("[{:.17g}, {:.17g}]", along * c - up * s, along * s + up * c);
    };
    return scene_of(scene_head("plane strain", 0.3, 0.3, "courant = 0.9", viscosity) +
                    fmt::format("[[body]]\nname = \"block\"\nmaterial = \"steel\"\nbody_force = [0, "
                                "-1]\n[[body.block]]\ncorners = [{}, {}, {}, {}]\ndivisions = [6, 2]\n",
                                corner(0, 0), corner(6, 0), corner(6, 2), corner(0, 2)) +
                    floor_with("block.bottom", friction, angle));
}

// tan 30 = 0.577. Viscosity damps the small hops of a block that is set down in an instant: while it is in
// the air nothing holds it.
TEST(Friction, InclineHoldsABlockBelowTheAngleOfFriction) {
    RecordedRun run(incline(0.7, "viscosity = { linear = 1.0, quadratic = 0 }"));
    run.to_end();
    const auto time = run.column("time"), vx = run.column("body.block.velocity.x"),
               vy = run.column("body.block.velocity.y"), fx = run.column("contact.sole.x"),
               fy = run.column("contact.sole.y"), stuck = run.column("contact.sole.sticking");
    // The shear of the block swings on, undamped by what resists compression only: its speed is that of a
    // sudden weight in one crossing of the shear wave, g sin h / c_s, and the force swings with it by less
    // than its half.
    const double weight = 12 * density, sway = 0.5 * 2 / std::sqrt(young / 2.6 / density);
    for (std::size_t n = time.size() / 2; n < time.size(); ++n) {
        ASSERT_EQ(stuck[n], 7);
        ASSERT_LT(std::hypot(vx[n], vy[n]), 0.01 * sway);
        ASSERT_NEAR(fx[n], 0, 0.02 * weight);
        ASSERT_NEAR(fy[n], weight, 0.02 * weight) << "contact force and friction together bear the weight";
    }
}

TEST(Friction, InclineLetsABlockGoAboveTheAngleOfFriction) {
    constexpr double mu = 0.4;
    const double c = std::cos(M_PI / 6), s = std::sin(M_PI / 6);
    RecordedRun run(incline(mu));
    run.to_end();
    const auto time = run.column("time"), vx = run.column("body.block.velocity.x"),
               vy = run.column("body.block.velocity.y");
    const auto down = [&](std::size_t n) { return -(vx[n] * c + vy[n] * s); };
    const auto off = [&](std::size_t n) { return -vx[n] * s + vy[n] * c; };
    std::size_t exact = 0;  // but where a node pauses for an instant while the block vibrates
    for (std::size_t n = 1; n < time.size(); ++n) {
        const double expected = (s - mu * c) * (time[n] - time[n - 1]) - mu * (off(n) - off(n - 1));
        exact += std::abs(down(n) - down(n - 1) - expected) < 1e-15;
    }
    EXPECT_GT(exact, 95 * time.size() / 100);
    EXPECT_NEAR(down(time.size() - 1), (s - mu * c) * time.back(), 0.01 * (s - mu * c) * time.back());
}

/// Pads that bear bodies and do not shear.
const std::string pad_rules =
    "[[body.constraint]]\nfixed = [\"x\"]\n[[body.constraint]]\nedge = \"bottom\"\nfixed = [\"y\"]\n";

/// A body that is lowered by `depth` until `pressed`, all of it alike, and then moves sideways only.
std::string lowered(double depth, double pressed) {
    return fmt::format(
        "[[body.prescribed]]\ndirection = \"y\"\nvelocity = [[0, 0], [{}, {:.17g}], [{}, 0]]\n",
        0.5 * pressed, -2 * depth / pressed, pressed);
}

/// One element, pressed on a pad and then drawn along by its upper side: the lower nodes' mass on the spring
/// of the element's shear, with a constant contact force.
struct Oscillator {
    static constexpr double mu = 0.2, strain = 1e-4, pressed = 0.005, speed = 0.01, jump = 1e-7, dt = 2e-5;
    const double force = 3 * young * strain;                 // the pad is 3 mm wide; nu = 0
    const double stiffness = young / 2, mass = density / 2;  // of 1 mm x 1 mm x 1 mm
    const double frequency = std::sqrt(stiffness / mass);
    const double stuck =
        mu * force / (stiffness * speed);  // until the spring has drawn as much as friction holds

    [[nodiscard]] Scene scene(const std::string& drive, double duration) const {
        return scene_of(
            scene_head("plane strain", duration, 0, fmt::format("fixed = {}", dt)) +
            box_body("pad", {-1, -1, 2, 0}, {1, 1}, "", pad_rules) +
            box_body("mass", {0, 0, 1, 1}, {1, 1}, "hourglass = 0",
                     lowered(strain, pressed) +
                         "[[body.prescribed]]\nedge = \"top\"\ndirection = \"x\"\nvelocity = " + drive +
                         "\n") +
            joint + contact_pair("sole", "mass.bottom", "pad.top") + fmt::format("friction = {}\n", mu));
    }
};

// Drawn at a constant speed V the mass sticks until V t k = mu N, then moves by V (1 - cos w t): it comes to
// rest once a period, with the spring just as far drawn as when it began.
TEST(Friction, OscillatorSticksAndSlips) {
    const Oscillator o;
    const double begin = o.pressed + o.stuck, period = 2 * M_PI / o.frequency;
    RecordedRun run(
        o.scene(fmt::format("[[{:.17g}, 0], [{:.17g}, {:.17g}]]", o.pressed, o.pressed + o.jump, o.speed),
                begin + 2.5 * period));
    run.to_end();
    const auto time = run.column("time"), v = run.column("body.mass.velocity.x"),
               force = run.column("contact.sole.friction.x"), press = run.column("contact.sole.y");
    double worst = 0;
    for (std::size_t n = 0; n < time.size(); ++n) {
        if (time[n] < o.pressed + 2 * o.dt) continue;
        ASSERT_NEAR(press[n], o.force, 1e-3 * o.force) << "second order of the strain";
        const double mass = 2 * v[n] - o.speed;  // the body's mean is of both sides
        const double expected =
            time[n] < begin ? 0 : o.speed * (1 - std::cos(o.frequency * (time[n] - begin)));
        worst = std::max(worst, std::abs(mass - expected));
        if (expected > 0.05 * o.speed) {
            ASSERT_NEAR(force[n], -o.mu * press[n], 1e-9 * o.force);
        }
    }
    // Each slip begins, and each moment of rest ends, within a step: a phase of w dt for each of the three.
    EXPECT_LT(worst, 3 * o.speed * o.frequency * o.dt);
}

// Turned round when it is at rest, the drive has to slacken the spring and draw it the other way, 2 mu N / (k
// V), before the mass slips back.
TEST(Friction, OscillatorSticksTwiceAsLongWhenItsDriveTurns) {
    const Oscillator o;
    const double period = 2 * M_PI / o.frequency, turn = o.pressed + o.stuck + period,
                 slip = turn + 2 * o.stuck;
    RecordedRun run(
        o.scene(fmt::format("[[{:.17g}, 0], [{:.17g}, {:.17g}], [{:.17g}, {:.17g}], [{:.17g}, {:.17g}]]",
                            o.pressed, o.pressed + o.jump, o.speed, turn, o.speed, turn + o.jump, -o.speed),
                slip + 0.5 * period));
    run.to_end();
    const auto time = run.column("time"), v = run.column("body.mass.velocity.x"),
               stick = run.column("contact.sole.sticking");
    for (std::size_t n = 0; n < time.size(); ++n) {
        if (time[n] < turn + 5e-4) continue;
        const double mass = 2 * v[n] + o.speed;
        if (time[n] < slip - 5e-4) {
            ASSERT_EQ(stick[n], 2);
            ASSERT_NEAR(mass, 0, 1e-7 * o.speed) << "the rows are regularised by 1e-8";
        } else if (time[n] > slip + 5e-4) {
            ASSERT_EQ(stick[n], 0);
            // A step's uncertainty of either slip's beginning.
            ASSERT_NEAR(mass, -o.speed * (1 - std::cos(o.frequency * (time[n] - slip))),
                        3 * o.speed * o.frequency * o.dt);
        }
    }
}

// A shear wave of stress rho c V comes down to a foot that friction holds up to mu p < 2 rho c V: the foot
// slides at 2 V - mu p / (rho c) while the wave lasts. A weaker wave does not move it. The column moves along
// the wave only; it presses on a pad that does not shear.
TEST(Friction, FootSlidesUnderAShearWaveBeyondTheLimit) {
    constexpr double height = 40, mu = 0.25, strain = 2e-4, pressed = 0.02, speed = 1;
    const double impedance = std::sqrt(density * young / 2), wave = std::sqrt(young / 2 / density);
    // The pad is twice as wide as the column, which so bears twice the pad's stress. As a velocity:
    const double limit = 2 * mu * young * strain / impedance;
    const double arrival = pressed + height / wave;
    for (const double drive : {speed, 0.4 * limit}) {
        RecordedRun run(scene_of(
            scene_head("plane strain", arrival + 1.2 * height / wave, 0) +
            box_body("pad", {0, -1, 1, 0}, {1, 1}, "", pad_rules) +
            box_body(
                "column", {0.25, 0, 0.75, height}, {1, 80}, "",
                lowered(strain, pressed) +
                    fmt::format("[[body.prescribed]]\nedge = \"top\"\ndirection = \"x\"\nvelocity = [[{}, "
                                "0], [{}, {:.17g}]]\n",
                                pressed, pressed + 0.001, drive)) +
            joint + contact_pair("foot", "column.bottom", "pad.top") + fmt::format("friction = {}\n", mu) +
            "[[probe]]\nname = \"foot\"\nbody = \"column\"\nat = [0.25, 0]\nrecord = "
            "[\"displacement.x\"]\n"));
        run.to_end();
        const auto time = run.column("time"), way = run.column("probe.foot.displacement.x");
        // The foot's mean speed on the plateau, away from the wave's rounded front.
        const double from = arrival + 0.3 * height / wave, to = arrival + 0.9 * height / wave;
        const auto at = [&](double t) {
            return static_cast<std::size_t>(std::lower_bound(time.begin(), time.end(), t) - time.begin());
        };
        const double slid = (way[at(to)] - way[at(from)]) / (time[at(to)] - time[at(from)]);
        const double expected = std::max(0.0, 2 * drive - limit);
        EXPECT_NEAR(slid, expected, 0.01 * speed) << drive;
    }
}

// A stack of rough blocks hit from the side: what friction and contact took is all that is missing.
TEST(Friction, LedgerClosesWithManyRoughPairs) {
    const std::string rough = "friction = 0.4\n";
    RecordedRun run(scene_of(scene_head("plane strain", 0.05, 0.3) +
                             box_body("floor", {0, 0, 12, 4}, {9, 4}, "",
                                      "[[body.constraint]]\nedge = \"bottom\"\nfixed = [\"x\", \"y\"]\n") +
                             box_body("wall", {0, 4, 4, 10}, {4, 7}) +
                             box_body("block", {4.02, 4.03, 9, 8}, {5, 5}, "velocity = [-20, -30]") + joint +
                             contact_pair("floor-wall", "wall.bottom", "floor.top") + rough +
                             contact_pair("floor-block", "block.bottom", "floor.top") + rough +
                             contact_pair("wall-block", "block.left", "wall.right") + rough));
    run.to_end();
    const RunStatistics s = run.solver.statistics();
    EXPECT_LT(run.unexplained_energy(), 1e-9 * s.initial_energy);
    double friction = 0;
    for (const PairStatistics& pair : s.pairs) {
        EXPECT_LT(pair.friction_work, 0);
        friction += pair.friction_work;
    }
    EXPECT_LT(friction, -0.005 * s.initial_energy);
    EXPECT_LT(s.maximum_growth, 1e-4);
    EXPECT_EQ(s.contact_solver.unsettled, 0);
    for (std::size_t d = 0; d < 2; ++d)
        EXPECT_NEAR(s.momentum_final[d] - s.momentum_initial[d], s.external_impulse[d],
                    1e-12 * (s.momentum_scale + s.external_impulse_gross));
}

// What a picture shows: the force on each node of either side, friction and contact together.
TEST(Friction, ForcesOnNodesAddUpToThePairs) {
    Solver solver(sliding_block(0.3, 0.15, 1));
    for (int k = 0; k < 300; ++k) ASSERT_FALSE(solver.step());
    const auto snapshot = solver.snapshot();
    std::array<double, 2> sum{0, 0};
    std::vector<std::int32_t> nodes;
    for (const ContactForce& force : snapshot->contact_forces) {
        ASSERT_TRUE(force.master) << "the floor has no nodes";
        nodes.push_back(force.node);
        for (std::size_t d = 0; d < 2; ++d) sum[d] += force.force[d];
        EXPECT_NEAR(force.force[0], -0.3 * force.force[1], 1e-12 * (force.force[1] + 1));
    }
    EXPECT_EQ(std::adjacent_find(nodes.begin(), nodes.end(), std::greater_equal<>{}), nodes.end())
        << "each node once";
    ASSERT_GT(sum[1], 0);
    const PairState& pair = snapshot->pairs[0];
    for (std::size_t d = 0; d < 2; ++d) EXPECT_NEAR(sum[d], pair.force[d], 1e-12 * sum[1]);
    EXPECT_NEAR(pair.force[0], pair.friction[0], 1e-15) << "the floor is level";
}

TEST(Friction, CoefficientZeroIsNoFriction) {
    RecordedRun without(sliding_block(0.3, 0.02, 0.02, {"contact.sole.friction=0"})),
        rough(sliding_block(0.3, 0.02, 0.02));
    without.to_end();
    rough.to_end();
    // Each step rounds stresses by eps K, hence velocities by eps c, and these errors make a random walk.
    const auto steps = static_cast<double>(without.solver.steps());
    EXPECT_NEAR(without.column("body.block.velocity.x").back(), 0.02,
                std::numeric_limits<double>::epsilon() * std::sqrt(young / density * steps));
    EXPECT_NE(without.solver.statistics().state_hash, rough.solver.statistics().state_hash);
    for (const HistoryColumn& column : history_columns(without.solver.setup()->scene))
        EXPECT_EQ(column.name.find("friction"), std::string::npos) << column.name;
}

}  // namespace
}  // namespace percuss::testing
