#include "contact/joint/massless_contact.hpp"

#include <algorithm>
#include <cmath>

namespace percuss {

MasslessContact::MasslessContact(const Scene& scene, const Mesh& mesh)
    : RowContact(scene, mesh, nullptr),
      layer_(scene, mesh),
      system_(layer_, room().rows, room().terms),
      acting_of_(scene.contacts.size(), {0, 0}),
      contact_(static_cast<std::size_t>(layer_.unknowns()), 0),
      imbalance_(contact_.size(), 0) {
    acting_.reserve(room().rows, room().terms);
}

void MasslessContact::restart(const std::vector<std::vector<std::int32_t>>& active) {
    RowContact::restart(active);
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
    RowContact::resolve(motion, statistics);
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
        for (const RowTerm& term : rows.terms(row))
            for (std::size_t d = 0; d < 2; ++d)
                if (layer_.unknown_of(term.node, d) < 0) push(term.node, d, row.force * term.g[d]);
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
        for (int i = 0; i < corner_count(cell.corners); ++i)
            for (int d = 0; d < 2; ++d) {
                const std::int32_t unknown =
                    layer_.unknown_of(cell.corners[static_cast<std::size_t>(i)], static_cast<std::size_t>(d));
                if (unknown >= 0) imbalance_[static_cast<std::size_t>(unknown)] += force(2 * i + d);
            }
    }
}

void MasslessContact::solve(PredictedMotion&, ContactSolverStatistics& statistics) {
    system_.assemble(layer_, rows_.all(), chosen_, imbalance_, all_expected());
    system_.solve(statistics);
    deepest_ = 0;
    for (std::size_t r = 0; r < chosen_.size(); ++r) {
        const auto k = static_cast<std::size_t>(chosen_[r]);
        rows_[k].force = system_.force(r);
        if (system_.has_row(r)) expected(k) = system_.stand(r);
        deepest_ = std::max(deepest_, rows_[k].penetration);
    }
}

double MasslessContact::opening(std::span<const RowTerm> terms, const PredictedMotion&) const {
    double sum = 0;
    for (const RowTerm& term : terms)
        for (std::size_t d = 0; d < 2; ++d)
            if (const std::int32_t u = layer_.unknown_of(term.node, d); u >= 0)
                sum += term.g[d] * system_.moved(static_cast<std::size_t>(u));
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
            const double moved = system_.moved(static_cast<std::size_t>(of.unknown[d])),
                         change = moved / motion.dt;
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
        for (const RowTerm& term : rows_.terms(row))
            for (std::size_t d = 0; d < 2; ++d)
                if (const std::int32_t u = layer_.unknown_of(term.node, d); u >= 0)
                    contact_[static_cast<std::size_t>(u)] += row.force * term.g[d];
    }
    reach_ = 2 * motion.dt * std::sqrt(largest);
    return std::sqrt(largest);
}

}  // namespace percuss
