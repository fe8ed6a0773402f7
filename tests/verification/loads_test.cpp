// Body forces, prescribed motion, pressure and traction against closed forms.
#include <cmath>
#include <numbers>

#include "engine/run/change_values.hpp"
#include "verification/run.hpp"

namespace percuss::testing {
namespace {

const double wave_speed = std::sqrt(young / density);

TEST(FreeFall, IsTheParabolaToRounding) {
    constexpr double g = 9.81, vx = 3, vy = 7;  // mm/ms^2: a thousand times the earth's
    for (const char* geometry : {"plane strain", "axisymmetric"}) {
        const bool ring = std::string(geometry) == "axisymmetric";
        RecordedRun run(scene_of(
            scene_head(geometry, 0.05, 0.3) +
            box_body("stone", {0, 0, 2, 3}, {2, 3},
                     fmt::format("velocity = [{}, {}]\nbody_force = [0, -{}]", ring ? 0.0 : vx, vy, g))));
        const std::vector<Node> start(run.solver.nodes().begin(), run.solver.nodes().end());
        // The step changes on the way: positions at t_n must not feel it.
        for (int n = 0; !run.solver.finished(); ++n) {
            change_step(run.solver, n % 7 < 3 ? 0.9 : 0.4);
            run.step();
            const double t = run.solver.time();
            for (std::size_t k = 0; k < start.size(); ++k) {
                ASSERT_NEAR(run.solver.nodes()[k].x[0], start[k].x[0] + (ring ? 0 : vx * t), 1e-12);
                ASSERT_NEAR(run.solver.nodes()[k].x[1], start[k].x[1] + vy * t - 0.5 * g * t * t, 1e-12);
            }
        }
        const RunStatistics s = run.solver.statistics();
        EXPECT_LT(run.unexplained_energy(), 1e-12 * s.initial_energy);
        EXPECT_LT(s.elastic_energy_error, 1e-12);
    }
}

TEST(PrescribedVelocity, PullsABarWithItsImpedance) {
    // Stress rho c v behind the front, work rho c v A v t until it comes back.
    constexpr double v = 2;
    const double end = 80 / wave_speed;
    RecordedRun run(scene_of(
        scene_head("axisymmetric", end, 0) +
        box_body(
            "bar", {0, 0, 5, 100}, {2, 100}, "",
            fmt::format("[[body.prescribed]]\nedge = \"top\"\ndirection = \"axial\"\nvelocity = {}", v))));
    run.to_end();
    const double stress = density * wave_speed * v;
    const auto snapshot = run.solver.snapshot();
    double sum = 0;
    for (std::size_t row = 40; row < 100; ++row) sum += snapshot->stress[2 * row][1] / 60;
    EXPECT_NEAR(sum, stress, 0.005 * stress);
    for (std::size_t node = snapshot->velocity.size() / 2 - 3; node < snapshot->velocity.size() / 2; ++node)
        EXPECT_EQ(snapshot->velocity[2 * node + 1], v);
    // The edge nodes jump to v at once, half an element of them.
    const double work = stress * 25 * std::numbers::pi * v * (run.column("time").back());
    EXPECT_NEAR(snapshot->energy.external - run.solver.statistics().initial_energy, work, 0.02 * work);
    EXPECT_LT(run.unexplained_energy(), 1e-12 * work);
    EXPECT_LT(run.solver.statistics().elastic_energy_error, 1e-4);
}

TEST(PrescribedVelocity, OneThatNeverActsIsLeftOut) {
    const auto bar = [](double from) {
        return scene_of(scene_head("axisymmetric", 0.01, 0) +
                        box_body("bar", {0, 0, 5, 100}, {2, 10}, "",
                                 fmt::format("[[body.prescribed]]\nedge = \"top\"\ndirection = "
                                             "\"axial\"\nvelocity = 1\nfrom = {}\n",
                                             from)));
    };
    EXPECT_EQ(bar(0.0099).bodies[0].prescribed.size(), 1U);
    EXPECT_TRUE(bar(0.01).bodies[0].prescribed.empty());
}

TEST(PrescribedVelocity, ActsBetweenTwoTimesOnly) {
    // A pulse of stress rho c v as long as the pull; the edge is free before it and after it.
    constexpr double v = 2, length = 100, area = 25 * std::numbers::pi;
    const double from = 10 / wave_speed, until = 50 / wave_speed;
    RecordedRun run(scene_of(
        scene_head("axisymmetric", 90 / wave_speed, 0) +
        box_body(
            "bar", {0, 0, 5, length}, {2, 100}, "",
            fmt::format("[[body.prescribed]]\nedge = \"top\"\ndirection = \"axial\"\nvelocity = {}\nfrom = "
                        "{}\nuntil = {}",
                        v, from, until))));
    run.to_end();
    const auto time = run.column("time"), drive = run.column("body.bar.drive.axial"),
               dt = run.column("step.dt"), mean = run.column("body.bar.velocity.axial");
    double impulse = 0, held = 0;
    for (std::size_t n = 0; n < time.size(); ++n) {
        const double middle = time[n] + 0.5 * dt[n];
        if (middle < from) {
            EXPECT_NEAR(mean[n], 0, 1e-12) << "moves before the pull at " << time[n];
        }
        if (middle < from || middle >= until) {
            EXPECT_EQ(drive[n], 0);
        }
        if (drive[n] != 0) held += dt[n];
        impulse += drive[n] * dt[n];
    }
    EXPECT_NEAR(held, until - from, dt[0]);  // whole steps
    const double mass = density * area * length;
    EXPECT_NEAR(impulse, mass * mean.back(), 1e-12 * impulse);  // Newton's second law, of sums: to rounding

    // The edge nodes, half an element of 1 mm, jump to v in the first of the held steps; in each of the
    // others the bar pulls with rho c v A.
    const double force = density * wave_speed * v * area, jump = density * area * 0.5 * v;
    EXPECT_NEAR(impulse, force * (held - dt[0]) + jump, 0.005 * force * held);
    const auto snapshot = run.solver.snapshot();
    double behind = 0, within = 0;  // at 90/c: front 80 mm from the top, end of the pulse 40 mm
    for (std::size_t row = 25; row < 55; ++row) within += snapshot->stress[2 * row][1] / 30;
    for (std::size_t row = 70; row < 100; ++row) behind += snapshot->stress[2 * row][1] / 30;
    const double stress = density * wave_speed * v;
    EXPECT_NEAR(within, stress, 0.02 * stress);
    EXPECT_NEAR(behind, 0, 0.02 * stress);
    EXPECT_LT(run.unexplained_energy(), 1e-12 * force * v * held);
}

TEST(PrescribedVelocity, TwoMotionsFollowEachOther) {
    // Up, held still, free: the later motion takes over where the earlier one ends.
    const std::string
        up = "[[body.prescribed]]\ndirection = \"axial\"\nvelocity = 2\nuntil = 0.01\n",
        still = "[[body.prescribed]]\ndirection = \"axial\"\nvelocity = 0\nfrom = 0.005\nuntil = 0.02\n";
    RecordedRun run(scene_of(scene_head("axisymmetric", 0.03, 0) +
                             box_body("bar", {0, 0, 5, 20}, {2, 20}, "", up + still)));
    run.to_end();
    const auto time = run.column("time"), mean = run.column("body.bar.velocity.axial");
    for (std::size_t n = 1; n < time.size(); ++n) {  // the mean of the steps before and after
        if (time[n] < 0.0098) {
            EXPECT_NEAR(mean[n], 2, 1e-12) << time[n];
        }
        if (time[n] > 0.0102) {
            EXPECT_NEAR(mean[n], 0, 1e-12) << time[n];
        }
    }
}

TEST(EdgeLoads, PushABarWithItsImpedance) {
    // Particle velocity p / (rho c); pressure and traction agree on a face that stays flat.
    const double end = 80 / wave_speed, pressure = 0.1;
    for (const std::string load : {"pressure = 0.1", "traction = [0, 0.1]"}) {
        RecordedRun run(scene_of(
            scene_head("axisymmetric", end, 0) +
            box_body("bar", {0, 0, 5, 100}, {2, 100}, "", "[[body.load]]\nedge = \"bottom\"\n" + load)));
        run.to_end();
        const auto snapshot = run.solver.snapshot();
        const double area = 25 * std::numbers::pi, mass = density * area * 100, time = run.solver.time();
        const auto dt = run.column("step.dt");
        // Momentum is the impulse: the first half kick belongs to the start, the last instant to half a step
        // less.
        EXPECT_NEAR(mass * snapshot->bodies[0].velocity[1], pressure * area * (time - 0.5 * dt.back()),
                    1e-5 * pressure * area * time)
            << load;
        double velocity = 0;
        for (std::size_t row = 0; row < 60; ++row) velocity += snapshot->velocity[2 * 3 * row + 1] / 60;
        EXPECT_NEAR(velocity, pressure / (density * wave_speed), 0.005 * pressure / (density * wave_speed))
            << load;
        EXPECT_LT(run.unexplained_energy(), 1e-12);
    }
}

TEST(EdgeLoads, SwellAThickCylinderAsLameSays) {
    // Inner pressure grows slowly (many radial periods of 10 us) on a ring held between plates: plane strain.
    constexpr double inner = 5, outer = 10, pressure = 0.1, nu = 0.3;
    for (const std::string element :
         {"one-point quad", "mean-dilatation quad", "triangle", "averaged triangle"}) {
        RecordedRun run(scene_of(
            scene_head("axisymmetric", 0.2, nu) +
            box_body("ring", {inner, 0, outer, 0.5}, {20, 2}, fmt::format("element = \"{}\"", element),
                     "[[body.constraint]]\nfixed = [\"axial\"]\n"
                     "[[body.load]]\nedge = \"left\"\npressure = [[0, 0], [0.2, 0.1]]")));
        run.to_end();
        const double k = pressure * inner * inner / (outer * outer - inner * inner);
        const auto displacement = [&](double r) {
            return (1 + nu) / young * k * ((1 - 2 * nu) * r + outer * outer / r);
        };
        const auto snapshot = run.solver.snapshot();
        const auto& mesh = snapshot->setup->mesh;
        for (std::size_t node = 0; node < mesh.nodes.size(); ++node) {
            const double r = mesh.nodes[node].x();
            // Finite strain 1e-3, 20 elements: (h/r)^2; residual swing of the ramp 10/200/6.
            EXPECT_NEAR(snapshot->position[2 * node] - r, displacement(r), 0.01 * displacement(r))
                << element << " r " << r;
        }
        for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell) {
            double r = 0;
            for (int i = 0; i < corner_count(mesh.cells[cell]); ++i)
                r += mesh.nodes[static_cast<std::size_t>(mesh.cells[cell][static_cast<std::size_t>(i)])].x() /
                     corner_count(mesh.cells[cell]);
            // One stress for a cell of width h: the exact one changes by its gradient 2 k b^2 / r^3 within
            // half of h.
            const double tolerance = 0.125 * 2 * k * outer * outer / (r * r * r) + 0.01 * pressure;
            EXPECT_NEAR(snapshot->stress[cell][0], k * (1 - outer * outer / (r * r)), tolerance)
                << element << " r " << r;
            EXPECT_NEAR(snapshot->stress[cell][2], k * (1 + outer * outer / (r * r)), tolerance)
                << element << " r " << r;
        }
    }
}

}  // namespace
}  // namespace percuss::testing
