// The element estimate of the critical step against the true one, 2 / omega_max of the assembled mesh.
#include <limits>

#include <gtest/gtest.h>

#include "engine/elements/element_mesh.hpp"

namespace percuss::testing {
namespace {

/// Stiffness by differences is good to 1e-9; eigenvalues to rounding.
constexpr double tolerance = 1e-7;

struct Tightness {
    double least = std::numeric_limits<double>::infinity(), most = 0;
    void add(double ratio) {
        least = std::min(least, ratio);
        most = std::max(most, ratio);
    }
    [[nodiscard]] std::string text() const { return std::to_string(least) + " to " + std::to_string(most); }
};

double estimate_over_true(const ElementMesh::Options& options) {
    ElementMesh m(options);
    return m.estimated_step() / m.true_critical_step();
}

TEST(CriticalStep, EstimateIsNeverAboveTheTrueOneOnDistortedMeshes) {
    for (const ElementKind kind : all_kinds) {
        for (const Geometry geometry : all_geometries) {
            Tightness tightness;
            for (const double poisson : {-0.5, 0.0, 0.3, 0.49, 0.4999}) {
                for (const double slenderness : {0.05, 1.0, 20.0}) {
                    for (const double hourglass : {0.0, 0.1, 1.0}) {
                        if (kind != ElementKind::quad_one_point && hourglass > 0) continue;
                        for (const double inner : {0.0, 2.0}) {  // touching r = 0 or not
                            ElementMesh::Options o;
                            o.kind = kind;
                            o.geometry = geometry;
                            o.poisson = poisson;
                            o.hourglass = hourglass;
                            o.columns = 3;
                            o.rows = 4;
                            o.box = {inner, 0, inner + 3, 4 * slenderness};
                            o.distortion = 0.3;
                            o.distort_boundary = true;
                            o.seed = static_cast<unsigned>(100 * slenderness + 7 * hourglass + inner);
                            const double ratio = estimate_over_true(o);
                            tightness.add(ratio);
                            EXPECT_LE(ratio, 1 + tolerance)
                                << name_of(kind) << ", " << name_of(geometry) << ", nu " << poisson
                                << ", slenderness " << slenderness << ", hourglass " << hourglass
                                << ", inner radius " << inner;
                        }
                    }
                }
            }
            RecordProperty(name_of(kind) + " " + name_of(geometry), tightness.text());
        }
    }
}

TEST(CriticalStep, EstimateIsCloseOnRegularMeshes) {
    for (const ElementKind kind : all_kinds) {
        for (const Geometry geometry : all_geometries) {
            Tightness tightness;
            for (const double poisson : {0.0, 0.3, 0.45}) {
                for (const double slenderness : {0.2, 1.0, 5.0}) {
                    ElementMesh::Options o;
                    o.kind = kind;
                    o.geometry = geometry;
                    o.poisson = poisson;
                    o.columns = o.rows = 6;
                    o.box = {0, 0, 6, 6 * slenderness};
                    tightness.add(estimate_over_true(o));
                }
            }
            RecordProperty(name_of(kind) + " " + name_of(geometry), tightness.text());
            // A triangle alone has the masses of its own corners only and swings faster than any mesh of
            // them; averaging softens the mesh further.
            EXPECT_GE(tightness.least, kind == ElementKind::triangle_averaged ? 0.4
                                       : is_triangle(kind)                    ? 0.6
                                                                              : 0.7)
                << name_of(kind) << ", " << name_of(geometry);
            EXPECT_LE(tightness.most, 1 + tolerance);
        }
    }
}

/// The bound against the highest frequency of the one element that it is a bound of.
TEST(CriticalStep, EstimateOfOneElementIsNearlyItsHighestFrequency) {
    for (const ElementKind kind : all_kinds) {
        for (const Geometry geometry : all_geometries) {
            Tightness tightness;
            for (const double poisson : {-0.5, 0.0, 0.3, 0.4999}) {
                for (const double slenderness : {0.05, 0.5, 1.0, 20.0}) {
                    for (unsigned seed = 1; seed <= 10; ++seed) {
                        ElementMesh::Options o;
                        o.kind = kind;
                        o.geometry = geometry;
                        o.poisson = poisson;
                        o.columns = o.rows = 1;
                        const double inner = seed % 3 == 0 ? 0 : 1;
                        o.box = {inner, 0, inner + 1, slenderness};
                        o.distortion = 0.02 * seed;
                        o.distort_boundary = true;
                        o.seed = seed;
                        ElementMesh m(o);
                        if (is_triangle(kind)) {
                            m.mesh.cells.resize(1);
                            m.mesh.bodies[0].cell_end = 1;
                            m.held[2] = {true, true};  // the corner that no element has any more
                            m.make();
                        }
                        tightness.add(m.estimated_step() / m.true_critical_step());
                    }
                }
            }
            RecordProperty(name_of(kind) + " " + name_of(geometry), tightness.text());
            EXPECT_LE(tightness.most, 1 + tolerance) << name_of(kind) << ", " << name_of(geometry);
            // The row norm of A^4 is up to sqrt(6) times its radius, so omega^2 up to sqrt(6)^(1/4), the step
            // sqrt(6)^(1/8) = 1.12.
            EXPECT_GE(tightness.least, 0.89) << name_of(kind) << ", " << name_of(geometry);
        }
    }
}

TEST(CriticalStep, EstimateKnowsHeldNodes) {
    for (const ElementKind kind : all_kinds) {
        ElementMesh::Options o;
        o.kind = kind;
        o.distortion = 0.2;
        ElementMesh m(o);
        const double loose = m.estimated_step();
        for (std::size_t n = 0; n < m.held.size(); ++n) m.held[n] = {true, n % 3 != 0};
        m.make();
        EXPECT_LE(m.estimated_step(), m.true_critical_step() * (1 + tolerance)) << name_of(kind);
        EXPECT_GT(m.estimated_step(), loose) << name_of(kind);
    }
}

/// 2 / omega_max about the present, stressed state: differences of the kernel's forces from it. The tangent
/// of Jaumann's rate is not quite symmetric: complex eigenvalues count by their magnitude.
double true_step_here(ElementMesh& m) {
    const auto state = m.batch.state;
    const auto nodes = m.nodes;
    const auto moved = [&](const Eigen::VectorXd& u) {
        m.batch.state = state;
        m.nodes = nodes;
        return m.move(u);
    };
    Eigen::MatrixXd k(m.dofs(), m.dofs());
    const double small = 1e-6;
    for (Eigen::Index j = 0; j < m.dofs(); ++j) {
        const Eigen::VectorXd u = small * Eigen::VectorXd::Unit(m.dofs(), j);
        k.col(j) = (moved(u) - moved(-u)) / (2 * small);
    }
    m.batch.state = state;
    m.nodes = nodes;
    for (Eigen::Index j = 0; j < m.dofs(); ++j) k.row(j) /= m.mass[static_cast<std::size_t>(j / 2)];
    const auto free = m.free_dofs();
    const Eigen::MatrixXd reduced = k(free, free);
    return 2 / std::sqrt(reduced.eigenvalues().cwiseAbs().maxCoeff());
}

TEST(CriticalStep, EstimateHoldsAtLargeStrainsAndStresses) {
    struct Case {
        const char* name;
        double xx, xy, yy;  // of the deformation gradient
    };
    for (const Case& c : {Case{"squeezed", 1, 0, 0.5},
                          {"to a fifth", 1, 0, 0.2},
                          {"stretched", 1, 0, 1.8},
                          {"all round", 0.6, 0, 0.6},
                          {"blown up", 1.5, 0, 1.5},
                          {"sheared", 1, 0.8, 1},
                          {"drawn", 0.6, 0, 1.6}}) {
        for (const ElementKind kind : all_kinds) {
            for (const Geometry geometry : all_geometries) {
                ElementMesh::Options o;
                o.kind = kind;
                o.geometry = geometry;
                o.columns = o.rows = 3;
                o.box = {1, 0, 4, 3};
                o.distortion = 0.15;
                ElementMesh m(o);
                constexpr int steps = 400;
                for (int k = 0; k < steps; ++k) {
                    const double t0 = static_cast<double>(k) / steps, t1 = t0 + 1.0 / steps;
                    const auto at = [&](double t, const Vec2& x) {
                        const double sheared = x.x() + t * c.xy * x.y();
                        return Vec2(sheared * (1 + t * (c.xx - 1)), x.y() * (1 + t * (c.yy - 1)));
                    };
                    Eigen::VectorXd u(m.dofs());
                    for (std::size_t n = 0; n < m.nodes.size(); ++n)
                        u.segment<2>(static_cast<Eigen::Index>(2 * n)) =
                            at(t1, m.mesh.nodes[n]) - at(t0, m.mesh.nodes[n]);
                    m.move(u);
                }
                for (Node& node : m.nodes) node.v[0] = node.v[1] = 0;
                const double ratio = m.estimated_step() / true_step_here(m);
                EXPECT_LE(ratio, 1 + 1e-5) << c.name << ", " << name_of(kind) << ", " << name_of(geometry);
                RecordProperty(std::string(c.name) + " " + name_of(kind) + " " + name_of(geometry),
                               std::to_string(ratio));
            }
        }
    }
}

void add_noise(ElementMesh& m, double speed) {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> noise(-speed, speed);
    for (std::size_t n = 0; n < m.nodes.size(); ++n)
        for (std::size_t d = 0; d < 2; ++d) m.nodes[n].v[d] = m.held[n][d] ? 0 : noise(random);
}

double kinetic_energy(const ElementMesh& m) {
    double energy = 0;
    for (std::size_t n = 0; n < m.nodes.size(); ++n)
        energy += 0.5 * m.mass[n] * (m.nodes[n].v[0] * m.nodes[n].v[0] + m.nodes[n].v[1] * m.nodes[n].v[1]);
    return energy;
}

// Noise of 1e-6 of the wave speed, 5: linear, so what grows does so exponentially.
constexpr double noise_speed = 5e-6;

TEST(CriticalStep, NoiseStaysBoundedBelowTheEstimateAndGrowsAboveTheTrueStep) {
    for (const ElementKind kind : all_kinds) {
        for (const Geometry geometry : all_geometries) {
            SCOPED_TRACE(name_of(kind) + ", " + name_of(geometry));
            ElementMesh::Options o;
            o.kind = kind;
            o.geometry = geometry;
            o.columns = o.rows = 4;
            o.box = {0, 0, 4, 4};
            o.distortion = 0.2;
            ElementMesh m(o);
            const double true_step = m.true_critical_step();
            add_noise(m, noise_speed);
            const double before = kinetic_energy(m);
            // Kinetic energy at half steps may exceed the conserved energy by 1 / (1 - 0.99^2) = 50.
            EXPECT_LT(m.leapfrog(0.99 * m.estimated_step(), 5000, 1), 50 * before);
            m.rest();
            add_noise(m, noise_speed);
            // 1.05 of critical: each step multiplies the highest mode by 1.88.
            EXPECT_EQ(m.leapfrog(1.05 * true_step, 200, 1), std::numeric_limits<double>::infinity());
        }
    }
}

TEST(CriticalStep, EstimateWithBulkViscosityIsStable) {
    for (const ElementKind kind : all_kinds) {
        for (const Geometry geometry : all_geometries) {
            SCOPED_TRACE(name_of(kind) + ", " + name_of(geometry));
            ElementMesh::Options o;
            o.kind = kind;
            o.geometry = geometry;
            o.columns = o.rows = 4;
            o.box = {0, 0, 4, 4};
            ElementMesh plain(o);
            o.viscosity = BulkViscosity{0.5, 1.2};
            ElementMesh m(o);
            EXPECT_LT(m.estimated_step(), 0.95 * plain.estimated_step());
            add_noise(m, noise_speed);
            EXPECT_LT(m.leapfrog(0.999 * m.estimated_step(), 5000, 1), kinetic_energy(m) + 1e-9);
        }
    }
}

}  // namespace
}  // namespace percuss::testing
