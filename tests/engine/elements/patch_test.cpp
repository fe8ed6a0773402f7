// Constant strain: what every element must represent exactly, however distorted the mesh.
#include <gtest/gtest.h>

#include "engine/elements/element_mesh.hpp"

namespace percuss::testing {
namespace {

/// Strains of the patch; products of them, which linear elasticity leaves out, are 1e-6 of the stress.
constexpr double small = 1e-6;
constexpr double tolerance = 10 * small;

/// Linear elasticity, written apart from the engine: (11, 22, 33, 12).
std::array<double, 4> hooke(Geometry geometry, double e, double nu, double e11, double e22, double e33,
                            double shear) {
    const double mu = e / (2 * (1 + nu));
    if (geometry == Geometry::plane_stress) {
        const double c = e / (1 - nu * nu);
        return {c * (e11 + nu * e22), c * (e22 + nu * e11), 0, mu * shear};
    }
    const double lambda = e * nu / ((1 + nu) * (1 - 2 * nu)), trace = e11 + e22 + e33;
    return {lambda * trace + 2 * mu * e11, lambda * trace + 2 * mu * e22, lambda * trace + 2 * mu * e33,
            mu * shear};
}

struct Case {
    ElementKind kind;
    Geometry geometry;
    bool axis;  // the mesh begins at r = 0
};

std::vector<Case> all_cases() {
    std::vector<Case> cases;
    for (const ElementKind kind : all_kinds)
        for (const Geometry geometry : all_geometries)
            for (const bool axis : {false, true})
                if (!axis || geometry == Geometry::axisymmetric) cases.push_back({kind, geometry, axis});
    return cases;
}

class Patch : public ::testing::TestWithParam<Case> {
  protected:
    static ElementMesh mesh(double distortion = 0.25) {
        ElementMesh::Options o;
        o.kind = GetParam().kind;
        o.geometry = GetParam().geometry;
        if (GetParam().axis) o.box = {0, 0, 3, 3};
        o.distortion = distortion;
        o.distort_boundary = true;
        return ElementMesh(o);
    }
    /// A linear field; in axisymmetric geometry one of uniform strain: u_r = a r.
    static Vec2 field(const Vec2& x) {
        if (GetParam().geometry == Geometry::axisymmetric)
            return small * Vec2(0.7 * x.x(), 0.4 * x.x() - 1.1 * x.y() + 0.3);
        return small * Vec2(0.7 * x.x() + 0.5 * x.y() - 0.2, 0.4 * x.x() - 1.1 * x.y() + 0.3);
    }
    static std::array<double, 4> exact_stress() {
        const bool ring = GetParam().geometry == Geometry::axisymmetric;
        return hooke(GetParam().geometry, 200, 0.3, 0.7 * small, -1.1 * small, ring ? 0.7 * small : 0,
                     (ring ? 0.4 : 0.9) * small);
    }
};

TEST_P(Patch, LinearDisplacementGivesTheExactUniformStress) {
    ElementMesh m = mesh();
    m.move(m.displacement(field));
    const auto exact = exact_stress();
    for (std::int32_t element = 0; element < m.batch.count; ++element)
        for (std::size_t c = 0; c < 4; ++c)
            EXPECT_NEAR(m.stress(element)[c], exact[c], tolerance * 200 * small)
                << "element " << element << " component " << c;
}

TEST_P(Patch, UniformStressLeavesInnerNodesInEquilibrium) {
    ElementMesh m = mesh();
    const auto equilibrated =
        [](const Vec2& x) {  // no shear: a uniform shear r-z is no equilibrium in a ring
            return GetParam().geometry == Geometry::axisymmetric
                       ? Vec2(small * Vec2(0.7 * x.x(), -1.1 * x.y()))
                       : field(x);
        };
    const Eigen::VectorXd f = m.move(m.displacement(equilibrated));
    // Forces of a node's elements cancel: rounding of their size, and the 1e-6 by which hoop and radial
    // stress differ.
    const double size = f.cwiseAbs().maxCoeff();
    for (const int node : {5, 6, 9, 10})
        for (int d = 0; d < 2; ++d) EXPECT_LT(std::abs(f[2 * node + d]), tolerance * size) << "node " << node;
    EXPECT_GT(size, 100 * small);
}

TEST_P(Patch, TranslationGivesNoForce) {
    ElementMesh m = mesh();
    const bool ring = GetParam().geometry == Geometry::axisymmetric;
    const Eigen::VectorXd f = m.move(m.displacement([&](const Vec2&) { return Vec2(ring ? 0 : 5, -7); }));
    // Rounding of positions, 1e-16 * 7, over a cell of 1, times the modulus.
    EXPECT_LT(f.cwiseAbs().maxCoeff(), 200 * 1e-14);
}

TEST_P(Patch, ForcesAreTheDerivativeOfTheStoredEnergy) {
    ElementMesh m = mesh();
    std::mt19937 random(3);
    std::uniform_real_distribution<double> noise(-1, 1);
    const auto random_field = [&](double size) {
        Eigen::VectorXd u(m.dofs());
        for (double& value : u) value = size * noise(random);
        if (GetParam().axis)
            for (std::size_t n = 0; n < m.held.size(); ++n)
                if (m.held[n][0]) u[static_cast<Eigen::Index>(2 * n)] = 0;
        return u;
    };
    constexpr double step = 1e-7;
    for (const double strain : {1e-5, 1e-2}) {
        m.rest();
        const Eigen::VectorXd f = m.move(random_field(strain));
        const ElementMesh stressed = m;
        for (int trial = 0; trial < 8; ++trial) {
            const Eigen::VectorXd direction = random_field(1);
            double energy[2], hourglass[2];
            for (const int side : {0, 1}) {
                m = stressed;
                m.sums = {};
                m.move((side == 0 ? -step : step) * direction);
                energy[side] = m.energy();
                hourglass[side] = m.hourglass_work();
            }
            const double derivative = (energy[1] - energy[0] + hourglass[1] - hourglass[0]) / (2 * step);
            // Differences of energies: rounding 1e-16 V E strain^2 / step, far below. Exact for one point an
            // element; four points share one volume ratio, so each one's part of the energy is off by the
            // strain's variation within the element.
            const double allowed = GetParam().kind == ElementKind::quad_mean_dilatation ? 3 * strain : 1e-6;
            const double size = f.norm() * direction.norm();
            EXPECT_NEAR(derivative, f.dot(direction), allowed * size)
                << "strain " << strain << ", trial " << trial;
            EXPECT_GT(size, 0);
        }
        m = stressed;
    }
}

TEST_P(Patch, StiffnessIsSymmetricAndHasRigidMotionsOnlyInItsKernel) {
    ElementMesh m = mesh();
    const Eigen::MatrixXd k = m.stiffness();
    EXPECT_LT((k - k.transpose()).cwiseAbs().maxCoeff(), 1e-7 * k.cwiseAbs().maxCoeff());
    const auto free = m.free_dofs();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver((0.5 * (k + k.transpose()))(free, free),
                                                                Eigen::EigenvaluesOnly);
    const double largest = solver.eigenvalues().maxCoeff();
    const auto zero = (solver.eigenvalues().array() < 1e-6 * largest).count();
    EXPECT_EQ(zero, GetParam().geometry == Geometry::axisymmetric ? 1 : 3)
        << solver.eigenvalues().transpose();
    EXPECT_GT(solver.eigenvalues().minCoeff(), -1e-7 * largest);
}

TEST(Hourglass, StiffnessDoesNotFeelLinearFields) {
    for (const Geometry geometry : all_geometries) {
        ElementMesh::Options o;
        o.geometry = geometry;
        o.distortion = 0.25;
        ElementMesh m(o);
        m.move(m.displacement(
            [](const Vec2& x) { return Vec2(0.1 * x.x() + 0.2 * x.y(), 0.15 * x.x() - 0.1 * x.y() + 3); }));
        EXPECT_GT(std::abs(m.stress(0)[1]), 1);
        for (std::int32_t element = 0; element < m.batch.count; ++element)
            for (int component = 3; component < 5; ++component)
                EXPECT_NEAR(
                    m.batch.state[static_cast<std::size_t>(
                        ((element / block_lanes) * 5 + component) * block_lanes + element % block_lanes)],
                    0, 200 * 1e-14)
                    << name_of(geometry) << " element " << element;
    }
}

INSTANTIATE_TEST_SUITE_P(Elements, Patch, ::testing::ValuesIn(all_cases()), [](const auto& case_) {
    std::string name =
        name_of(case_.param.kind) + "_" + name_of(case_.param.geometry) + (case_.param.axis ? "_axis" : "");
    std::replace_if(
        name.begin(), name.end(), [](char c) { return c == ' ' || c == '-'; }, '_');
    return name;
});

}  // namespace
}  // namespace percuss::testing
