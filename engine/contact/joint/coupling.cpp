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
    : fixed_(static_cast<std::size_t>(node_count), 0),
      nodes_begin_{0},
      head_(static_cast<std::size_t>(node_count), -1) {
    for (const std::int32_t node : fixed) fixed_[static_cast<std::size_t>(node)] = 1;
}

void Coupling::reserve(std::size_t rows, std::size_t terms) {
    nodes_.reserve(terms);
    nodes_begin_.reserve(rows + 1);
    links_.reserve(terms);
    order_.reserve(rows);
    seen_.reserve(rows);
    groups_.reserve(rows);
    products_.reserve(12 * terms);
    share_.reserve(terms);
    unit_.reserve(terms);
    matrix_.reserve(rows, 32 * rows);
}

std::span<const std::int32_t> Coupling::nodes_of(std::int32_t chosen) const {
    const auto k = static_cast<std::size_t>(chosen);
    const auto begin = static_cast<std::size_t>(nodes_begin_[k]),
               end = static_cast<std::size_t>(nodes_begin_[k + 1]);
    return std::span(nodes_).subspan(begin, end - begin);
}

bool Coupling::same_nodes(const RowSpan& rows, std::span<const std::int32_t> chosen) const {
    if (nodes_begin_.size() != chosen.size() + 1) return false;
    std::size_t at = 0;
    for (std::size_t k = 0; k < chosen.size(); ++k) {
        for (const RowTerm& term : rows.terms(rows[static_cast<std::size_t>(chosen[k])]))
            if (at == nodes_.size() || nodes_[at++] != term.node) return false;
        if (at != static_cast<std::size_t>(nodes_begin_[k + 1])) return false;
    }
    return true;
}

void Coupling::assemble(const RowSpan& rows, std::span<const std::int32_t> chosen, const double* inverse_mass,
                        double factor) {
    if (!same_nodes(rows, chosen)) {
        nodes_.clear();
        nodes_begin_.assign(1, 0);
        for (const std::int32_t k : chosen) {
            for (const RowTerm& term : rows.terms(rows[static_cast<std::size_t>(k)]))
                nodes_.push_back(term.node);
            nodes_begin_.push_back(static_cast<std::int32_t>(nodes_.size()));
        }
        restructure();
    }
    std::size_t at = 0;
    for (const std::int32_t place : order_) {
        const ContactRow& row = rows[static_cast<std::size_t>(chosen[static_cast<std::size_t>(place)])];
        for (const RowTerm& term : rows.terms(row)) {
            const double* inverse = inverse_mass + 2 * term.node;
            share_[at] = term.g;
            unit_[at++] = {factor * inverse[0] * term.g[0], factor * inverse[1] * term.g[1]};
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
    const auto rows = static_cast<std::int32_t>(nodes_begin_.size()) - 1;
    order_.clear();
    groups_.clear();
    seen_.assign(static_cast<std::size_t>(rows), 0);
    const auto take = [this](std::int32_t row) {
        if (seen_[static_cast<std::size_t>(row)]) return;
        seen_[static_cast<std::size_t>(row)] = 1;
        order_.push_back(row);
    };
    for (std::int32_t start = 0; start < rows; ++start) {
        if (seen_[static_cast<std::size_t>(start)]) continue;
        const auto begin = static_cast<std::int32_t>(order_.size());
        take(start);
        for (auto at = static_cast<std::size_t>(begin); at < order_.size(); ++at)
            for (const std::int32_t node : nodes_of(order_[at]))
                for (std::int32_t l = head_[static_cast<std::size_t>(node)]; l >= 0;
                     l = links_[static_cast<std::size_t>(l)].next)
                    take(links_[static_cast<std::size_t>(l)].place);
        groups_.push_back({begin, static_cast<std::int32_t>(order_.size())});
    }
}

void Coupling::restructure() {
    const auto rows = static_cast<std::int32_t>(nodes_begin_.size()) - 1;
    const auto link_rows = [&](auto row_at) {
        links_.clear();
        std::int32_t at = 0;
        for (std::int32_t place = 0; place < rows; ++place) {
            for (const std::int32_t node : nodes_of(row_at(place))) {
                const std::int32_t term = at++;
                if (fixed_[static_cast<std::size_t>(node)]) continue;
                std::int32_t& head = head_[static_cast<std::size_t>(node)];
                links_.push_back({place, term, head});
                head = static_cast<std::int32_t>(links_.size()) - 1;
            }
        }
    };
    const auto unlink = [this] {
        for (const std::int32_t node : nodes_) head_[static_cast<std::size_t>(node)] = -1;
    };
    link_rows([](std::int32_t row) { return row; });
    sort_into_groups();
    unlink();

    link_rows([this](std::int32_t place) { return order_[static_cast<std::size_t>(place)]; });
    matrix_.clear();
    products_.clear();
    std::int32_t first_term = 0;
    for (std::int32_t place = 0; place < rows; ++place) {
        const auto nodes = nodes_of(order_[static_cast<std::size_t>(place)]);
        const auto each_link = [&](auto visit) {
            for (std::size_t slot = 0; slot < nodes.size(); ++slot) {
                std::int32_t l = head_[static_cast<std::size_t>(nodes[slot])];
                for (; l >= 0; l = links_[static_cast<std::size_t>(l)].next)
                    if (links_[static_cast<std::size_t>(l)].place <= place)
                        visit(first_term + static_cast<std::int32_t>(slot),
                              links_[static_cast<std::size_t>(l)]);
            }
        };
        std::int32_t first = place;
        each_link([&](std::int32_t, const Link& link) { first = std::min(first, link.place); });
        matrix_.append_row(first);
        each_link([&](std::int32_t term, const Link& link) {
            products_.push_back({matrix_.index(place, link.place), term, link.term});
        });
        first_term += static_cast<std::int32_t>(nodes.size());
    }
    unlink();
    share_.resize(nodes_.size());
    unit_.resize(nodes_.size());
}

}  // namespace percuss
