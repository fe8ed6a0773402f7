// Fully plastic bending: plastic flow keeps the volume, and elements must let it.
#include <cmath>

#include <gtest/gtest.h>

#include "elements/kernels.hpp"
#include "engine/materials/one_element.hpp"

namespace percuss::testing {
namespace {

constexpr double yield = 0.02;

/// Power of the internal forces of a beam, cells x cells on [-2, 2] x [-1, 1], bent to a curvature by the
/// volume-keeping field u = k x y, v = -k (x^2 + y^2) / 2, over the limit power of perfect plasticity,
/// 2/sqrt(3) yield k' times the integral of |y|.
double power_over_limit(ElementKind kind, int cells = 4) {
    Scene scene;
    scene.geometry = Geometry::plane_strain;
    scene.materials.push_back({"m", 8, 200, 0.3, {}, {}, VoceHardening{yield, 0, 0, 0}});
    Body body;
    body.material = "m";
    body.element = kind;
    body.hourglass = 0;  // its stiffness knows no yield
    scene.bodies.push_back(body);
    Mesh mesh;
    const int row = cells + 1;  // nodes
    for (int j = 0; j <= cells; ++j)
        for (int i = 0; i <= cells; ++i) mesh.nodes.emplace_back(-2 + 4.0 * i / cells, -1 + 2.0 * j / cells);
    for (int j = 0; j < cells; ++j)
        for (int i = 0; i < cells; ++i) {
            const int n = row * j + i;
            if (is_triangle(kind)) {
                mesh.cells.push_back({n, n + 1, n + row + 1, -1});
                mesh.cells.push_back({n, n + row + 1, n + row, -1});
            } else {
                mesh.cells.push_back({n, n + 1, n + row + 1, n + row});
            }
        }
    MeshBody part;
    part.kind = kind;
    part.node_end = mesh.node_count();
    part.cell_end = mesh.cell_count();
    mesh.bodies.push_back(part);
    Batch batch =
        make_batch(scene, mesh, 0, std::vector<std::array<bool, 2>>(mesh.nodes.size(), {false, false}));
    AlignedVector<Node> nodes;
    for (const Vec2& x : mesh.nodes) nodes.push_back({{x.x(), x.y()}, {0, 0}});
    KernelSums sums;
    constexpr int steps = 100;
    constexpr double curvature = 0.005;  // outer strain 50 times that at yield
    for (int step = 1; step <= steps; ++step) {
        for (std::size_t n = 0; n < nodes.size(); ++n) {
            const Vec2& x = mesh.nodes[n];
            const double k = curvature / steps;
            nodes[n].v[0] = k * x.x() * x.y();
            nodes[n].v[1] = -0.5 * k * x.squaredNorm();
            for (int d = 0; d < 2; ++d) nodes[n].x[d] += nodes[n].v[d];
        }
        average_volumes(batch, nodes.data());
        batch.kernel.forces(batch, nodes.data(), 1, 0, batch.blocks(), sums);
    }
    double power = 0;
    for (int element = 0; element < batch.count; ++element)
        for (int corner = 0; corner < batch.corners; ++corner) {
            const auto at = static_cast<std::size_t>(
                ((element / block_lanes) * batch.corners + corner) * block_lanes + element % block_lanes);
            const Node& node = nodes[static_cast<std::size_t>(batch.nodes[at])];
            power += batch.force[2 * at] * node.v[0] + batch.force[2 * at + 1] * node.v[1];
        }
    return power / (2 / std::sqrt(3.0) * yield * curvature / steps * 4);
}

TEST(PlasticLocking, QuadsBendAtTheirLimitLoad) {
    // One-point quads see the curvature at their centres only, where the field is exact. At the 2 x 2 points
    // the bilinear cell adds a parasitic shear k (x - x_c) and keeps v_y at -k y_c: summing sqrt(2/3 e:e)
    // over the points of cells of 1 x 0.5 at y_c = 0.25 and 0.75 gives 1.059 of the limit, an error that
    // falls with the cell, unlike locking.
    for (const auto& [kind, discrete] :
         {std::pair{ElementKind::quad_one_point, 1.0}, std::pair{ElementKind::quad_mean_dilatation, 1.059}}) {
        const double ratio = power_over_limit(kind);
        RecordProperty(name_of(kind), std::to_string(ratio));
        EXPECT_NEAR(ratio, discrete, 0.03)
            << name_of(kind);  // elastic cores: outer strain is 50 times that at yield
    }
}

TEST(PlasticLocking, AveragedTrianglesBendNearTheirLimitLoadWhereTrianglesAloneLock) {
    // A small-strain program of its own gives, over the limit: with 8 x 8 cells constant strain 1.053 by flow
    // and 1.128 by compression, the locking; averaged volumes 1.053 and 0.033. With 4 x 4: 1.167 + 4.511
    // and 1.167 + 0.282. What is left by averaging comes from the surface and falls as the third power of the
    // cell.
    const double averaged = power_over_limit(ElementKind::triangle_averaged, 8),
                 alone = power_over_limit(ElementKind::triangle, 8);
    RecordProperty("averaged", std::to_string(averaged));
    RecordProperty("alone", std::to_string(alone));
    EXPECT_NEAR(averaged, 1.086, 0.03);
    EXPECT_NEAR(alone, 2.18, 0.1);
    EXPECT_GT(power_over_limit(ElementKind::triangle), 5);
    EXPECT_LT(power_over_limit(ElementKind::triangle_averaged), 1.6);
}

}  // namespace
}  // namespace percuss::testing
