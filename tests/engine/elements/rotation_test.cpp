// Objectivity: a rigid turn makes no stress and turns the stress that is there.
#include <numbers>

#include <gtest/gtest.h>

#include "engine/elements/element_mesh.hpp"

namespace percuss::testing {
namespace {

constexpr int turn = 300;  // steps: 1.2 degrees each

/// One exact rigid step about a point outside the body.
void rotate_once(ElementMesh& m, double angle) {
    const Eigen::Rotation2Dd rotation(angle);
    const Vec2 centre(-2, 5);
    m.move(m.displacement([&](const Vec2& x) { return Vec2(rotation * (x - centre) - (x - centre)); }));
}

ElementMesh plane_mesh(ElementKind kind, Geometry geometry) {
    ElementMesh::Options o;
    o.kind = kind;
    o.geometry = geometry;
    o.distortion = 0.25;
    return ElementMesh(o);
}

TEST(RigidRotation, GivesNoStressInAnyElement) {
    for (const ElementKind kind : all_kinds) {
        for (const Geometry geometry : {Geometry::plane_strain, Geometry::plane_stress}) {
            ElementMesh m = plane_mesh(kind, geometry);
            double worst = 0;
            for (int step = 0; step < turn; ++step) {
                rotate_once(m, 2 * std::numbers::pi / turn);
                for (std::int32_t element = 0; element < m.batch.count; ++element)
                    for (const double s : m.stress(element)) worst = std::max(worst, std::abs(s));
                worst = std::max(worst, m.internal_force().cwiseAbs().maxCoeff());
            }
            // Rounding: 1e-16 * distance 7 / cell 1 a step, adding up like a walk.
            EXPECT_LT(worst, 1e-12 * 200) << name_of(kind) << ", " << name_of(geometry);
        }
    }
}

TEST(RigidRotation, TurnsAPrestressWithTheBody) {
    for (const ElementKind kind : all_kinds) {
        for (const Geometry geometry : {Geometry::plane_strain, Geometry::plane_stress}) {
            ElementMesh m = plane_mesh(kind, geometry);
            const Eigen::VectorXd before = m.move(m.displacement([](const Vec2& x) {
                return Vec2(0.02 * x.x() + 0.03 * x.y() + 0.01 * x.x() * x.y(),
                            -0.05 * x.y() + 0.02 * x.x() * x.x());
            }));
            std::vector<std::array<double, 4>> first;
            for (std::int32_t element = 0; element < m.batch.count; ++element)
                first.push_back(m.stress(element));
            const double size = before.cwiseAbs().maxCoeff();
            for (int step = 1; step <= turn; ++step) {
                rotate_once(m, 2 * std::numbers::pi / turn);
                const Eigen::Matrix2d r =
                    Eigen::Rotation2Dd(2 * std::numbers::pi * step / turn).toRotationMatrix();
                const Eigen::VectorXd force = m.internal_force();
                for (Eigen::Index n = 0; n < m.mesh.node_count(); ++n)
                    ASSERT_LT((force.segment<2>(2 * n) - r * before.segment<2>(2 * n)).norm(), 1e-11 * size)
                        << name_of(kind) << " step " << step;
                if (step % 50 != 0) continue;
                for (std::int32_t element = 0; element < m.batch.count; ++element) {
                    const auto& s = first[static_cast<std::size_t>(element)];
                    Eigen::Matrix2d tensor;
                    tensor << s[0], s[3], s[3], s[1];
                    const Eigen::Matrix2d expected = r * tensor * r.transpose();
                    const auto now = m.stress(element);
                    EXPECT_NEAR(now[0], expected(0, 0), 1e-11 * 200);
                    EXPECT_NEAR(now[1], expected(1, 1), 1e-11 * 200);
                    EXPECT_NEAR(now[2], s[2], 1e-11 * 200);
                    EXPECT_NEAR(now[3], expected(0, 1), 1e-11 * 200);
                }
            }
        }
    }
}

}  // namespace
}  // namespace percuss::testing
