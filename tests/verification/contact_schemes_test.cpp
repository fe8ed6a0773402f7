// Identities of the contact schemes that need no roles: what any of them has to keep, whatever the meshes.
#include <algorithm>
#include <cmath>

#include "verification/schemes.hpp"

namespace percuss::testing {
namespace {

class RolelessScheme : public ::testing::TestWithParam<SchemeChoice> {};

constexpr double pressure = 0.1, width = 12, height = 6;

/// Two blocks pressed on each other from above and below, turned by an angle. Viscosity lets the swing of the
/// ramp die away, from 1e-3 of the pressure at its end to a tenth of that.
Scene pressed(const SchemeChoice& scheme, int lower, int upper, double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    const auto corner = [&](double x, double y) {
        return fmt::format("[{:.17g}, {:.17g}]", c * x - s * y, s * x + c * y);
    };
    const auto block = [&](const std::string& name, double bottom, double top, int columns,
                           const char* loaded) {
        return fmt::format(
            "[[body]]\nname = \"{}\"\nmaterial = \"steel\"\n[[body.block]]\ncorners = [{}, {}, {}, "
            "{}]\ndivisions = "
            "[{}, 6]\n[[body.load]]\nedge = \"{}\"\npressure = [[0, 0], [0.2, {}]]\n",
            name, corner(0, bottom), corner(width, bottom), corner(width, top), corner(0, top), columns,
            loaded, pressure);
    };
    return scene_of(
        scene_head("plane strain", 1.2, 0.3, "courant = 0.9", "viscosity = { linear = 1.0, quadratic = 0 }") +
        block("lower", 0, height, lower, "bottom") + block("upper", height, 2 * height, upper, "top") +
        bodies_pair("face", "upper", "lower", scheme));
}

/// Worst deviation of the normal stress in the two rows of elements at the interface, relative to the
/// pressure.
double interface_error(const Scene& scene, int lower, int upper, double angle) {
    RecordedRun run(scene);
    run.to_end();
    const auto snapshot = run.solver.snapshot();
    const auto& bodies = snapshot->setup->mesh.bodies;
    const double nx = -std::sin(angle), ny = std::cos(angle);
    double worst = 0;
    const auto look = [&](std::int32_t first, int columns) {
        for (int k = 0; k < columns; ++k) {
            const StressMean& s = snapshot->stress[static_cast<std::size_t>(first + k)];
            const double normal = s[0] * nx * nx + s[1] * ny * ny + 2 * s[3] * nx * ny;
            worst = std::max(worst, std::abs(normal / pressure + 1));
        }
    };
    look(bodies[0].cell_end - lower, lower);
    look(bodies[1].cell_begin, upper);
    return worst;
}

TEST_P(RolelessScheme, PassesUniformPressureThroughFacesThatDoNotMatch) {
    for (const double angle : {0.0, 0.3}) {
        for (const auto& [lower, upper] : {std::pair{5, 7}, {7, 5}, {5, 13}}) {
            const double error =
                interface_error(pressed(GetParam(), lower, upper, angle), lower, upper, angle);
            RecordProperty(fmt::format("{}_on_{}_at_{}", upper, lower, angle), fmt::format("{:.2g}", error));
            EXPECT_LT(error, 5e-4) << upper << " on " << lower << " at " << angle;
        }
    }
}

/// A block flies obliquely on to another; corners and edges meet flat sides on the way.
Scene oblique(const SchemeChoice& scheme, bool turned = false) {
    return scene_of(scene_head("plane strain", 0.02, 0.3) +
                    box_body("flyer", {1, 10.003, 7, 16}, {5, 6}, "velocity = [15, -30]") +
                    box_body("target", {0, 0, 12, 10}, {7, 8}) +
                    (turned ? bodies_pair("hit", "target", "flyer", scheme)
                            : bodies_pair("hit", "flyer", "target", scheme)));
}

TEST_P(RolelessScheme, KeepsMomentaAndExplainsItsEnergy) {
    RecordedRun run(oblique(GetParam()));
    run.to_end();
    const RunStatistics s = run.solver.statistics();
    EXPECT_GT(s.pairs[0].impulse[1], 0.01);
    EXPECT_LT(momentum_error(s), 1e-12);
    EXPECT_LT(run.unexplained_energy(), 1e-9 * s.initial_energy);
    EXPECT_LT(s.maximum_growth, GetParam().growth);
    EXPECT_EQ(s.contact_solver.fallbacks, 0);
    // Forces act along the normal at x_n and count at x_(n+1): impulse times the slip of a step, see
    // momentum_test.
    EXPECT_LT(std::abs(s.angular_momentum_final - s.angular_momentum_initial),
              1e-3 * std::abs(s.angular_momentum_initial));
}

TEST_P(RolelessScheme, DoesNotDependOnWhichBodyIsNamedFirst) {
    RecordedRun one(oblique(GetParam())), other(oblique(GetParam(), true));
    one.to_end();
    other.to_end();
    const auto push = one.column("contact.hit.y"), back = other.column("contact.hit.y");
    ASSERT_EQ(push.size(), back.size());
    const double peak = *std::max_element(push.begin(), push.end());
    ASSERT_GT(peak, 0);
    for (std::size_t n = 0; n < push.size(); ++n) ASSERT_NEAR(push[n], -back[n], 1e-6 * peak) << n;
    for (std::size_t n = 0; n < one.solver.nodes().size(); ++n)
        for (int d = 0; d < 2; ++d)
            ASSERT_NEAR(one.solver.nodes()[n].x[d], other.solver.nodes()[n].x[d], 1e-9) << "mm";
}

/// A block that begins a little inside another, or just touches it; above rest or thrown at it.
Scene overlapping(const SchemeChoice& scheme, double overlap, double speed) {
    return scene_of(scene_head("plane strain", 0.01, 0.3) +
                    box_body("upper", {1, 4 - overlap, 6, 8 - overlap}, {7, 5},
                             fmt::format("velocity = [0, {}]", -speed)) +
                    box_body("lower", {0, 0, 8, 4}, {9, 5}) + bodies_pair("hit", "upper", "lower", scheme));
}

TEST_P(RolelessScheme, LeavesAnOverlapAtTheStartWhereItIs) {
    RecordedRun resting(overlapping(GetParam(), 0.01, 0));
    resting.to_end();
    // Rounding of positions, 1e-15 mm, over a step of 1e-4 ms.
    for (const Node& node : resting.solver.nodes()) ASSERT_LT(std::hypot(node.v[0], node.v[1]), 1e-9);
}

TEST_P(RolelessScheme, TakesAnOverlapAtTheStartAsTouching) {
    // Parts and comes back several times: the gap must not close up behind what moves out.
    RecordedRun overlap(overlapping(GetParam(), 0.01, 10)), touching(overlapping(GetParam(), 0, 10));
    overlap.to_end();
    touching.to_end();
    const RunStatistics a = overlap.solver.statistics(), b = touching.solver.statistics();
    ASSERT_GT(b.pairs[0].impulse[1], 0.9 * 5 * 4 * density * 10) << "it stops and comes back";
    // The meshes differ by nothing but where one stands; faces slide on each other by some 1e-3 mm of 0.7.
    EXPECT_NEAR(a.pairs[0].impulse[1], b.pairs[0].impulse[1], 2e-3 * b.pairs[0].impulse[1]);
    EXPECT_NEAR(a.maximum_loss, b.maximum_loss, 0.05 * b.maximum_loss);
    EXPECT_LT(a.maximum_growth, 1.2 * b.maximum_growth) << "no kick";
    EXPECT_LT(b.maximum_growth, GetParam().growth) << "motion of second order within a step, taken back";
    EXPECT_LT(a.pairs[0].max_penetration, b.pairs[0].max_penetration + 1e-4)
        << "mm; beyond what it began with";
}

TEST_P(RolelessScheme, LosesOnAWallWhatTheFaceNodesHad) {
    RecordedRun run(scene_of(scene_head("plane stress", 0.06, 0) +
                             box_body("bar", {0, 0, 2, 100}, {1, 20}, "velocity = [0, -10]") +
                             "[[wall]]\nname = \"floor\"\npoint = [0, 0]\nnormal = [0, 1]\n" +
                             bodies_pair("hit", "bar", "floor", GetParam())));
    run.to_end();
    const RunStatistics s = run.solver.statistics();
    EXPECT_NEAR(s.maximum_loss, 0.5 / 20, 1e-3 * 0.5 / 20) << "half an element of twenty";
    EXPECT_EQ(s.pairs[0].events, 2);
    EXPECT_LT(momentum_error(s), 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Schemes, RolelessScheme,
                         ::testing::Values(SchemeChoice{"symmetric", "symmetric"},
                                           SchemeChoice{"segment_to_segment", "segment-to-segment"},
                                           SchemeChoice{"symmetric_velocity", "symmetric",
                                                        "level = \"velocity\"\n", joint_problem, 6e-5},
                                           SchemeChoice{"segment_velocity", "segment-to-segment",
                                                        "level = \"velocity\"\n", joint_problem}),
                         [](const auto& scheme) { return std::string(scheme.param.name); });

}  // namespace
}  // namespace percuss::testing
