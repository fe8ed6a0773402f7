#include "contact/assembly.hpp"

#include <algorithm>

namespace percuss {

void ContactAssembly::assemble(std::span<const ContactRow> rows, const double* inverse_mass, double factor,
                               ProfileMatrix& matrix) {
    matrix.clear();
    links_.clear();
    const auto newest_link = [this](std::int32_t node) -> std::int32_t& {
        return head_[static_cast<std::size_t>(node)];
    };
    const auto link = [this](std::int32_t l) -> const Link& { return links_[static_cast<std::size_t>(l)]; };
    for (std::int32_t k = 0; k < static_cast<std::int32_t>(rows.size()); ++k) {
        const ContactRow& row = rows[static_cast<std::size_t>(k)];
        std::int32_t first = k;
        for (const std::int32_t node : row.node)
            for (std::int32_t l = newest_link(node); l >= 0; l = link(l).next)
                first = std::min(first, link(l).row);
        matrix.append_row(first);
        double* entry = matrix.row(k);
        double diagonal = 0;
        for (std::size_t slot = 0; slot < 3; ++slot) {
            const std::int32_t node = row.node[slot];
            // What a unit force of this row makes the node move, and how much of that another row sees.
            const double ux = factor * row.share[slot] * row.normal[0] * inverse_mass[2 * node];
            const double uy = factor * row.share[slot] * row.normal[1] * inverse_mass[2 * node + 1];
            diagonal += row.share[slot] * (ux * row.normal[0] + uy * row.normal[1]);
            for (std::int32_t l = newest_link(node); l >= 0; l = link(l).next) {
                const ContactRow& other = rows[static_cast<std::size_t>(link(l).row)];
                entry[link(l).row] += link(l).share * (ux * other.normal[0] + uy * other.normal[1]);
            }
        }
        entry[k] = diagonal;
        for (std::size_t slot = 0; slot < 3; ++slot) {
            // A node that cannot move couples no rows: all rows on one wall share its two.
            const std::int32_t node = row.node[slot];
            if (inverse_mass[2 * node] == 0 && inverse_mass[2 * node + 1] == 0) continue;
            std::int32_t& head = newest_link(node);
            links_.push_back({k, head, row.share[slot]});
            head = static_cast<std::int32_t>(links_.size()) - 1;
        }
    }
    for (const ContactRow& row : rows)
        for (const std::int32_t node : row.node) newest_link(node) = -1;
}

}  // namespace percuss
