#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "contact/row.hpp"

namespace percuss::testing {

/// A row of a node in a side as the paper writes it.
struct NodeRow {
    std::array<std::int32_t, 3> node{};  ///< master k, slave i, slave j
    std::array<double, 3> share{};       ///< 1, a - 1, -a
    std::array<double, 2> normal{};
    double penetration = 0, force = 0;
    std::int32_t side = 0, master = 0;
};

/// @pre rows of master nodes in slave sides.
inline std::vector<NodeRow> node_rows(const RowSpan& rows) {
    std::vector<NodeRow> all;
    for (const ContactRow& row : rows) {
        const auto terms = rows.terms(row);
        NodeRow& r = all.emplace_back();
        r.normal = terms[0].g;
        for (std::size_t k = 0; k < 3; ++k) {
            r.node[k] = terms[k].node;
            r.share[k] = terms[k].g[0] * r.normal[0] + terms[k].g[1] * r.normal[1];
        }
        r.share[0] = 1;
        r.penetration = row.penetration;
        r.force = row.force;
        r.side = row.side;
        r.master = row.owner;
    }
    return all;
}

inline ContactRows common_form(const std::vector<NodeRow>& rows) {
    ContactRows all;
    for (const NodeRow& r : rows) {
        ContactRow& row = all.add_row();
        for (std::size_t k = 0; k < 3; ++k)
            all.add_term(row, r.node[k], r.share[k] * r.normal[0], r.share[k] * r.normal[1]);
        row.master_terms = 1;
        row.penetration = r.penetration;
        row.force = r.force;
    }
    return all;
}

}  // namespace percuss::testing
