// Elastic waves: speed, reflection at a free end.
#include <cmath>
#include <numbers>

#include "verification/run.hpp"

namespace percuss::testing {
namespace {

constexpr double length = 100;
constexpr int elements = 50;

/// Circular frequency of the first standing wave cos(pi y / L), set going with 0.1 m/s and measured by its
/// zero crossings.
double first_frequency(const std::string& geometry, double poisson, const std::string& tables,
                       double first = 0) {
    RecordedRun run(scene_of(scene_head(geometry, 0.2, poisson, "courant = 0.5") +
                             box_body("bar", {first, 0, first + 1, length}, {1, elements}, "", tables)));
    SolverState state = run.solver.save();
    std::vector<double> shape;
    for (Node& node : state.nodes) {
        shape.push_back(std::cos(std::numbers::pi * node.x[1] / length));
        node.v[1] = 0.1 * shape.back();
    }
    state.ledger.initial_kinetic = state.ledger.lowest = 1;
    run.solver.restore(state);
    double before = 0, first_crossing = 0, last_crossing = 0;
    int crossings = 0;
    while (!run.solver.finished()) {
        run.step();
        double amplitude = 0;
        for (std::size_t n = 0; n < shape.size(); ++n)
            amplitude += run.solver.lumped_mass()[n] * shape[n] * run.solver.nodes()[n].v[1];
        if (before * amplitude < 0) {
            const double dt = run.history.values("step.dt").back();
            last_crossing = run.solver.time() - dt * amplitude / (amplitude - before);
            if (crossings++ == 0) first_crossing = last_crossing;
        }
        before = amplitude;
    }
    return std::numbers::pi * (crossings - 1) / (last_crossing - first_crossing);
}

/// omega = 2/h c sin(k h/2) of a chain of masses; the leapfrog's own correction is smaller by the square of
/// courant.
double chain_frequency(double modulus) {
    const double h = length / elements;
    return 2 / h * std::sqrt(modulus / density) * std::sin(std::numbers::pi / elements / 2);
}

// Half of the leapfrog's (omega dt)^2 / 24, strain of 1e-5, interpolation of crossings.
constexpr double tolerance = 2e-4;

TEST(Wave, SpeedInABarIsTheRootOfYoungOverDensity) {
    const double exact = chain_frequency(young);
    EXPECT_NEAR(first_frequency("axisymmetric", 0, ""), exact, tolerance * exact);
    EXPECT_NEAR(first_frequency("plane strain", 0, ""), exact, tolerance * exact);
    // The lateral motion of a slender bar costs (nu k)^2 width^2 / 24 more (Rayleigh, Love): 4e-6.
    EXPECT_NEAR(first_frequency("plane stress", 0.3, ""), exact, tolerance * exact);
}

TEST(Wave, SpeedBetweenRigidSidesIsDilatational) {
    const double nu = 0.3, modulus = young * (1 - nu) / ((1 + nu) * (1 - 2 * nu)),
                 exact = chain_frequency(modulus);
    const std::string tables = "[[body.constraint]]\nfixed = [\"x\"]";
    EXPECT_NEAR(first_frequency("plane strain", nu, tables), exact, tolerance * exact);
    EXPECT_NEAR(first_frequency("axisymmetric", nu, "[[body.constraint]]\nfixed = [\"radial\"]", 5), exact,
                tolerance * exact);
}

TEST(Wave, SpeedInAPlateUsesThePlateModulus) {
    const double nu = 0.3, exact = chain_frequency(young / (1 - nu * nu));
    EXPECT_NEAR(first_frequency("plane strain", nu, ""), exact, tolerance * exact);
}

TEST(Wave, FreeEndReturnsCompressionAsTension) {
    // A raised cosine of pressure, 40 elements long: carried nearly undispersed.
    const double c = std::sqrt(young / density), duration = 40 / c;
    std::string points;
    for (int k = 0; k <= 32; ++k)
        points += fmt::format("[{:.17g}, {:.17g}], ", duration * k / 32,
                              0.05 * (1 - std::cos(2 * std::numbers::pi * k / 32)));
    const std::string load = fmt::format("[[body.load]]\nedge = \"bottom\"\npressure = [{}]", points);
    RecordedRun run(scene_of(
        scene_head("plane stress", 190 / c, 0) + box_body("bar", {0, 0, 2, 100}, {2, 100}, "", load) +
        "[[probe]]\nname = \"p\"\nbody = \"bar\"\nat = [1, 60.5]\nrecord = [\"stress.y\"]\n"));
    run.to_end();
    const auto time = run.column("time"), stress = run.column("probe.p.stress.y"), dt = run.column("step.dt");
    double compression = 0, tension = 0, lowest = 0, highest = 0;
    for (std::size_t n = 0; n < time.size(); ++n) {
        (time[n] * c < 120 ? compression : tension) += dt[n] * stress[n];
        lowest = std::min(lowest, stress[n]);
        highest = std::max(highest, stress[n]);
    }
    const double impulse = 0.05 * duration;  // pressure over time
    EXPECT_NEAR(compression, -impulse, 1e-3 * impulse);
    EXPECT_NEAR(tension, impulse, 1e-3 * impulse);
    EXPECT_NEAR(lowest, -0.1, 0.001);
    EXPECT_NEAR(highest, 0.1, 0.001);
}

}  // namespace
}  // namespace percuss::testing
