#include "contact/assembly.hpp"

#include <algorithm>

namespace percuss {

void ContactAssembly::assemble(std::span<const ContactRow> rows, const double* inverse_mass, double factor,
                               ProfileMatrix& matrix) {
    matrix.clear();
    // Written by index: appending to them through this object would chain every entry to the one before.
    if (links_.size() < 3 * rows.size()) reserve(rows.size());
    Link* const links = links_.data();
    Coupling* const couplings = couplings_.data();
    std::int32_t link_count = 0;
    const auto newest_link = [this](std::int32_t node) -> std::int32_t& {
        return head_[static_cast<std::size_t>(node)];
    };
    for (std::int32_t k = 0; k < static_cast<std::int32_t>(rows.size()); ++k) {
        const ContactRow& row = rows[static_cast<std::size_t>(k)];
        std::size_t coupling_count = 0;
        std::int32_t first = k;
        double diagonal = 0;
        for (std::size_t slot = 0; slot < 3; ++slot) {
            const std::int32_t node = row.node[slot];
            // What a unit force of this row makes the node move, and how much of that another row sees.
            const double ux = factor * row.share[slot] * row.normal[0] * inverse_mass[2 * node];
            const double uy = factor * row.share[slot] * row.normal[1] * inverse_mass[2 * node + 1];
            diagonal += row.share[slot] * (ux * row.normal[0] + uy * row.normal[1]);
            // A node that cannot move couples no rows: all rows on one wall share its two.
            if (inverse_mass[2 * node] == 0 && inverse_mass[2 * node + 1] == 0) continue;
            std::int32_t& head = newest_link(node);
            for (std::int32_t l = head; l >= 0;) {
                const Link& link = links[l];
                const ContactRow& other = rows[static_cast<std::size_t>(link.row)];
                first = std::min(first, link.row);
                couplings[coupling_count++] = {link.row,
                                               link.share * (ux * other.normal[0] + uy * other.normal[1])};
                l = link.next;
            }
            links[link_count] = {k, head, row.share[slot]};
            head = link_count++;
        }
        matrix.append_row(first);
        double* entry = matrix.row(k);
        for (std::size_t c = 0; c < coupling_count; ++c) entry[couplings[c].row] += couplings[c].value;
        entry[k] = diagonal;
    }
    for (const ContactRow& row : rows)
        for (const std::int32_t node : row.node) newest_link(node) = -1;
}

}  // namespace percuss
