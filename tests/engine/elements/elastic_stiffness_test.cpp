#include "elements/elastic_stiffness.hpp"

#include <gtest/gtest.h>

#include "engine/elements/element_mesh.hpp"

namespace percuss::testing {
namespace {

// The forces of small random motions of a distorted mesh are the stiffness times the motion, to second order.
TEST(ElasticStiffness, IsThatOfTheKernels) {
    for (const ElementKind kind :
         {ElementKind::quad_one_point, ElementKind::quad_mean_dilatation, ElementKind::triangle}) {
        for (const Geometry geometry :
             {Geometry::plane_strain, Geometry::plane_stress, Geometry::axisymmetric}) {
            ElementMesh::Options o;
            o.kind = kind;
            o.geometry = geometry;
            o.distortion = 0.2;
            o.hold_axis = false;
            ElementMesh m(o);
            std::mt19937 random(5);
            std::uniform_real_distribution<double> small(-1e-7, 1e-7);
            const auto count = static_cast<Eigen::Index>(2 * m.mesh.nodes.size());
            Eigen::VectorXd motion(count), expected = Eigen::VectorXd::Zero(count);
            for (double& u : motion) u = small(random);
            for (const Cell& cell : m.mesh.cells) {
                const CellStiffness k =
                    elastic_stiffness(cell, kind, m.nodes.data(), 0, m.batch.material, geometry);
                EXPECT_LT((k - k.transpose()).norm(), 1e-12 * k.norm());
                Eigen::Matrix<double, 8, 1> u = Eigen::Matrix<double, 8, 1>::Zero();
                for (int i = 0; i < corner_count(cell); ++i)
                    u.segment<2>(2 * i) = motion.segment<2>(2 * cell[static_cast<std::size_t>(i)]);
                const Eigen::Matrix<double, 8, 1> f = k * u;
                for (int i = 0; i < corner_count(cell); ++i)
                    expected.segment<2>(2 * cell[static_cast<std::size_t>(i)]) += f.segment<2>(2 * i);
            }
            const Eigen::VectorXd force = m.move(motion);
            EXPECT_LT((force - expected).norm(), 1e-5 * expected.norm())
                << name_of(kind) << ", " << name_of(geometry);
        }
    }
}

}  // namespace
}  // namespace percuss::testing
