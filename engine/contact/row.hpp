#pragma once

#include <array>
#include <cstdint>

namespace percuss {

/// One non-penetration condition: master node k in the slave side i-j (paper, Figures 1 and 2).
struct ContactRow {
    std::array<std::int32_t, 3> node{};  ///< master k, slave i, slave j
    /// Share of the contact force that each node takes along the normal: 1, -(1 - a), -a with the length
    /// factor a. The last two are the column of the paper's equilibrium matrix E, the normal stands for its
    /// angle phi.
    std::array<double, 3> share{};
    std::array<double, 2> normal{};  ///< unit, out of the slave body
    double penetration = 0;          ///< P of the predicted positions [length]
    double force = 0;                ///< C, the master contact force, per radian or unit thickness [force]
    std::int32_t side = 0;           ///< slave side
    std::int32_t master = 0;         ///< index of the master node within its surface
};

/// How a vector of the three nodes acts along a row: the gap rate, by velocities. @param of node -> pointer
/// to its two components.
template <class VectorOf>
[[nodiscard]] double along(const ContactRow& row, VectorOf of) {
    double sum = 0;
    for (std::size_t slot = 0; slot < 3; ++slot) {
        const auto v = of(row.node[slot]);
        sum += row.share[slot] * row.normal[0] * v[0] + row.share[slot] * row.normal[1] * v[1];
    }
    return sum;
}

}  // namespace percuss
