// Bending: nearly incompressible material must not lock, and one-point quads must not be floppy.
#include <gtest/gtest.h>

#include "engine/elements/element_mesh.hpp"

namespace percuss::testing {
namespace {

ElementMesh::Options beam(ElementKind kind, double poisson) {
    ElementMesh::Options o;
    o.kind = kind;
    o.columns = 16;
    o.rows = 4;
    o.box = {0, 0, 8, 2};
    o.poisson = poisson;
    return o;
}

/// Deflection at the end of a cantilever under a unit end shear, from the kernels' own stiffness.
double tip_deflection(const ElementMesh::Options& options) {
    ElementMesh m(options);
    for (std::size_t n = 0; n < m.mesh.nodes.size(); ++n)
        if (m.mesh.nodes[n].x() == options.box[0]) m.held[n] = {true, true};
    const auto free = m.free_dofs();
    const Eigen::MatrixXd k = m.stiffness();
    Eigen::VectorXd load = Eigen::VectorXd::Zero(m.dofs());
    const auto end_node = [&](int row) { return row * (options.columns + 1) + options.columns; };
    for (int row = 0; row <= options.rows; ++row)
        load[2 * end_node(row) + 1] = (row == 0 || row == options.rows ? 0.5 : 1.0) / options.rows;
    const Eigen::MatrixXd free_stiffness = k(free, free);
    const Eigen::VectorXd free_load = load(free);
    return free_load.dot(free_stiffness.ldlt().solve(free_load));
}

/// Timoshenko beam in plane strain: bending with E/(1 - nu^2), shear with the factor 5/6.
double beam_theory(const ElementMesh::Options& o) {
    const double length = o.box[2] - o.box[0], height = o.box[3] - o.box[1];
    const double modulus = o.young / (1 - o.poisson * o.poisson), shear = o.young / (2 * (1 + o.poisson));
    return length * length * length / (3 * modulus * height * height * height / 12) +
           length / (5.0 / 6.0 * shear * height);
}

TEST(Bending, OfNearlyIncompressibleMaterialDoesNotLock) {
    // Plain full integration keeps 0.10 of the deflection of nu = 0.3; beam theory keeps 0.84.
    for (const ElementKind kind : {ElementKind::quad_one_point, ElementKind::quad_mean_dilatation}) {
        const auto soft = beam(kind, 0.3), stiff = beam(kind, 0.4999);
        const double kept = tip_deflection(stiff) / tip_deflection(soft),
                     exact = beam_theory(stiff) / beam_theory(soft);
        RecordProperty(name_of(kind), std::to_string(kept));
        EXPECT_NEAR(kept, exact, 0.08 * exact) << name_of(kind);
    }
}

TEST(Bending, AgreesWithBeamTheory) {
    for (const ElementKind kind : {ElementKind::quad_one_point, ElementKind::quad_mean_dilatation}) {
        const auto o = beam(kind, 0.3);
        const double ratio = tip_deflection(o) / beam_theory(o);
        RecordProperty(name_of(kind), std::to_string(ratio));
        // Four elements over the height: one-point quads without hourglass energy bend too easily by
        // (4^2)/(4^2 - 1).
        EXPECT_NEAR(ratio, 1, 0.07) << name_of(kind);
    }
}

TEST(Hourglass, ModesAreResistedOnlyByTheirStiffness) {
    for (const Geometry geometry : all_geometries) {
        ElementMesh::Options o;
        o.geometry = geometry;
        o.columns = o.rows = 1;
        o.box = {1000, 0, 1001, 1};
        for (const int direction : {0, 1}) {
            const auto mode = [&](const Vec2& x) {
                const double value = 1e-6 * ((x.x() > 1000.5) == (x.y() > 0.5) ? 1 : -1);
                return Vec2(direction == 0 ? value : 0, direction == 1 ? value : 0);
            };
            o.hourglass = 0;
            ElementMesh loose(o);
            const double without = loose.move(loose.displacement(mode)).norm();
            o.hourglass = 0.1;
            ElementMesh firm(o);
            const double with = firm.move(firm.displacement(mode)).norm();
            // In a ring the mode has a little mean strain, of order cell / radius, here 1e-3 times lambda + 2
            // mu.
            EXPECT_LT(without, 0.02 * with) << name_of(geometry) << " direction " << direction;
            EXPECT_GT(with, 0.01 * 200 * 1e-6);
        }
    }
}

}  // namespace
}  // namespace percuss::testing
