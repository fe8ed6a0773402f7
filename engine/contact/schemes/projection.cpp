#include "contact/schemes/projection.hpp"

#include <algorithm>
#include <utility>

namespace percuss {

Projection::Projection(PenetrationSearch search, ContactSign sign, std::int32_t node_count)
    : search_(std::move(search)), sign_(sign), assembly_(node_count) {}

void Projection::find(const PredictedMotion& motion) { search_.find(motion.nodes, motion.dt, rows_); }

void Projection::resolve(PredictedMotion& motion) {
    negative_ = 0;
    if (rows_.empty()) return;
    solve_forces(motion);
    for (const ContactRow& row : rows_) correct(row, motion);
}

void Projection::solve_forces(const PredictedMotion& motion) {
    assembly_.assemble(rows_, motion.inverse_mass, motion.dt * motion.kick, matrix_);
    penetration_.resize(rows_.size());
    for (std::size_t k = 0; k < rows_.size(); ++k) penetration_[k] = rows_[k].penetration;
    active_.assign(rows_.size(), 1);
    force_ = penetration_;
    const int dependent = cholesky_.factorise(matrix_, active_);
    cholesky_.solve(force_);
    for (const double c : force_) negative_ += c < 0;
    if (sign_ == ContactSign::restricted && (negative_ > 0 || dependent > 0)) {
        for (std::size_t k = 0; k < rows_.size(); ++k) active_[k] = force_[k] >= 0;
        nonnegative_.solve(matrix_, penetration_, active_, force_);
    }
    for (std::size_t k = 0; k < rows_.size(); ++k) rows_[k].force = force_[k];
}

void Projection::correct(const ContactRow& row, PredictedMotion& motion) const {
    const double impulse = motion.kick * row.force;
    for (std::size_t k = 0; k < 3; ++k) {
        const auto node = static_cast<std::size_t>(row.node[k]);
        motion.touched->push_back(row.node[k]);
        for (std::size_t d = 0; d < 2; ++d) {
            const double share = impulse * row.share[k] * row.normal[d];
            const double change = motion.inverse_mass[2 * node + d] * share;
            motion.impulse[2 * node + d] += share;
            motion.nodes[node].v[d] += change;
            motion.nodes[node].x[d] += motion.dt * change;
        }
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
