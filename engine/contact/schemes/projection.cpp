#include "contact/schemes/projection.hpp"

#include <algorithm>
#include <utility>

#include "dynamics/double2.hpp"

namespace percuss {

Projection::Projection(PenetrationSearch search, ContactSign sign, std::int32_t node_count)
    : search_(std::move(search)), sign_(sign), assembly_(node_count) {
    // No step allocates, the first contact included.
    const std::size_t most = search_.master().nodes.size();
    rows_.reserve(most, 3 * most);
    assembly_.reserve(3 * most);
    matrix_.reserve(most, 4 * most);
    cholesky_.reserve(most, 4 * most);
    penetration_.reserve(most);
    force_.reserve(most);
    active_.reserve(most);
}

void Projection::find(const PredictedMotion& motion) { search_.find(motion.nodes, motion.dt, rows_); }

void Projection::resolve(PredictedMotion& motion) {
    negative_ = 0;
    if (rows_.empty()) return;
    solve_forces(motion);
    for (const ContactRow& row : rows_) {
        correct(row, motion);
        for (const RowTerm& term : rows_.terms(row)) motion.touched->push_back(term.node);
    }
}

void Projection::solve_forces(const PredictedMotion& motion) {
    assembly_.assemble(rows_.all(), motion.inverse_mass, motion.dt * motion.kick, matrix_);
    penetration_.resize(rows_.size());
    for (std::size_t k = 0; k < rows_.size(); ++k) penetration_[k] = rows_[k].penetration;
    active_.assign(rows_.size(), 1);
    force_ = penetration_;
    const int dependent = cholesky_.factorise(matrix_, active_);
    cholesky_.solve(force_);
    for (const double c : force_) negative_ += c < 0;
    if (sign_ == ContactSign::restricted && (negative_ > 0 || dependent > 0)) {
        for (std::size_t k = 0; k < rows_.size(); ++k) active_[k] = force_[k] >= 0;
        bounded_.solve(matrix_, penetration_, active_, force_);
    }
    for (std::size_t k = 0; k < rows_.size(); ++k) rows_[k].force = force_[k];
}

void Projection::correct(const ContactRow& row, PredictedMotion& motion) const {
    const double impulse = motion.kick * row.force;
    for (const RowTerm& term : rows_.terms(row)) {
        const auto node = static_cast<std::size_t>(term.node);
        const Double2 share = impulse * load_pair(term.g.data());
        const Double2 change = load_pair(motion.inverse_mass + 2 * node) * share;
        double* const received = motion.impulse + 2 * node;
        store_pair(received, load_pair(received) + share);
        Node& moved = motion.nodes[node];
        store_pair(moved.v, load_pair(moved.v) + change);
        store_pair(moved.x, load_pair(moved.x) + motion.dt * change);
    }
}

double Projection::penetration_left(const Node* nodes) const {
    double deepest = 0;
    for (const ContactRow& row : rows_) deepest = std::max(deepest, search_.penetration(nodes, row));
    return deepest;
}

void Projection::forget() {
    search_.forget();
    rows_.clear();
}

}  // namespace percuss
