#include "contact/joint/coupling.hpp"

#include <algorithm>

namespace percuss {
namespace {

/// Rows at hole rims depend on each other; this part more on the diagonal makes the matrix definite and
/// shares the force among them. It leaves that part of a step's closing to the next step, far above the
/// rounding of the solution.
constexpr double regularisation = 1e-8;

}  // namespace

Coupling::Coupling(std::int32_t node_count, std::span<const std::int32_t> fixed)
    : fixed_(static_cast<std::size_t>(node_count), 0), head_(static_cast<std::size_t>(node_count), -1) {
    for (const std::int32_t node : fixed) fixed_[static_cast<std::size_t>(node)] = 1;
}

void Coupling::reserve(std::size_t rows) {
    nodes_.reserve(rows);
    links_.reserve(3 * rows);
    order_.reserve(rows);
    seen_.reserve(rows);
    groups_.reserve(rows);
    products_.reserve(32 * rows);
    share_.reserve(3 * rows);
    unit_.reserve(3 * rows);
    matrix_.reserve(rows, 32 * rows);
}

bool Coupling::same_nodes(std::span<const ContactRow> rows, std::span<const std::int32_t> chosen) const {
    if (nodes_.size() != chosen.size()) return false;
    for (std::size_t k = 0; k < chosen.size(); ++k)
        if (nodes_[k] != rows[static_cast<std::size_t>(chosen[k])].node) return false;
    return true;
}

void Coupling::assemble(std::span<const ContactRow> rows, std::span<const std::int32_t> chosen,
                        const double* inverse_mass, double factor) {
    if (!same_nodes(rows, chosen)) {
        nodes_.clear();
        for (const std::int32_t k : chosen) nodes_.push_back(rows[static_cast<std::size_t>(k)].node);
        restructure();
    }
    for (std::size_t place = 0; place < order_.size(); ++place) {
        const ContactRow& row =
            rows[static_cast<std::size_t>(chosen[static_cast<std::size_t>(order_[place])])];
        for (std::size_t slot = 0; slot < 3; ++slot) {
            const double* inverse = inverse_mass + 2 * row.node[slot];
            const double x = row.share[slot] * row.normal[0], y = row.share[slot] * row.normal[1];
            share_[3 * place + slot] = {x, y};
            unit_[3 * place + slot] = {factor * inverse[0] * x, factor * inverse[1] * y};
        }
    }
    const std::span<double> values = matrix_.values();
    std::fill(values.begin(), values.end(), 0.0);
    for (const Product& product : products_) {
        const auto& u = unit_[static_cast<std::size_t>(product.unit)];
        const auto& s = share_[static_cast<std::size_t>(product.share)];
        values[static_cast<std::size_t>(product.entry)] += u[0] * s[0] + u[1] * s[1];
    }
    for (std::int32_t k = 0; k < matrix_.rows(); ++k) matrix_.at(k, k) *= 1 + regularisation;
}

void Coupling::sort_into_groups() {
    order_.clear();
    groups_.clear();
    seen_.assign(nodes_.size(), 0);
    const auto take = [this](std::int32_t row) {
        if (seen_[static_cast<std::size_t>(row)]) return;
        seen_[static_cast<std::size_t>(row)] = 1;
        order_.push_back(row);
    };
    for (std::int32_t start = 0; start < static_cast<std::int32_t>(nodes_.size()); ++start) {
        if (seen_[static_cast<std::size_t>(start)]) continue;
        const auto begin = static_cast<std::int32_t>(order_.size());
        take(start);
        for (auto at = static_cast<std::size_t>(begin); at < order_.size(); ++at)
            for (const std::int32_t node : nodes_[static_cast<std::size_t>(order_[at])])
                for (std::int32_t l = head_[static_cast<std::size_t>(node)]; l >= 0;
                     l = links_[static_cast<std::size_t>(l)].next)
                    take(links_[static_cast<std::size_t>(l)].place);
        groups_.push_back({begin, static_cast<std::int32_t>(order_.size())});
    }
}

void Coupling::restructure() {
    const auto link_rows = [&](auto row_at) {
        links_.clear();
        for (std::int32_t place = 0; place < static_cast<std::int32_t>(nodes_.size()); ++place) {
            const auto& nodes = nodes_[static_cast<std::size_t>(row_at(place))];
            for (std::int32_t slot = 0; slot < 3; ++slot) {
                const std::int32_t node = nodes[static_cast<std::size_t>(slot)];
                if (fixed_[static_cast<std::size_t>(node)]) continue;
                std::int32_t& head = head_[static_cast<std::size_t>(node)];
                links_.push_back({place, slot, head});
                head = static_cast<std::int32_t>(links_.size()) - 1;
            }
        }
    };
    const auto unlink = [this] {
        for (const auto& nodes : nodes_)
            for (const std::int32_t node : nodes) head_[static_cast<std::size_t>(node)] = -1;
    };
    link_rows([](std::int32_t row) { return row; });
    sort_into_groups();
    unlink();

    link_rows([this](std::int32_t place) { return order_[static_cast<std::size_t>(place)]; });
    matrix_.clear();
    products_.clear();
    for (std::int32_t place = 0; place < static_cast<std::int32_t>(order_.size()); ++place) {
        const auto& nodes = nodes_[static_cast<std::size_t>(order_[static_cast<std::size_t>(place)])];
        const auto each_link = [&](auto visit) {
            for (std::int32_t slot = 0; slot < 3; ++slot) {
                std::int32_t l = head_[static_cast<std::size_t>(nodes[static_cast<std::size_t>(slot)])];
                for (; l >= 0; l = links_[static_cast<std::size_t>(l)].next)
                    if (links_[static_cast<std::size_t>(l)].place <= place)
                        visit(slot, links_[static_cast<std::size_t>(l)]);
            }
        };
        std::int32_t first = place;
        each_link([&](std::int32_t, const Link& link) { first = std::min(first, link.place); });
        matrix_.append_row(first);
        each_link([&](std::int32_t slot, const Link& link) {
            products_.push_back(
                {matrix_.index(place, link.place), 3 * place + slot, 3 * link.place + link.slot});
        });
    }
    unlink();
    share_.resize(3 * nodes_.size());
    unit_.resize(3 * nodes_.size());
}

}  // namespace percuss
