// Triangles with averaged volumes: what sets them apart from triangles that stand alone.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "engine/elements/element_mesh.hpp"

namespace percuss::testing {
namespace {

ElementMesh shaken(Geometry geometry, std::optional<BulkViscosity> viscosity = {}) {
    ElementMesh::Options o;
    o.kind = ElementKind::triangle_averaged;
    o.geometry = geometry;
    o.box = {0, 0, 3, 3};
    o.distortion = 0.2;
    o.viscosity = viscosity;
    ElementMesh m(o);
    std::mt19937 random(5);
    std::uniform_real_distribution<double> noise(-0.05, 0.05);
    Eigen::VectorXd u(m.dofs());
    for (double& value : u) value = noise(random);
    for (std::size_t n = 0; n < m.held.size(); ++n)
        if (m.held[n][0]) u[static_cast<Eigen::Index>(2 * n)] = 0;
    m.move(u);
    return m;
}

/// What a node has of its elements' values: a third of each.
template <class OfElement>
std::vector<double> thirds(const ElementMesh& m, OfElement of_element) {
    std::vector<double> sums(m.nodes.size(), 0);
    for (std::int32_t e = 0; e < m.batch.count; ++e) {
        const Cell& cell = m.mesh.cells[static_cast<std::size_t>(e)];
        for (std::size_t i = 0; i < 3; ++i) sums[static_cast<std::size_t>(cell[i])] += of_element(cell) / 3;
    }
    return sums;
}

TEST(AveragedTriangle, HasTheMeanOfItsNodesPressures) {
    for (const Geometry geometry : all_geometries) {
        const ElementMesh m = shaken(geometry);
        ElementMesh start = m;
        start.rest();
        const auto now = thirds(m, [&](const Cell& c) { return cell_volume(c, m.nodes.data(), geometry); });
        const auto before =
            thirds(m, [&](const Cell& c) { return cell_volume(c, start.nodes.data(), geometry); });
        const double bulk = geometry == Geometry::plane_stress ? 200 / (2 * 0.7) : 200 / (3 * 0.4);
        for (std::int32_t e = 0; e < m.batch.count; ++e) {
            double mean = 0, energy = 0;
            for (std::size_t i = 0; i < 3; ++i) {
                const auto n = static_cast<std::size_t>(m.mesh.cells[static_cast<std::size_t>(e)][i]);
                const double ratio = now[n] / before[n];
                mean += 0.5 * bulk * (1 - 1 / (ratio * ratio)) / 3;
                energy += 0.5 * bulk * (ratio + 1 / ratio - 2) / 3;
            }
            const auto s = m.stress(e);
            const double trace =
                geometry == Geometry::plane_stress ? (s[0] + s[1]) / 2 : (s[0] + s[1] + s[2]) / 3;
            EXPECT_NEAR(trace, mean, 1e-12 * bulk) << name_of(geometry);
            EXPECT_GT(stored_energy(m.batch, m.nodes.data(), e),
                      energy * m.batch.volume[static_cast<std::size_t>(e)]);  // and that of the deviator
        }
    }
}

/// All volumes change alike, first by the stretch, then by a little more.
ElementMesh stretched(ElementKind kind, Geometry geometry, double stretch, double distortion, bool viscous) {
    ElementMesh::Options o;
    o.kind = kind;
    o.geometry = geometry;
    o.box = {0, 0, 3, 3};
    o.distortion = distortion;
    if (viscous) o.viscosity = BulkViscosity{0.06, 1.2};
    ElementMesh m(o);
    m.move(m.displacement([&](const Vec2& x) { return Vec2((stretch - 1) * x); }));
    m.move(m.displacement([](const Vec2& x) { return Vec2(-1e-3 * x); }));
    return m;
}

/// Averages are then what each triangle has by itself, and so is all that follows.
TEST(AveragedTriangle, IsATriangleWhereVolumesChangeAlike) {
    for (const Geometry geometry : all_geometries) {
        for (const double stretch : {0.7, 1.2}) {
            SCOPED_TRACE(name_of(geometry) + " stretched by " + std::to_string(stretch));
            const auto moved = [&](ElementKind kind) {
                return stretched(kind, geometry, stretch, 0.2, false);
            };
            ElementMesh averaged = moved(ElementKind::triangle_averaged),
                        alone = moved(ElementKind::triangle);
            const Eigen::VectorXd force = averaged.internal_force(), expected = alone.internal_force();
            EXPECT_LT((force - expected).norm(), 1e-12 * expected.norm());
            EXPECT_NEAR(averaged.energy(), alone.energy(), 1e-12 * alone.energy());
            EXPECT_NEAR(averaged.estimated_step(), alone.estimated_step(), 1e-12);

            // Viscosity: equal triangles, for a node takes the mean of their sizes. Rates are those at the
            // end of the step here, in its middle there.
            const auto with_viscosity = [&](ElementKind kind) {
                return stretched(kind, geometry, stretch, 0, true);
            };
            const auto viscous_force = [&](ElementKind kind) {
                return Eigen::VectorXd(with_viscosity(kind).internal_force() -
                                       stretched(kind, geometry, stretch, 0, false).internal_force());
            };
            const Eigen::VectorXd viscous = viscous_force(ElementKind::triangle_averaged),
                                  viscous_alone = viscous_force(ElementKind::triangle);
            EXPECT_LT((viscous - viscous_alone).norm(), 3e-3 * viscous_alone.norm());
            EXPECT_GT(viscous_alone.norm(), 1e-6 * expected.norm());
            const double step = with_viscosity(ElementKind::triangle).estimated_step();
            EXPECT_NEAR(with_viscosity(ElementKind::triangle_averaged).estimated_step(), step, 1e-5 * step);
            EXPECT_LT(step,
                      0.99 * stretched(ElementKind::triangle, geometry, stretch, 0, false).estimated_step());
        }
    }
}

/// Stiffness of volumes by themselves, sum of U''(J_a) / V_a dv_a dv_a, of nodes that are compressed
/// unevenly.
TEST(AveragedTriangle, StepIsBoundedByTheCompressionOfItsNodes) {
    for (const Geometry geometry : all_geometries) {
        double least = 1;
        for (unsigned seed = 1; seed <= 20; ++seed) {
            ElementMesh::Options o;
            o.kind = ElementKind::triangle_averaged;
            o.geometry = geometry;
            o.columns = o.rows = seed % 4 == 0 ? 1 : 3;
            o.poisson = geometry == Geometry::plane_stress ? 0.3 : 0.4999;
            o.distortion = 0.2;
            o.seed = seed;
            ElementMesh m(o);
            std::mt19937 random(seed);
            std::uniform_real_distribution<double> noise(-0.15, 0.15);
            Eigen::VectorXd u = m.displacement([](const Vec2& x) { return Vec2(-0.3 * x); });
            const double cell = 3.0 / o.columns;
            for (double& value : u) value += cell * noise(random);
            const ElementMesh start = m;
            m.move(u);
            const auto volumes = [&](const AlignedVector<Node>& nodes) {
                return thirds(m, [&](const Cell& c) { return cell_volume(c, nodes.data(), geometry); });
            };
            const auto initial = volumes(start.nodes), now = volumes(m.nodes);
            if (*std::min_element(now.begin(), now.end()) < 0.05 * initial[0]) continue;
            Eigen::MatrixXd k = Eigen::MatrixXd::Zero(m.dofs(), m.dofs()),
                            gradients(static_cast<Eigen::Index>(now.size()), m.dofs());
            for (Eigen::Index j = 0; j < m.dofs(); ++j) {
                AlignedVector<Node> more = m.nodes, less = m.nodes;
                const double step = 1e-6;
                more[static_cast<std::size_t>(j / 2)].x[j % 2] += step;
                less[static_cast<std::size_t>(j / 2)].x[j % 2] -= step;
                const auto up = volumes(more), down = volumes(less);
                for (std::size_t a = 0; a < now.size(); ++a)
                    gradients(static_cast<Eigen::Index>(a), j) = (up[a] - down[a]) / (2 * step);
            }
            for (std::size_t a = 0; a < now.size(); ++a) {
                const double ratio = now[a] / initial[a];
                const Eigen::RowVectorXd row = gradients.row(static_cast<Eigen::Index>(a));
                k += m.batch.material.bulk / (ratio * ratio * ratio * initial[a]) * row.transpose() * row;
            }
            Eigen::VectorXd root(m.dofs());
            for (Eigen::Index j = 0; j < m.dofs(); ++j)
                root[j] = 1 / std::sqrt(m.mass[static_cast<std::size_t>(j / 2)]);
            const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(
                root.asDiagonal() * k * root.asDiagonal(), Eigen::EigenvaluesOnly);
            const double step = 2 / std::sqrt(solver.eigenvalues().maxCoeff());
            EXPECT_LE(m.estimated_step(), step * (1 + 1e-6)) << name_of(geometry) << " seed " << seed;
            least = std::min(least, m.estimated_step() / step);
        }
        RecordProperty(name_of(geometry), std::to_string(least));
        EXPECT_GT(least, 0.2) << name_of(geometry);
    }
}

TEST(AveragedTriangle, FeelsItsNeighbours) {
    // A node that no corner of the first element shares moves; the element's pressure follows all the same.
    ElementMesh::Options o;
    o.kind = ElementKind::triangle_averaged;
    ElementMesh m(o);
    m.nodes[10].x[0] += 0.05;  // across the element that has it, of which nodes 5 and 6 are corners as well
    m.update(1);
    EXPECT_GT(std::abs(m.stress(0)[2]), 1e-3);
    o.kind = ElementKind::triangle;
    ElementMesh alone(o);
    alone.nodes[10].x[0] += 0.05;
    alone.update(1);
    EXPECT_NEAR(alone.stress(0)[2], 0, 1e-12);
}

TEST(AveragedTriangle, ViscosityOpposesTheRatesOfNodalVolumes) {
    for (const Geometry geometry : all_geometries) {
        const ElementMesh with = shaken(geometry, BulkViscosity{0.06, 1.2}), without = shaken(geometry);
        const Eigen::VectorXd viscous = with.internal_force() - without.internal_force();
        double power = 0;
        for (std::size_t n = 0; n < with.nodes.size(); ++n)
            for (std::size_t d = 0; d < 2; ++d)
                power += viscous[static_cast<Eigen::Index>(2 * n + d)] * with.nodes[n].v[d];
        // Node by node: pressures in compression only, each times its own rate of volume.
        const double step = 1e-6;
        auto rate = [&](double sign) {
            AlignedVector<Node> moved = with.nodes;
            for (Node& node : moved)
                for (int d = 0; d < 2; ++d) node.x[d] += sign * step * node.v[d];
            return thirds(with, [&](const Cell& c) { return cell_volume(c, moved.data(), geometry); });
        };
        const auto more = rate(1), less = rate(-1);
        double expected = 0;
        for (std::size_t n = 0; n < more.size(); ++n) {
            const double change = (more[n] - less[n]) / (2 * step), q = with.batch.shared.nodes[n].viscous;
            EXPECT_EQ(q > 0, change < 0) << name_of(geometry) << " node " << n;
            expected -= q * change;
        }
        EXPECT_GT(power, 0);
        EXPECT_NEAR(power, expected, 1e-7 * power) << name_of(geometry);
    }
}

}  // namespace
}  // namespace percuss::testing
