#include "contact/assembly.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "engine/contact/node_row.hpp"
#include "engine/contact/solvers/random_system.hpp"

namespace percuss {
namespace {

using testing::common_form;
using testing::Dense;
using testing::NodeRow;
using testing::Rng;

/// The paper's E and M written out: one column of unit force components a row, masses on a diagonal.
Dense by_definition(const std::vector<NodeRow>& rows, const std::vector<double>& inverse_mass,
                    double factor) {
    const auto components = static_cast<Eigen::Index>(inverse_mass.size());
    Dense g = Dense::Zero(components, static_cast<Eigen::Index>(rows.size()));
    for (std::size_t k = 0; k < rows.size(); ++k)
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t d = 0; d < 2; ++d)
                g(2 * rows[k].node[i] + static_cast<Eigen::Index>(d), static_cast<Eigen::Index>(k)) +=
                    rows[k].share[i] * rows[k].normal[d];
    const Eigen::VectorXd m = Eigen::Map<const Eigen::VectorXd>(inverse_mass.data(), components);
    return factor * g.transpose() * m.asDiagonal() * g;
}

NodeRow random_row(Rng& random, std::int32_t master, std::int32_t i, std::int32_t j) {
    NodeRow row;
    const double a = random.uniform(0, 1), angle = random.uniform(0, 6.28);
    row.node = {master, i, j};
    row.share = {1, a - 1, -a};
    row.normal = {std::cos(angle), std::sin(angle)};
    return row;
}

TEST(ContactAssembly, EqualsEquationSixWithDenseMatrices) {
    Rng random(6);
    constexpr int nodes = 24;
    ContactAssembly assembly(nodes);  // used over and over: nothing may be left from a call
    for (int round = 0; round < 200; ++round) {
        std::vector<double> inverse_mass = random.vector(2 * nodes, 0.5, 3);
        inverse_mass[static_cast<std::size_t>(random.index(2 * nodes))] = 0;
        std::vector<NodeRow> rows;
        for (int k = 0; k < 1 + round % 12; ++k) {
            // Slave sides along a chain, now and then jumping; a master node in one row may be a slave node
            // of another.
            const int side = round % 2 ? random.index(10) : std::min(k, 10);
            rows.push_back(random_row(random, 12 + k % 12, side, side + 1));
        }
        ProfileMatrix matrix;
        assembly.assemble(common_form(rows).all(), inverse_mass.data(), 0.37, matrix);
        EXPECT_LT((testing::dense(matrix) - by_definition(rows, inverse_mass, 0.37)).cwiseAbs().maxCoeff(),
                  1e-14);
    }
}

// The paper's groups: no entry is stored between rows on sides that are neither the same nor adjacent, a
// chain of n rows stays a band.
TEST(ContactAssembly, StoresNarrowGroupsOnly) {
    Rng random(7);
    std::vector<NodeRow> rows;
    for (const int side : {0, 0, 1, 5, 6, 6, 7})
        rows.push_back(random_row(random, 20 + static_cast<int>(rows.size()), side, side + 1));
    const std::vector<double> inverse_mass(60, 1.0);
    ProfileMatrix matrix;
    ContactAssembly(30).assemble(common_form(rows).all(), inverse_mass.data(), 1, matrix);
    const std::int32_t first[] = {0, 0, 0, 3, 3, 3, 4};
    for (std::int32_t k = 0; k < 7; ++k) EXPECT_EQ(matrix.first(k), first[k]) << k;
}

}  // namespace
}  // namespace percuss
