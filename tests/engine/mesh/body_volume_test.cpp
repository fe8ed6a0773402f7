#include "mesh/body_volume.hpp"

#include <numbers>

#include <gtest/gtest.h>

namespace percuss {
namespace {

using std::numbers::pi;

Mesh one_cell(std::vector<Vec2> nodes, const Cell& cell) {
    Mesh mesh;
    mesh.nodes = std::move(nodes);
    mesh.cells = {cell};
    mesh.bodies.resize(1);
    mesh.bodies[0].cell_end = 1;
    return mesh;
}

TEST(BodyVolume, OfAHollowCylinderIsExact) {
    const Mesh mesh = one_cell({{1, 0}, {3, 0}, {3, 5}, {1, 5}}, {0, 1, 2, 3});
    EXPECT_NEAR(body_volume(mesh, mesh.bodies[0], Geometry::axisymmetric, 1), pi * (9 - 1) * 5, 1e-12);
}

TEST(BodyVolume, OfAConeIsExact) {
    const Mesh mesh = one_cell({{0, 0}, {2, 0}, {0, 3}}, {0, 1, 2, -1});
    EXPECT_NEAR(body_volume(mesh, mesh.bodies[0], Geometry::axisymmetric, 1), pi * 4 * 3 / 3, 1e-12);
}

TEST(BodyVolume, OfAPlaneBodyIsAreaTimesThickness) {
    const Mesh mesh = one_cell({{-1, 0}, {1, 0}, {2, 2}, {-2, 2}}, {0, 1, 2, 3});
    EXPECT_NEAR(body_volume(mesh, mesh.bodies[0], Geometry::plane_strain, 0.5), 3, 1e-12);
    EXPECT_NEAR(body_volume(mesh, mesh.bodies[0], Geometry::plane_stress, 2), 12, 1e-12);
}

}  // namespace
}  // namespace percuss
