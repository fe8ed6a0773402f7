#include "contact/assembly.hpp"

#include <algorithm>

namespace percuss {

void ContactAssembly::assemble(const RowSpan& rows, const double* inverse_mass, double factor,
                               ProfileMatrix& matrix) {
    matrix.clear();
    // Written by index: appending to them through this object would chain every entry to the one before.
    std::size_t terms = 0;
    for (const ContactRow& row : rows) terms += static_cast<std::size_t>(row.terms);
    if (links_.size() < terms) reserve(terms);
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
        for (const RowTerm& term : rows.terms(row)) {
            const std::int32_t node = term.node;
            // What a unit force of this row makes the node move, and how much of that another row sees.
            const double ux = factor * term.g[0] * inverse_mass[2 * node];
            const double uy = factor * term.g[1] * inverse_mass[2 * node + 1];
            diagonal += ux * term.g[0] + uy * term.g[1];
            // A node that cannot move couples no rows: all rows on one wall share its two.
            if (inverse_mass[2 * node] == 0 && inverse_mass[2 * node + 1] == 0) continue;
            std::int32_t& head = newest_link(node);
            for (std::int32_t l = head; l >= 0;) {
                const Link& link = links[l];
                first = std::min(first, link.row);
                couplings[coupling_count++] = {link.row, ux * link.g[0] + uy * link.g[1]};
                l = link.next;
            }
            links[link_count] = {k, head, term.g};
            head = link_count++;
        }
        matrix.append_row(first);
        double* entry = matrix.row(k);
        for (std::size_t c = 0; c < coupling_count; ++c) entry[couplings[c].row] += couplings[c].value;
        entry[k] = diagonal;
    }
    for (const ContactRow& row : rows)
        for (const RowTerm& term : rows.terms(row)) newest_link(term.node) = -1;
}

}  // namespace percuss
