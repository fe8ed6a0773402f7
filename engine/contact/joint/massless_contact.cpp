#include "contact/joint/massless_contact.hpp"

#include <algorithm>
#include <cmath>

namespace percuss {
namespace {

/// Part of its own compliance that a row gives way by, so that rows which depend on each other share a force.
constexpr double regularisation = 1e-8;

}  // namespace

MasslessContact::MasslessContact(const Scene& scene, const Mesh& mesh)
    : JointContact(scene, mesh),
      layer_(scene, mesh),
      acting_of_(scene.contacts.size(), {0, 0}),
      contact_(static_cast<std::size_t>(layer_.unknowns()), 0),
      imbalance_(contact_.size(), 0),
      moved_(contact_.size(), 0),
      place_of_unknown_(contact_.size(), -1) {
    solver_.never_relax();
}

void MasslessContact::restart(const std::vector<std::vector<std::int32_t>>& active) {
    JointContact::restart(active);
    acting_.clear();
    std::fill(acting_of_.begin(), acting_of_.end(), std::array<std::size_t, 2>{0, 0});
    std::fill(contact_.begin(), contact_.end(), 0.0);
}

void MasslessContact::resolve(PredictedMotion& motion, RunStatistics& statistics) {
    acting_ = rows_;
    for (std::size_t p = 0; p < acting_of_.size(); ++p) acting_of_[p] = {rows_begin(p), rows_end(p)};
    let_forces_act(motion);
    layer_.find_stiffness(motion.nodes, motion.dt);
    find_imbalance(motion);
    JointContact::resolve(motion, statistics);
}

/// Contact forces on what has mass, or is held, and what does not balance in the layer: its carriers take
/// that.
void MasslessContact::let_forces_act(PredictedMotion& motion) {
    const auto push = [&](std::int32_t node, std::size_t d, double force) {
        const std::size_t k = 2 * static_cast<std::size_t>(node) + d;
        const double impulse = motion.kick * force, change = motion.inverse_mass[k] * impulse;
        motion.impulse[k] += impulse;
        motion.nodes[node].v[d] += change;
        motion.nodes[node].x[d] += motion.dt * change;
        motion.touched->push_back(node);
    };
    const RowSpan rows = acting_.all();
    for (const ContactRow& row : rows) {
        if (row.force == 0) continue;
        for (const RowTerm& term : rows.terms(row)) {
            const std::int32_t at = layer_.index_of(term.node);
            for (std::size_t d = 0; d < 2; ++d)
                if (at < 0 || layer_.nodes()[static_cast<std::size_t>(at)].unknown[d] < 0)
                    push(term.node, d, row.force * term.g[d]);
        }
    }
    for (const MasslessLayer::LayerNode& of : layer_.nodes()) {
        const auto carriers = layer_.carriers_of(of);
        for (std::size_t d = 0; d < 2; ++d) {
            if (of.unknown[d] < 0) continue;
            const std::size_t k = 2 * static_cast<std::size_t>(of.node) + d;
            const double load = motion.forces->external ? motion.forces->external[k] : 0;
            const double left =
                contact_[static_cast<std::size_t>(of.unknown[d])] + load - motion.forces->internal[k];
            for (const std::int32_t carrier : carriers)
                push(carrier, d, left / static_cast<double>(carriers.size()));
        }
    }
}

void MasslessContact::find_imbalance(const PredictedMotion& motion) {
    for (const MasslessLayer::LayerNode& of : layer_.nodes()) {
        for (std::size_t d = 0; d < 2; ++d) {
            if (of.unknown[d] < 0) continue;
            const std::size_t k = 2 * static_cast<std::size_t>(of.node) + d;
            imbalance_[static_cast<std::size_t>(of.unknown[d])] =
                motion.forces->internal[k] - (motion.forces->external ? motion.forces->external[k] : 0);
        }
    }
    for (const MasslessLayer::LayerCell& cell : layer_.cells()) {
        Eigen::Matrix<double, 8, 1> u = Eigen::Matrix<double, 8, 1>::Zero();
        for (int i = 0; i < corner_count(cell.corners); ++i)
            for (int d = 0; d < 2; ++d)
                u(2 * i + d) = motion.dt * motion.nodes[cell.corners[static_cast<std::size_t>(i)]].v[d];
        const Eigen::Matrix<double, 8, 1> force = cell.stiffness * u;
        for (int i = 0; i < corner_count(cell.corners); ++i) {
            const std::int32_t at = layer_.index_of(cell.corners[static_cast<std::size_t>(i)]);
            if (at < 0) continue;
            for (int d = 0; d < 2; ++d) {
                const std::int32_t unknown =
                    layer_.nodes()[static_cast<std::size_t>(at)].unknown[static_cast<std::size_t>(d)];
                if (unknown >= 0) imbalance_[static_cast<std::size_t>(unknown)] += force(2 * i + d);
            }
        }
    }
}

bool MasslessContact::same_nodes() {
    std::vector<std::int32_t> nodes, begin{0};
    for (const std::int32_t k : chosen_) {
        for (const RowTerm& term : rows_.terms(rows_[static_cast<std::size_t>(k)]))
            if (const std::int32_t at = layer_.index_of(term.node); at >= 0) nodes.push_back(at);
        begin.push_back(static_cast<std::int32_t>(nodes.size()));
    }
    const bool same = !groups_.empty() && nodes == row_nodes_ && begin == row_nodes_begin_;
    row_nodes_ = std::move(nodes);
    row_nodes_begin_ = std::move(begin);
    return same;
}

/// Unknowns of the layer breadth first, over cells and rows, each row behind the last of its nodes.
void MasslessContact::lay_out() {
    const auto& nodes = layer_.nodes();
    const std::size_t rows = chosen_.size();
    std::vector<std::vector<std::int32_t>> rows_at(nodes.size());
    for (std::size_t r = 0; r < rows; ++r)
        for (std::int32_t k = row_nodes_begin_[r]; k < row_nodes_begin_[r + 1]; ++k)
            rows_at[static_cast<std::size_t>(row_nodes_[static_cast<std::size_t>(k)])].push_back(
                static_cast<std::int32_t>(r));
    std::vector<std::int32_t> left(rows), order;
    for (std::size_t r = 0; r < rows; ++r) left[r] = row_nodes_begin_[r + 1] - row_nodes_begin_[r];
    std::vector<char> seen(nodes.size(), 0);
    place_of_row_.assign(rows, -1);
    groups_.clear();
    matrix_.clear();
    std::vector<std::int32_t> first_of;  // per place
    std::int32_t places = 0;
    for (std::size_t start = 0; start < nodes.size(); ++start) {
        if (seen[start]) continue;
        const std::int32_t begin = places;
        order.assign(1, static_cast<std::int32_t>(start));
        seen[start] = 1;
        const auto take = [&](std::int32_t node) {
            if (node < 0 || seen[static_cast<std::size_t>(node)]) return;
            seen[static_cast<std::size_t>(node)] = 1;
            order.push_back(node);
        };
        for (std::size_t at = 0; at < order.size(); ++at) {
            const auto n = static_cast<std::size_t>(order[at]);
            for (const std::int32_t c : layer_.cells_of(nodes[n]))
                for (const std::int32_t corner : layer_.cells()[static_cast<std::size_t>(c)].corners)
                    if (corner >= 0) take(layer_.index_of(corner));
            for (const std::int32_t r : rows_at[n])
                for (std::int32_t k = row_nodes_begin_[static_cast<std::size_t>(r)];
                     k < row_nodes_begin_[static_cast<std::size_t>(r) + 1]; ++k)
                    take(row_nodes_[static_cast<std::size_t>(k)]);
            for (const std::int32_t unknown : nodes[n].unknown)
                if (unknown >= 0) place_of_unknown_[static_cast<std::size_t>(unknown)] = places++;
            for (const std::int32_t r : rows_at[n])
                if (--left[static_cast<std::size_t>(r)] == 0)
                    place_of_row_[static_cast<std::size_t>(r)] = places++;
        }
        groups_.push_back({begin, places});
    }
    first_of.resize(static_cast<std::size_t>(places));
    const auto reach = [&](std::int32_t place, std::int32_t to) {
        auto& first = first_of[static_cast<std::size_t>(place)];
        first = std::min(first, to);
    };
    for (std::int32_t place = 0; place < places; ++place) first_of[static_cast<std::size_t>(place)] = place;
    const auto lowest_place = [&](std::int32_t node) {
        const auto& unknown = nodes[static_cast<std::size_t>(node)].unknown;
        return place_of_unknown_[static_cast<std::size_t>(unknown[0] >= 0 ? unknown[0] : unknown[1])];
    };
    for (const MasslessLayer::LayerNode& of : nodes)
        for (const std::int32_t unknown : of.unknown)
            if (unknown >= 0)
                for (const std::int32_t c : layer_.cells_of(of))
                    for (const std::int32_t corner : layer_.cells()[static_cast<std::size_t>(c)].corners)
                        if (const std::int32_t at = corner < 0 ? -1 : layer_.index_of(corner); at >= 0)
                            reach(place_of_unknown_[static_cast<std::size_t>(unknown)], lowest_place(at));
    for (std::size_t r = 0; r < rows; ++r)
        for (std::int32_t k = row_nodes_begin_[r]; k < row_nodes_begin_[r + 1]; ++k)
            reach(place_of_row_[r], lowest_place(row_nodes_[static_cast<std::size_t>(k)]));
    for (const std::int32_t first : first_of) matrix_.append_row(first);
}

void MasslessContact::assemble_matrix() {
    const std::span<double> values = matrix_.values();
    std::fill(values.begin(), values.end(), 0.0);
    const auto count = static_cast<std::size_t>(matrix_.rows());
    known_.assign(count, 0);
    answer_.assign(count, 0);
    stand_.assign(count, BoundedSolver::between);
    for (std::size_t u = 0; u < imbalance_.size(); ++u)
        known_[static_cast<std::size_t>(place_of_unknown_[u])] = imbalance_[u];
    for (const MasslessLayer::LayerCell& cell : layer_.cells()) {
        std::array<std::int32_t, 8> place;
        place.fill(-1);
        for (std::size_t i = 0; i < static_cast<std::size_t>(corner_count(cell.corners)); ++i) {
            const std::int32_t at = layer_.index_of(cell.corners[i]);
            if (at < 0) continue;
            for (std::size_t d = 0; d < 2; ++d)
                if (const std::int32_t u = layer_.nodes()[static_cast<std::size_t>(at)].unknown[d]; u >= 0)
                    place[2 * i + d] = place_of_unknown_[static_cast<std::size_t>(u)];
        }
        for (std::size_t a = 0; a < 8; ++a)
            for (std::size_t b = 0; b < 8; ++b)
                if (place[a] >= 0 && place[b] >= 0 && place[b] <= place[a])
                    matrix_.at(place[a], place[b]) -=
                        cell.stiffness(static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(b));
    }
    for (std::size_t r = 0; r < chosen_.size(); ++r) {
        const std::int32_t place = place_of_row_[r];
        if (place < 0) continue;  // between nodes that nothing moves
        const auto k = static_cast<std::size_t>(chosen_[r]);
        double compliance = 0;
        for (const RowTerm& term : rows_.terms(rows_[k])) {
            const std::int32_t at = layer_.index_of(term.node);
            if (at < 0) continue;
            for (std::size_t d = 0; d < 2; ++d) {
                const std::int32_t u = layer_.nodes()[static_cast<std::size_t>(at)].unknown[d];
                if (u < 0) continue;
                const std::int32_t column = place_of_unknown_[static_cast<std::size_t>(u)];
                matrix_.at(place, column) += term.g[d];
                compliance -= term.g[d] * term.g[d] / matrix_.at(column, column);
            }
        }
        matrix_.at(place, place) = regularisation * compliance;
        known_[static_cast<std::size_t>(place)] = rows_[k].penetration;
        stand_[static_cast<std::size_t>(place)] = expected(k);
    }
}

void MasslessContact::solve(PredictedMotion&, ContactSolverStatistics& statistics) {
    if (!same_nodes()) lay_out();
    assemble_matrix();
    for (const Coupling::Group& group : groups_) {
        const int rounds = solver_.solve(matrix_, known_, stand_, answer_, group.begin, group.end);
        ++statistics.problems;
        statistics.iterations += rounds;
        statistics.most_iterations = std::max(statistics.most_iterations, rounds);
        statistics.fallbacks += solver_.relaxed();
    }
    const auto rows = static_cast<int>(chosen_.size());
    statistics.rows += rows;
    statistics.most_rows = std::max(statistics.most_rows, rows);
    for (std::size_t r = 0; r < chosen_.size(); ++r) {
        const auto k = static_cast<std::size_t>(chosen_[r]);
        const std::int32_t place = place_of_row_[r];
        rows_[k].force = place < 0 ? 0 : std::max(0.0, answer_[static_cast<std::size_t>(place)]);
        if (place >= 0) expected(k) = stand_[static_cast<std::size_t>(place)];
    }
    for (std::size_t u = 0; u < moved_.size(); ++u)
        moved_[u] = answer_[static_cast<std::size_t>(place_of_unknown_[u])];
}

double MasslessContact::opening(std::span<const RowTerm> terms, const PredictedMotion&) const {
    double sum = 0;
    for (const RowTerm& term : terms) {
        const std::int32_t at = layer_.index_of(term.node);
        if (at < 0) continue;
        for (std::size_t d = 0; d < 2; ++d)
            if (const std::int32_t u = layer_.nodes()[static_cast<std::size_t>(at)].unknown[d]; u >= 0)
                sum += term.g[d] * moved_[static_cast<std::size_t>(u)];
    }
    return sum;
}

double MasslessContact::correct(PredictedMotion& motion) {
    double largest = 0;
    for (const MasslessLayer::LayerNode& of : layer_.nodes()) {
        motion.touched->push_back(of.node);
        Node& node = motion.nodes[of.node];
        double square = 0;
        for (std::size_t d = 0; d < 2; ++d) {
            if (of.unknown[d] < 0) continue;
            const double moved = moved_[static_cast<std::size_t>(of.unknown[d])], change = moved / motion.dt;
            node.x[d] += moved;
            node.v[d] += change;
            motion.moved[2 * static_cast<std::size_t>(of.node) + d] = change;
            square += change * change;
        }
        largest = std::max(largest, square);
    }
    std::fill(contact_.begin(), contact_.end(), 0.0);
    for (const std::int32_t k : chosen_) {
        const ContactRow& row = rows_[static_cast<std::size_t>(k)];
        for (const RowTerm& term : rows_.terms(row)) {
            const std::int32_t at = layer_.index_of(term.node);
            if (at < 0) continue;
            for (std::size_t d = 0; d < 2; ++d)
                if (const std::int32_t u = layer_.nodes()[static_cast<std::size_t>(at)].unknown[d]; u >= 0)
                    contact_[static_cast<std::size_t>(u)] += row.force * term.g[d];
        }
    }
    reach_ = 2 * motion.dt * std::sqrt(largest);
    return std::sqrt(largest);
}

}  // namespace percuss
