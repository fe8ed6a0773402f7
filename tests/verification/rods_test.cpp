// The paper's first example against one-dimensional theory (scenes/rods.toml).
#include <cmath>
#include <numbers>

#include "verification/run.hpp"

namespace percuss::testing {
namespace {

const double wave_speed = std::sqrt(young / density);
constexpr double element = 2, striker_length = 100, speed = 10;
const double plateau = density * wave_speed * 100 * std::numbers::pi * speed / 2;
const double element_transit = element / wave_speed;  // critical step of the one-dimensional chain

struct Errors {
    double averaged, unaveraged, first_sample;
};

Errors errors_of(const RecordedRun& run) {
    const double pulse = 2 * striker_length / wave_speed;
    const TimePoints exact{{0, 0}, {0, plateau}, {pulse, plateau}, {pulse, 0}};
    const auto time = run.column("time"), force = run.column("contact.impact.axial");
    return {force_error(time, force, exact, 0.8e-3, 60e-3), force_error(time, force, exact, 0, 60e-3),
            first_sample(force, exact)};
}

TEST(Rods, AtNineTenthsOfCriticalFollowTheSquarePulse) {
    RecordedRun run(rods());
    run.to_end();
    const Errors errors = errors_of(run);
    const RunStatistics s = run.solver.statistics();
    RecordProperty("averaged", std::to_string(errors.averaged));
    RecordProperty("unaveraged", std::to_string(errors.unaveraged));
    // Dispersion of the mesh; the one-dimensional chain itself has 3.5 % and 5.1 %.
    EXPECT_LE(errors.averaged, 0.04);
    EXPECT_LE(errors.unaveraged, 0.055);
    EXPECT_EQ(s.pairs[0].events, 2);
    // h h / (2 (h + h) L) = 0.005 of the energy goes with the plastic stop of the face nodes, once.
    EXPECT_NEAR(s.maximum_loss, 0.0050, 0.0003);
    EXPECT_LT(s.maximum_growth, 1e-13);
    EXPECT_LT(s.elastic_energy_error, 1e-4);
    const auto snapshot = run.solver.snapshot();
    EXPECT_NEAR(snapshot->bodies[0].velocity[1], 0, 0.1);
    EXPECT_NEAR(snapshot->bodies[1].velocity[1], 5, 0.05);
}

TEST(Rods, ContactImpulseIsTheMomentumOfTheStriker) {
    RecordedRun run(rods());
    run.to_end();
    const auto snapshot = run.solver.snapshot();
    const double mass = density * 100 * std::numbers::pi * striker_length;
    const double impulse = run.solver.statistics().pairs[0].impulse[1];
    EXPECT_NEAR(impulse, mass * (speed - snapshot->bodies[0].velocity[1]), 1e-12 * impulse);
    EXPECT_NEAR(impulse, 2 * mass * snapshot->bodies[1].velocity[1], 1e-12 * impulse);
}

TEST(Rods, AtThePapersStepsHaveTheSpikeOfTheClosedForm) {
    for (const double nanoseconds : {200.0, 100.0, 50.0}) {
        const double dt = 1e-6 * nanoseconds;
        RecordedRun run(rods({fmt::format("model.step.fixed={:.17g}", dt)}));
        run.to_end();
        const Errors errors = errors_of(run);
        RecordProperty(fmt::format("averaged_{}ns", nanoseconds), std::to_string(errors.averaged));
        RecordProperty(fmt::format("unaveraged_{}ns", nanoseconds), std::to_string(errors.unaveraged));
        EXPECT_LE(errors.averaged, 0.062) << nanoseconds << " ns";
        // F1/F = dtc / (2 dt): the face nodes, rho A h / 2 each, stop in one step. Strains of 1e-3 change h
        // and mass by less.
        EXPECT_NEAR(errors.first_sample, element_transit / (2 * dt), 2e-3 * element_transit / (2 * dt))
            << nanoseconds << " ns";
        const RunStatistics s = run.solver.statistics();
        EXPECT_EQ(s.pairs[0].events, 2) << nanoseconds << " ns";
        EXPECT_LT(s.maximum_growth, 1e-12);
    }
}

TEST(Rods, StayOneDimensional) {
    RecordedRun run(rods());
    run.to_end();
    const auto snapshot = run.solver.snapshot();
    double most = 0;
    // The column of nodes on the axis moves as that on the rim; cells of a row agree.
    for (std::size_t row = 0; row < 100; ++row)
        for (std::size_t column = 1; column < 5; ++column)
            most = std::max(most, std::abs(snapshot->stress[250 + 5 * row + column][1] -
                                           snapshot->stress[250 + 5 * row][1]));
    // Rounding of the radial motion grows with steps; it feeds back through finite strains.
    EXPECT_LT(most, 1e-6 * plateau / 314);
}

TEST(Rods, LaggedStressesChatterAndGainEnergy) {
    const auto settings = std::vector<std::string>{"model.step.courant=0.73", "model.lagged=true"};
    RecordedRun lagged(rods(settings));
    lagged.to_end();
    const RunStatistics s = lagged.solver.statistics();
    EXPECT_GT(s.pairs[0].events, 50);
    EXPECT_GT(s.maximum_growth, 0.02);

    RecordedRun clean(rods({settings[0]}));
    clean.to_end();
    EXPECT_EQ(clean.solver.statistics().pairs[0].events, 2);
    EXPECT_LT(clean.solver.statistics().maximum_growth, 1e-12);
}

TEST(Rods, LaggedForcesFollowTheirRecursion) {
    // C_n = F(x_n) - 2 (dt/dtc)^2 C_(n-1): the face nodes, rho A h / 2 each, were moved back by dt^2 C / m,
    // and the element beside them, of stiffness E A / h, has not heard of it. F is the force of that element
    // at the corrected positions.
    for (const double courant : {0.3, 0.5, 0.6}) {
        const double dt = courant * element_transit, area = 100 * std::numbers::pi;
        RecordedRun run(rods({fmt::format("model.step.fixed={:.17g}", dt), "model.lagged=true"}));
        double expected = element_transit / (2 * dt) * plateau;
        for (int n = 0; n < 12; ++n) {
            run.step();
            const double force = run.column("contact.impact.axial").back();
            // Strains of 1e-3 change lengths, masses and moduli by as much.
            EXPECT_NEAR(force, std::max(0.0, expected), 3e-3 * plateau) << "step " << n << " at " << courant;
            const auto nodes = run.solver.nodes();
            const double last_element = nodes[6 * 50].x[1] - nodes[6 * 49].x[1];
            expected = young * area * (1 - last_element / element) - 2 * courant * courant * force;
        }
    }
}

}  // namespace
}  // namespace percuss::testing
