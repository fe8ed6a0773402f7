#include "contact/joint/massless_system.hpp"

#include <algorithm>
#include <array>

namespace percuss {
namespace {

/// Part of its own compliance that a row gives way by.
constexpr double regularisation = 1e-8;

/// Room for the profile, as a multiple of that of the layer alone: rows between two surfaces put their bands
/// together.
constexpr std::size_t entries_of_alone = 4;

std::int32_t index(std::size_t k) { return static_cast<std::int32_t>(k); }

}  // namespace

MasslessSystem::MasslessSystem(const MasslessLayer& layer, std::size_t rows, std::size_t terms)
    : place_of_unknown_(static_cast<std::size_t>(layer.unknowns()), -1) {
    const std::size_t nodes = layer.nodes().size(), places = place_of_unknown_.size() + rows;
    for (std::vector<std::int32_t>* of_terms : {&row_nodes_, &next_nodes_, &rows_at_})
        of_terms->reserve(terms);
    for (std::vector<std::int32_t>* of_rows : {&row_nodes_begin_, &next_nodes_begin_, &left_, &place_of_row_})
        of_rows->reserve(rows + 1);
    rows_at_begin_.reserve(nodes + 2);
    first_of_.reserve(places);
    breadth_first_.reserve(nodes);
    groups_.reserve(nodes);
    known_.reserve(places);
    answer_.reserve(places);
    stand_.reserve(places);
    row_nodes_begin_.assign(1, 0);
    lay_out(layer);
    const std::size_t entries = entries_of_alone * matrix_.values().size();
    matrix_.reserve(places, entries);
    solver_.reserve(places, entries);
    solver_.never_relax();
}

void MasslessSystem::assemble(const MasslessLayer& layer, const RowSpan& rows,
                              std::span<const std::int32_t> chosen, std::span<const double> imbalance,
                              std::span<const char> stand) {
    if (!same_nodes(layer, rows, chosen)) lay_out(layer);
    const std::span<double> values = matrix_.values();
    std::fill(values.begin(), values.end(), 0.0);
    const auto count = static_cast<std::size_t>(matrix_.rows());
    known_.assign(count, 0);
    answer_.assign(count, 0);
    stand_.assign(count, BoundedSolver::between);
    for (std::size_t u = 0; u < imbalance.size(); ++u)
        known_[static_cast<std::size_t>(place_of_unknown_[u])] = imbalance[u];
    add_stiffness(layer);
    add_rows(layer, rows, chosen, stand);
}

void MasslessSystem::solve(ContactSolverStatistics& statistics) {
    for (const PlaceGroup& group : groups_) {
        const int rounds = solver_.solve(matrix_, known_, stand_, answer_, group.begin, group.end);
        ++statistics.problems;
        statistics.iterations += rounds;
        statistics.most_iterations = std::max(statistics.most_iterations, rounds);
        statistics.fallbacks += solver_.relaxed();
    }
    const auto rows = static_cast<int>(place_of_row_.size());
    statistics.rows += rows;
    statistics.most_rows = std::max(statistics.most_rows, rows);
}

bool MasslessSystem::same_nodes(const MasslessLayer& layer, const RowSpan& rows,
                                std::span<const std::int32_t> chosen) {
    next_nodes_.clear();
    next_nodes_begin_.assign(1, 0);
    for (const std::int32_t k : chosen) {
        for (const RowTerm& term : rows.terms(rows[static_cast<std::size_t>(k)]))
            if (const std::int32_t at = layer.index_of(term.node); at >= 0) next_nodes_.push_back(at);
        next_nodes_begin_.push_back(index(next_nodes_.size()));
    }
    if (next_nodes_ == row_nodes_ && next_nodes_begin_ == row_nodes_begin_) return true;
    next_nodes_.swap(row_nodes_);
    next_nodes_begin_.swap(row_nodes_begin_);
    return false;
}

std::span<const std::int32_t> MasslessSystem::nodes_of(std::size_t row) const {
    const auto begin = static_cast<std::size_t>(row_nodes_begin_[row]),
               end = static_cast<std::size_t>(row_nodes_begin_[row + 1]);
    return std::span(row_nodes_).subspan(begin, end - begin);
}

std::span<const std::int32_t> MasslessSystem::rows_at(std::size_t node) const {
    const auto begin = static_cast<std::size_t>(rows_at_begin_[node]),
               end = static_cast<std::size_t>(rows_at_begin_[node + 1]);
    return std::span(rows_at_).subspan(begin, end - begin);
}

void MasslessSystem::list_rows_at_nodes(std::size_t nodes) {
    // Counted two places further on, summed up, and moved on by one as they are filled in.
    rows_at_begin_.assign(nodes + 2, 0);
    for (const std::int32_t node : row_nodes_) ++rows_at_begin_[static_cast<std::size_t>(node) + 2];
    for (std::size_t n = 2; n < rows_at_begin_.size(); ++n) rows_at_begin_[n] += rows_at_begin_[n - 1];
    rows_at_.resize(row_nodes_.size());
    for (std::size_t r = 0; r + 1 < row_nodes_begin_.size(); ++r)
        for (const std::int32_t node : nodes_of(r)) {
            std::int32_t& at = rows_at_begin_[static_cast<std::size_t>(node) + 1];
            rows_at_[static_cast<std::size_t>(at++)] = index(r);
        }
}

void MasslessSystem::lay_out(const MasslessLayer& layer) {
    const auto& nodes = layer.nodes();
    list_rows_at_nodes(nodes.size());
    const auto neighbours = [&](std::int32_t thing, const auto& take) {
        const auto node = static_cast<std::size_t>(thing);
        for (const std::int32_t c : layer.cells_of(nodes[node]))
            for (const std::int32_t corner : layer.cells()[static_cast<std::size_t>(c)].corners)
                if (const std::int32_t at = corner < 0 ? -1 : layer.index_of(corner); at >= 0) take(at);
        for (const std::int32_t r : rows_at(node))
            for (const std::int32_t at : nodes_of(static_cast<std::size_t>(r))) take(at);
    };
    breadth_first_.sort(nodes.size(), neighbours, [](const auto&) {});
    give_places(layer);
    make_profile(layer);
}

void MasslessSystem::give_places(const MasslessLayer& layer) {
    const std::size_t rows = row_nodes_begin_.size() - 1;
    left_.resize(rows);
    for (std::size_t r = 0; r < rows; ++r) left_[r] = index(nodes_of(r).size());
    place_of_row_.assign(rows, -1);  // between nodes that nothing moves
    groups_.clear();
    std::int32_t places = 0;
    for (const PlaceGroup& group : breadth_first_.groups()) {
        const std::int32_t begin = places;
        for (std::int32_t at = group.begin; at < group.end; ++at) {
            const auto node = static_cast<std::size_t>(breadth_first_.order()[static_cast<std::size_t>(at)]);
            for (const std::int32_t unknown : layer.nodes()[node].unknown)
                if (unknown >= 0) place_of_unknown_[static_cast<std::size_t>(unknown)] = places++;
            for (const std::int32_t r : rows_at(node))
                if (--left_[static_cast<std::size_t>(r)] == 0)
                    place_of_row_[static_cast<std::size_t>(r)] = places++;
        }
        groups_.push_back({begin, places});
    }
    first_of_.resize(static_cast<std::size_t>(places));
}

void MasslessSystem::make_profile(const MasslessLayer& layer) {
    const auto& nodes = layer.nodes();
    for (std::size_t place = 0; place < first_of_.size(); ++place) first_of_[place] = index(place);
    const auto reach = [&](std::int32_t place, std::int32_t node) {
        const auto& unknown = nodes[static_cast<std::size_t>(node)].unknown;
        const std::int32_t to =
            place_of_unknown_[static_cast<std::size_t>(unknown[0] >= 0 ? unknown[0] : unknown[1])];
        std::int32_t& first = first_of_[static_cast<std::size_t>(place)];
        first = std::min(first, to);
    };
    for (const MasslessLayer::LayerNode& of : nodes)
        for (const std::int32_t unknown : of.unknown)
            if (unknown >= 0)
                for (const std::int32_t c : layer.cells_of(of))
                    for (const std::int32_t corner : layer.cells()[static_cast<std::size_t>(c)].corners)
                        if (const std::int32_t at = corner < 0 ? -1 : layer.index_of(corner); at >= 0)
                            reach(place_of_unknown_[static_cast<std::size_t>(unknown)], at);
    for (std::size_t r = 0; r < place_of_row_.size(); ++r)
        for (const std::int32_t node : nodes_of(r)) reach(place_of_row_[r], node);
    matrix_.clear();
    for (const std::int32_t first : first_of_) matrix_.append_row(first);
}

void MasslessSystem::add_stiffness(const MasslessLayer& layer) {
    for (const MasslessLayer::LayerCell& cell : layer.cells()) {
        std::array<std::int32_t, 8> place;
        place.fill(-1);
        for (std::size_t i = 0; i < static_cast<std::size_t>(corner_count(cell.corners)); ++i)
            for (std::size_t d = 0; d < 2; ++d)
                if (const std::int32_t u = layer.unknown_of(cell.corners[i], d); u >= 0)
                    place[2 * i + d] = place_of_unknown_[static_cast<std::size_t>(u)];
        for (std::size_t a = 0; a < 8; ++a)
            for (std::size_t b = 0; b < 8; ++b)
                if (place[a] >= 0 && place[b] >= 0 && place[b] <= place[a])
                    matrix_.at(place[a], place[b]) -=
                        cell.stiffness(static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(b));
    }
}

void MasslessSystem::add_rows(const MasslessLayer& layer, const RowSpan& rows,
                              std::span<const std::int32_t> chosen, std::span<const char> stand) {
    for (std::size_t r = 0; r < chosen.size(); ++r) {
        const std::int32_t place = place_of_row_[r];
        if (place < 0) continue;
        const auto k = static_cast<std::size_t>(chosen[r]);
        double compliance = 0;
        for (const RowTerm& term : rows.terms(rows[k]))
            for (std::size_t d = 0; d < 2; ++d) {
                const std::int32_t u = layer.unknown_of(term.node, d);
                if (u < 0) continue;
                const std::int32_t column = place_of_unknown_[static_cast<std::size_t>(u)];
                matrix_.at(place, column) += term.g[d];
                compliance -= term.g[d] * term.g[d] / matrix_.at(column, column);
            }
        matrix_.at(place, place) = regularisation * compliance;
        known_[static_cast<std::size_t>(place)] = rows[k].penetration;
        stand_[static_cast<std::size_t>(place)] = stand[k];
    }
}

}  // namespace percuss
