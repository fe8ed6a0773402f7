// The copper Taylor bar: 32.4 mm long, 3.2 mm radius, 227 m/s, yield 400 + 100 ep MPa, to rest at 80 us.
#include <algorithm>

#include "verification/run.hpp"

namespace percuss::testing {
namespace {

struct Shape {
    double radius, length;  // mm
};

Shape shape_of(const Solver& solver) {
    Shape shape{0, 0};
    double low = 1e9, high = -1e9;
    const MeshBody& bar = solver.setup()->mesh.bodies[0];
    for (auto n = static_cast<std::size_t>(bar.node_begin); n < static_cast<std::size_t>(bar.node_end); ++n) {
        const double* x = solver.nodes()[n].x;
        shape.radius = std::max(shape.radius, x[0]);
        low = std::min(low, x[1]);
        high = std::max(high, x[1]);
    }
    shape.length = high - low;
    return shape;
}

/// The scene's bar with its face held axially, as the published computations have it, instead of a wall that
/// lets go.
Scene held_bar(int columns, const std::string& element) {
    std::string text = load_scene(PERCUSS_SOURCE_DIR "/scenes/taylor.toml").text;
    const auto cut = [&](const std::string& from, const std::string& to, const std::string& put) {
        const auto begin = text.find(from);
        text.replace(begin, text.find(to) - begin, put);
    };
    cut("[[wall]]", "[record]", "[[body.constraint]]\nedge = \"bottom\"\nfixed = [\"axial\"]\n\n");
    return scene_of(text, {fmt::format("body.bar.block.0.divisions=[{},{}]", columns, columns * 15 / 2),
                           "body.bar.element=\"" + element + "\""});
}

TEST(TaylorBar, HeldFaceConvergesToThePublishedShape) {
    std::vector<double> radii;
    for (const int columns : {6, 8, 10}) {
        RecordedRun run(held_bar(columns, "mean-dilatation quad"));
        run.to_end();
        const Shape shape = shape_of(run.solver);
        RecordProperty("radius with " + std::to_string(columns), std::to_string(shape.radius));
        RecordProperty("length with " + std::to_string(columns), std::to_string(shape.length));
        EXPECT_NEAR(shape.radius, 7.22, 0.1) << columns;
        EXPECT_NEAR(shape.length, 21.4, 0.3) << columns;
        radii.push_back(shape.radius);
        const RunStatistics statistics = run.solver.statistics();
        EXPECT_LT(statistics.elastic_energy_error, 2e-4);
        EXPECT_LT(statistics.maximum_growth, 1e-9);
        EXPECT_GT(statistics.bodies[0].plastic, 0.95 * statistics.initial_energy);
    }
    EXPECT_LT(std::abs(radii[2] - radii[1]), 0.03);
}

TEST(TaylorBar, AveragedTrianglesConvergeToTheShapeOfQuads) {
    // Radii of 4, 6, 8, 10, 12 cells miss their limit of 7.24 by 0.95 mm over the cells; crossed cells are
    // within 0.07 mm from 4 on. Triangles alone lock: 5.5, 5.8, 6.0, 6.2. The 0.95 is read off these runs and
    // guards against change; the answer itself is tested below, with 8 cells and without the error of first
    // order.
    double radius[2];
    for (const int columns : {6, 8}) {
        RecordedRun run(held_bar(columns, "averaged triangle"));
        run.to_end();
        const Shape shape = shape_of(run.solver);
        RecordProperty("radius with " + std::to_string(columns), std::to_string(shape.radius));
        RecordProperty("length with " + std::to_string(columns), std::to_string(shape.length));
        EXPECT_NEAR(shape.radius, 7.22 - 0.95 / columns, 0.05);
        EXPECT_NEAR(shape.length, 21.4, 0.3);
        const RunStatistics statistics = run.solver.statistics();
        EXPECT_LT(statistics.elastic_energy_error, 1e-4);
        EXPECT_LT(statistics.maximum_growth, 1e-9);
        EXPECT_GT(statistics.bodies[0].plastic, 0.95 * statistics.initial_energy);
        radius[columns == 8] = shape.radius;
    }
    EXPECT_NEAR(radius[1], 7.22, 0.1);
    EXPECT_NEAR((8 * radius[1] - 6 * radius[0]) / 2, 7.22, 0.05);  // without the error of first order

    Scene crossed = held_bar(4, "averaged triangle");
    crossed.bodies[0].pattern = CellPattern::crossed;
    RecordedRun run(crossed);
    run.to_end();
    EXPECT_NEAR(shape_of(run.solver).radius, 7.22, 0.1);
    EXPECT_NEAR(shape_of(run.solver).length, 21.4, 0.3);
}

TEST(TaylorBar, HeatsByNineTenthsOfItsPlasticWork) {
    Scene scene = held_bar(4, "one-point quad");
    JohnsonCook copper{0.09, 0.292, 0.31, 0.025, 1e-3, 1.09, 298, 1356, 298, 383, 0.9};
    scene.materials[0].plasticity = copper;
    RecordedRun run(scene);
    run.to_end();
    const auto snapshot = run.solver.snapshot();
    const Mesh& mesh = run.solver.setup()->mesh;
    double heat = 0;
    for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell) {
        const auto share =
            corner_masses(mesh.cells[cell], mesh.nodes, scene.materials[0].density, Geometry::axisymmetric);
        heat += run.solver.scale() * (share[0] + share[1] + share[2] + share[3]) * *copper.heat_capacity *
                (snapshot->temperature[cell] - copper.initial_temperature);
    }
    const double plastic_work = run.solver.statistics().bodies[0].plastic;
    EXPECT_NEAR(heat, 0.9 * plastic_work, 1e-9 * heat);
    EXPECT_GT(plastic_work, 200);
}

}  // namespace
}  // namespace percuss::testing
