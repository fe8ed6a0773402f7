#include "contact/joint/coupling.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace percuss {
namespace {

/// Rows at hole rims depend on each other; this part more on the diagonal makes the matrix definite and
/// shares the force among them. It leaves that part of a step's closing to the next step, far above the
/// rounding of the solution.
constexpr double regularisation = 1e-8;

/// A node is split off only where what is left moves each row by this part of the whole at least: held nodes
/// on a free side would leave nothing but the regularisation.
constexpr double left_to_rows = 1e-3;

}  // namespace

Coupling::Coupling(std::int32_t node_count, std::span<const std::int32_t> fixed)
    : fixed_(static_cast<std::size_t>(node_count), 0),
      sharing_(static_cast<std::size_t>(node_count), 0),
      nodes_begin_{0},
      head_(static_cast<std::size_t>(node_count), -1) {
    for (const std::int32_t node : fixed) fixed_[static_cast<std::size_t>(node)] = 1;
}

void Coupling::split_off(bool splits) {
    if (splits == splits_) return;
    splits_ = splits;
    nodes_.clear();
    nodes_begin_.clear();  // no row has the nodes that it had
}

void Coupling::reserve(std::size_t rows, std::size_t terms) {
    nodes_.reserve(terms);
    nodes_begin_.reserve(rows + 1);
    links_.reserve(terms);
    order_.reserve(rows);
    breadth_first_.reserve(rows);
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
    const bool same = same_nodes(rows, chosen);
    if (splits_ && (!same || !split_.empty())) find_motions(rows, chosen, inverse_mass);
    if (!same || !all_moved_enough()) {
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
    for (const std::int32_t k : order_) {
        if (k < 0) continue;
        const ContactRow& row = rows[static_cast<std::size_t>(chosen[static_cast<std::size_t>(k)])];
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
    if (split_.empty()) return;
    for (std::size_t place = 0; place < places(); ++place) {
        const auto k = static_cast<std::int32_t>(place);
        if (!has_row(place)) matrix_.at(k, k) = -1;
    }
    for (const Motion& motion : motions_) {
        const std::size_t d = motion.direction;
        const double share = share_[static_cast<std::size_t>(motion.term)][d] *
                             std::sqrt(factor * inverse_mass[2 * static_cast<std::size_t>(motion.node) + d]);
        values[static_cast<std::size_t>(motion.entry)] = share;
        values[static_cast<std::size_t>(motion.diagonal)] += regularisation * share * share;
    }
}

template <class Visit>
void Coupling::for_links(std::int32_t node, const Visit& visit) const {
    for (std::int32_t l = head_[static_cast<std::size_t>(node)]; l >= 0;) {
        const Link& link = links_[static_cast<std::size_t>(l)];
        visit(link);
        l = link.next;
    }
}

/// Links the nodes to the places of their rows in an order.
void Coupling::link(std::span<const std::int32_t> order) {
    for (const std::int32_t node : nodes_) head_[static_cast<std::size_t>(node)] = -1;
    links_.clear();
    std::int32_t term = 0;
    for (std::size_t place = 0; place < order.size(); ++place) {
        if (order[place] < 0) continue;
        for (const std::int32_t node : nodes_of(order[place])) {
            const std::int32_t at = term++;
            if (fixed_[static_cast<std::size_t>(node)]) continue;
            std::int32_t& head = head_[static_cast<std::size_t>(node)];
            links_.push_back({static_cast<std::int32_t>(place), at, head});
            head = static_cast<std::int32_t>(links_.size()) - 1;
        }
    }
}

void Coupling::restructure() {
    order_.resize(nodes_begin_.size() - 1);
    std::iota(order_.begin(), order_.end(), 0);
    link(order_);
    find_split();
    sort_into_groups();
    if (!split_.empty()) insert_split();
    link(order_);
    lay_out();
    for (const std::int32_t node : nodes_) head_[static_cast<std::size_t>(node)] = -1;
    share_.resize(nodes_.size());
    unit_.resize(nodes_.size());
}

void Coupling::find_motions(const RowSpan& rows, std::span<const std::int32_t> chosen,
                            const double* inverse_mass) {
    motion_.clear();
    for (const std::int32_t k : chosen)
        for (const RowTerm& term : rows.terms(rows[static_cast<std::size_t>(k)])) {
            const double* inverse = inverse_mass + 2 * term.node;
            motion_.push_back(inverse[0] * term.g[0] * term.g[0] + inverse[1] * term.g[1] * term.g[1]);
        }
}

/// Whether a row moves by its own nodes, without those that are split off.
bool Coupling::moved_enough(std::int32_t row) const {
    const auto first = static_cast<std::size_t>(nodes_begin_[static_cast<std::size_t>(row)]);
    const auto nodes = nodes_of(row);
    double own = 0, all = 0;
    for (std::size_t k = 0; k < nodes.size(); ++k) {
        all += motion_[first + k];
        if (!is_split(nodes[k])) own += motion_[first + k];
    }
    return own >= left_to_rows * all;
}

bool Coupling::all_moved_enough() const {
    if (split_.empty()) return true;
    const auto rows = static_cast<std::int32_t>(nodes_begin_.size()) - 1;
    for (std::int32_t row = 0; row < rows; ++row)
        if (!moved_enough(row)) return false;
    return true;
}

/// Nodes of many rows, each of which moves without them.
void Coupling::find_split() {
    for (const Split& split : split_) sharing_[static_cast<std::size_t>(split.node)] = 0;
    split_.clear();
    if (!splits_ || links_.size() <= static_cast<std::size_t>(most_sharing)) return;
    for (const std::int32_t node : nodes_) {
        if (is_split(node)) continue;
        std::int32_t sharing = 0;
        for_links(node, [&](const Link&) { ++sharing; });
        if (sharing <= most_sharing) continue;
        sharing_[static_cast<std::size_t>(node)] = sharing;
        split_.push_back({0, node});
    }
    if (split_.empty()) return;
    for (const std::int32_t row : order_)
        if (!moved_enough(row))
            for (const std::int32_t node : nodes_of(row)) sharing_[static_cast<std::size_t>(node)] = 0;
    std::erase_if(split_, [&](const Split& split) { return !is_split(split.node); });
}

/// On to what shares only a node that is split off when there is nothing nearer.
void Coupling::sort_into_groups() {
    waiting_.clear();
    const auto neighbours = [this](std::int32_t row, const auto& take) {
        for (const std::int32_t node : nodes_of(row)) {
            std::int32_t& sharing = sharing_[static_cast<std::size_t>(node)];
            if (sharing == 0) for_links(node, [&](const Link& link) { take(link.place); });
            if (sharing > 0) {
                waiting_.push_back(head_[static_cast<std::size_t>(node)]);
                sharing = -sharing;  // it waits once
            }
        }
    };
    const auto take_waiting = [this](const auto& take) {
        while (!waiting_.empty()) {
            std::int32_t& l = waiting_.front();
            while (l >= 0) {
                const Link& link = links_[static_cast<std::size_t>(l)];
                l = link.next;
                if (take(link.place)) return;
            }
            waiting_.erase(waiting_.begin());
        }
    };
    breadth_first_.sort(nodes_begin_.size() - 1, neighbours, take_waiting);
    order_ = breadth_first_.order();
    groups_ = breadth_first_.groups();
}

/// Makes two places for each node that is split off, one a direction, behind the last of its rows.
void Coupling::insert_split() {
    const std::vector<std::int32_t>& sorted = breadth_first_.order();
    std::vector<std::int32_t>& place_of = waiting_;
    place_of.resize(sorted.size());
    for (std::size_t place = 0; place < sorted.size(); ++place)
        place_of[static_cast<std::size_t>(sorted[place])] = static_cast<std::int32_t>(place);
    for (Split& split : split_)
        for_links(split.node, [&](const Link& link) {
            split.last = std::max(split.last, place_of[static_cast<std::size_t>(link.place)]);
        });
    std::sort(split_.begin(), split_.end(), [](const Split& a, const Split& b) {
        return a.last != b.last ? a.last < b.last : a.node < b.node;
    });
    order_.clear();
    auto split = split_.begin();
    for (Group& group : groups_) {
        const auto begin = static_cast<std::int32_t>(order_.size());
        for (std::int32_t place = group.begin; place < group.end; ++place) {
            order_.push_back(sorted[static_cast<std::size_t>(place)]);
            for (; split != split_.end() && split->last == place; ++split) order_.insert(order_.end(), 2, -1);
        }
        group = {begin, static_cast<std::int32_t>(order_.size())};
    }
}

/// Makes the rows of the matrix, and notes which products go where.
void Coupling::lay_out() {
    matrix_.clear();
    products_.clear();
    motions_.clear();
    std::int32_t first_term = 0;
    std::size_t split = 0;
    for (std::int32_t place = 0; place < static_cast<std::int32_t>(places()); ++place) {
        if (!has_row(static_cast<std::size_t>(place))) {
            lay_out_split(split_[split++].node, place);
            ++place;
            continue;
        }
        const auto nodes = nodes_of(order_[static_cast<std::size_t>(place)]);
        const auto each_link = [&](auto visit) {
            for (std::size_t slot = 0; slot < nodes.size(); ++slot) {
                if (is_split(nodes[slot])) continue;
                for_links(nodes[slot], [&](const Link& link) {
                    if (link.place <= place) visit(first_term + static_cast<std::int32_t>(slot), link);
                });
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
}

/// The two places of a node that is split off.
void Coupling::lay_out_split(std::int32_t node, std::int32_t place) {
    std::int32_t first = place;
    for_links(node, [&](const Link& link) { first = std::min(first, link.place); });
    for (const std::size_t direction : {std::size_t{0}, std::size_t{1}}) {
        const std::int32_t row = place + static_cast<std::int32_t>(direction);
        matrix_.append_row(first);
        for_links(node, [&](const Link& link) {
            motions_.push_back({matrix_.index(row, link.place), matrix_.index(link.place, link.place),
                                link.term, node, direction});
        });
    }
}

}  // namespace percuss
