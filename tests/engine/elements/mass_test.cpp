#include <gtest/gtest.h>

#include "engine/elements/element_mesh.hpp"

namespace percuss::testing {
namespace {

/// Volume of a polygon per radian or unit thickness by Green's theorem: the closed boundary integral of r^2/2
/// dz or x dy, exact for straight sides, and independent of shape functions.
double polygon_volume(const std::vector<Vec2>& x, Geometry geometry) {
    double sum = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const Vec2 &a = x[i], &b = x[(i + 1) % x.size()];
        const double dy = b.y() - a.y();
        sum += geometry == Geometry::axisymmetric ? dy * (a.x() * a.x() + a.x() * b.x() + b.x() * b.x()) / 6
                                                  : dy * (a.x() + b.x()) / 2;
    }
    return sum;
}

TEST(LumpedMass, OfDistortedMeshesIsTheExactMass) {
    for (const ElementKind kind : all_kinds) {
        for (const Geometry geometry : all_geometries) {
            ElementMesh::Options o;
            o.kind = kind;
            o.geometry = geometry;
            o.distortion = 0.3;
            o.distort_boundary = true;
            o.box = {0, -1, 3, 2};
            const ElementMesh m(o);
            double mass = 0, exact = 0;
            for (const double share : m.mass) mass += share;
            for (const Cell& cell : m.mesh.cells) {
                std::vector<Vec2> corners;
                for (int i = 0; i < corner_count(cell); ++i)
                    corners.push_back(
                        m.mesh.nodes[static_cast<std::size_t>(cell[static_cast<std::size_t>(i)])]);
                exact += o.density * polygon_volume(corners, geometry);
            }
            EXPECT_NEAR(mass, exact, 1e-14 * exact) << name_of(kind) << ", " << name_of(geometry);
            for (const double share : m.mass) EXPECT_GT(share, 0);
        }
    }
}

TEST(LumpedMass, OfARingSharesByShapeFunctions) {
    // A unit square ring from r = 0: integrals of r (1 - r) and r * r over r, halved over z.
    const std::vector<Vec2> x{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    const auto mass = corner_masses({0, 1, 2, 3}, x, 12, Geometry::axisymmetric);
    for (const std::size_t axis : {0u, 3u}) EXPECT_NEAR(mass[axis], 1, 1e-14);
    for (const std::size_t rim : {1u, 2u}) EXPECT_NEAR(mass[rim], 2, 1e-14);
}

TEST(LumpedMass, OfATriangleRingSharesByShapeFunctions) {
    // Integral of N_I r over the triangle (0,0) (1,0) (0,1): area / 12 * (sum of r + r_I) = (1, 2, 1) / 24.
    const std::vector<Vec2> x{{0, 0}, {1, 0}, {0, 1}};
    const auto mass = corner_masses({0, 1, 2, -1}, x, 24, Geometry::axisymmetric);
    EXPECT_NEAR(mass[0], 1, 1e-14);
    EXPECT_NEAR(mass[1], 2, 1e-14);
    EXPECT_NEAR(mass[2], 1, 1e-14);
    EXPECT_EQ(mass[3], 0);
}

}  // namespace
}  // namespace percuss::testing
