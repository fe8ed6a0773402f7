#include "contact/joint/penalty_contact.hpp"

#include <algorithm>
#include <cmath>

namespace percuss {

PenaltyContact::PenaltyContact(const Scene& scene, const Mesh& mesh)
    : JointContact(scene, mesh, &depth_level),
      bounds_step_(!scene.contact_solver.step_of_elements),
      stiffness_(scene, mesh),
      penalty_(scene.contact_solver.penalty),
      pull_(mesh.nodes.size(), 0) {}

void PenaltyContact::change(const std::vector<double>& friction, const ContactSolver& solver) {
    JointContact::change(friction, solver);
    penalty_ = solver.penalty;
    bounds_step_ = !solver.step_of_elements;
}

void PenaltyContact::resolve(PredictedMotion& motion, RunStatistics& statistics) {
    longest_seen_ = std::max(longest_seen_, motion.dt);
    longest_step_ = bounds_step_ ? longest_seen_ : 0;
    JointContact::resolve(motion, statistics);
    motion.stored = stored_;
    if (bounds_step_) motion.squared_frequency = squared_frequency(motion.inverse_mass);
}

void PenaltyContact::choose_rows() {
    empty_problem();
    stored_ = 0;
    for (std::size_t k = 0; k < rows_.size(); ++k) {
        const ContactRow& row = rows_[k];
        if (row.penetration <= 0) continue;
        put_in_problem(k);
        stored_ += 0.5 * stiffness(row) * row.penetration * row.penetration;
    }
}

void PenaltyContact::solve_forces(ContactSolverStatistics&) {
    for (const std::int32_t k : chosen_) {
        ContactRow& row = rows_[static_cast<std::size_t>(k)];
        row.force = stiffness(row) * row.penetration;
    }
}

double PenaltyContact::squared_frequency(const double* inverse_mass) {
    const auto inverse = [&](std::int32_t node) {
        return std::max(inverse_mass[2 * node], inverse_mass[2 * node + 1]);
    };
    const auto share = [](const RowTerm& term) { return std::hypot(term.g[0], term.g[1]); };
    for (const ContactRow& row : rows_) {
        double shares = 0;
        for (const RowTerm& term : rows_.terms(row))
            if (inverse(term.node) > 0) shares += share(term);
        const double pull = stiffness(row) * shares;
        for (const RowTerm& term : rows_.terms(row))
            pull_[static_cast<std::size_t>(term.node)] += pull * share(term);
    }
    double highest = 0;
    for (const ContactRow& row : rows_) {
        for (const RowTerm& term : rows_.terms(row)) {
            double& pull = pull_[static_cast<std::size_t>(term.node)];
            highest = std::max(highest, inverse(term.node) * pull);
            pull = 0;
        }
    }
    return highest;
}

}  // namespace percuss
