#pragma once

#include "contact/row.hpp"
#include "contact/surface.hpp"

namespace percuss {

/// Appends the row of a node k kept out of a side i-j (paper, Figures 1 and 2): its force acts on k along the
/// normal, the reaction on i and j by the shares 1 - a and a, the column of the paper's equilibrium matrix E
/// for the length factor a; the normal stands for its angle phi. @param normal unit, out of the side's body.
/// @param of_master whether the node, and not the side, is of the pair's first body.
inline ContactRow& add_node_to_side(ContactRows& rows, std::int32_t node, const Side& side, double a,
                                    double nx, double ny, bool of_master = true) {
    ContactRow& row = rows.add_row();
    if (of_master) rows.add_term(row, node, nx, ny);
    rows.add_term(row, side.i, (a - 1) * nx, (a - 1) * ny);
    rows.add_term(row, side.j, -a * nx, -a * ny);
    if (!of_master) rows.add_term(row, node, nx, ny);
    row.master_terms = of_master ? 1 : 2;
    return row;
}

}  // namespace percuss
