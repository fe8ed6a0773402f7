#include "contact/assembly.hpp"

#include <algorithm>

namespace percuss {

void ContactAssembly::assemble(std::span<const ContactRow> rows, const double* inverse_mass, double factor,
                               ProfileMatrix& matrix) {
    matrix.clear();
    links_.clear();
    for (std::int32_t k = 0; k < static_cast<std::int32_t>(rows.size()); ++k) {
        const ContactRow& row = rows[static_cast<std::size_t>(k)];
        std::int32_t first = k;
        for (std::int32_t slot = 0; slot < 3; ++slot) {
            // A node that cannot move couples no rows: all rows on one wall share its two.
            const std::int32_t of = row.node[static_cast<std::size_t>(slot)];
            if (inverse_mass[2 * of] == 0 && inverse_mass[2 * of + 1] == 0) continue;
            std::int32_t& head = head_[static_cast<std::size_t>(row.node[static_cast<std::size_t>(slot)])];
            links_.push_back({k, slot, head});
            head = static_cast<std::int32_t>(links_.size()) - 1;
            for (std::int32_t l = head; l >= 0; l = links_[static_cast<std::size_t>(l)].next)
                first = std::min(first, links_[static_cast<std::size_t>(l)].row);
        }
        matrix.append_row(first);
        for (std::size_t slot = 0; slot < 3; ++slot) {
            const std::int32_t node = row.node[slot];
            const double share = factor * row.share[slot];
            const double gx = share * row.normal[0] * inverse_mass[2 * node];
            const double gy = share * row.normal[1] * inverse_mass[2 * node + 1];
            for (std::int32_t l = head_[static_cast<std::size_t>(node)]; l >= 0;
                 l = links_[static_cast<std::size_t>(l)].next) {
                const Link& link = links_[static_cast<std::size_t>(l)];
                const ContactRow& other = rows[static_cast<std::size_t>(link.row)];
                matrix.at(k, link.row) += other.share[static_cast<std::size_t>(link.slot)] *
                                          (gx * other.normal[0] + gy * other.normal[1]);
            }
        }
    }
    for (const ContactRow& row : rows)
        for (const std::int32_t node : row.node) head_[static_cast<std::size_t>(node)] = -1;
}

}  // namespace percuss
