// The vector kernels against the scalar reference, bit by bit.
#include <cstring>

#include <gtest/gtest.h>

#include "engine/elements/element_mesh.hpp"

namespace percuss::testing {
namespace {

template <class T>
bool same_bits(const AlignedVector<T>& a, const AlignedVector<T>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0;
}

/// Shakes the mesh with `set`'s kernels; the motion hangs on their forces, so a difference of one bit grows.
ElementMesh shaken(const ElementMesh::Options& options, InstructionSet set, int steps, double& highest) {
    ElementMesh m(options);
    m.batch.kernel = find_kernel(
        {options.kind, options.geometry, options.hourglass > 0, options.viscosity.has_value()}, set);
    std::mt19937 random(7);
    std::uniform_real_distribution<double> noise(-0.05, 0.05);  // 1 % of the wave speed
    for (std::size_t n = 0; n < m.nodes.size(); ++n)
        for (std::size_t d = 0; d < 2; ++d) m.nodes[n].v[d] = m.held[n][d] ? 0 : noise(random);
    average_volumes(m.batch, m.nodes.data());
    highest = m.batch.kernel.frequency(m.batch, m.nodes.data(), 0, m.batch.blocks());
    m.leapfrog(0.5 * m.estimated_step(), steps, 1e9);
    return m;
}

void compare(const ElementMesh::Options& options, int steps) {
    double scalar_bound, vector_bound;
    const ElementMesh scalar = shaken(options, InstructionSet::baseline, steps, scalar_bound);
    for (const InstructionSet set : {InstructionSet::avx2, InstructionSet::avx512}) {
        if (set > best_instruction_set()) continue;
        SCOPED_TRACE(std::string(percuss::name_of(set)) + ", " + name_of(options.kind) + ", " +
                     name_of(options.geometry));
        const ElementMesh vector = shaken(options, set, steps, vector_bound);
        EXPECT_TRUE(same_bits(scalar.batch.force, vector.batch.force));
        EXPECT_TRUE(same_bits(scalar.batch.state, vector.batch.state));
        EXPECT_TRUE(same_bits(scalar.nodes, vector.nodes));
        EXPECT_EQ(std::memcmp(&scalar.sums, &vector.sums, sizeof(KernelSums)), 0);
        EXPECT_EQ(scalar_bound, vector_bound);
    }
}

TEST(InstructionSets, GiveTheSameBitsForEveryKernel) {
    for (const ElementKind kind : all_kinds)
        for (const Geometry geometry : all_geometries)
            for (const double hourglass : {0.0, 0.1})
                for (const bool viscous : {false, true}) {
                    if (hourglass > 0 && kind != ElementKind::quad_one_point) continue;
                    ElementMesh::Options o;
                    o.kind = kind;
                    o.geometry = geometry;
                    o.columns = 5;
                    o.rows = 7;
                    o.box = {0, 0, 5, 7};
                    o.distortion = 0.2;
                    o.hourglass = hourglass;
                    if (viscous) o.viscosity = BulkViscosity{0.06, 1.2};
                    compare(o, 300);
                }
}

TEST(InstructionSets, AgreeOnPartlyFilledBlocks) {
    for (int elements = 1; elements <= 9; ++elements) {
        ElementMesh::Options o;
        o.columns = elements;
        o.rows = 1;
        o.box = {0, 0, static_cast<double>(elements), 1};
        o.geometry = Geometry::axisymmetric;
        compare(o, 50);
        o.kind = ElementKind::triangle_averaged;
        compare(o, 50);
    }
}

TEST(InstructionSets, LeaveUnusedLanesUntouched) {
    ElementMesh::Options o;
    o.columns = 3;
    o.rows = 1;
    double bound;
    const ElementMesh m = shaken(o, best_instruction_set(), 20, bound);
    for (int component = 0; component < m.batch.kernel.state_size; ++component)
        for (int lane = 3; lane < block_lanes; ++lane)
            EXPECT_EQ(m.batch.state[static_cast<std::size_t>(component * block_lanes + lane)], 0);
    for (const double count : m.sums.inverted) EXPECT_EQ(count, 0);
}

TEST(Kernels, CountInvertedElements) {
    for (const ElementKind kind : all_kinds) {
        ElementMesh::Options o;
        o.kind = kind;
        o.columns = o.rows = 2;
        ElementMesh m(o);
        Eigen::VectorXd u = Eigen::VectorXd::Zero(m.dofs());
        u[0] = u[1] = 5;  // the first corner is pulled through its element
        m.move(u);
        double inverted = 0;
        for (const double lane : m.sums.inverted) inverted += lane;
        EXPECT_GE(inverted, 1) << name_of(kind);
    }
}

}  // namespace
}  // namespace percuss::testing
