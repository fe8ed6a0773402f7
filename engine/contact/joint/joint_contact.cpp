#include "contact/joint/joint_contact.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "contact/solvers/conjugate_gradient.hpp"
#include "contact/solvers/gauss_seidel.hpp"
#include "contact/surface.hpp"

namespace percuss {
namespace {

std::unique_ptr<NonnegativeSolver> make_solver(ForceSolver kind) {
    switch (kind) {
        case ForceSolver::gauss_seidel:
            return std::make_unique<ProjectedGaussSeidel>();
        case ForceSolver::conjugate_gradient:
            return std::make_unique<ProjectedConjugateGradient>();
        case ForceSolver::active_set:
            break;
    }
    return std::make_unique<BoundedSolver>();
}

}  // namespace

JointContact::JointContact(const Scene& scene, const Mesh& mesh, ConditionOf condition)
    : RowContact(scene, mesh, condition),
      coupling_(mesh.node_count(), wall_nodes(mesh)),
      listed_(static_cast<std::size_t>(mesh.node_count()), 0),
      solver_(make_solver(scene.contact_solver.solver)),
      solver_kind_(scene.contact_solver.solver) {
    const std::size_t rows = room().rows;
    penetration_.reserve(rows);
    force_.reserve(rows);
    standing_.reserve(rows);
    coupling_.reserve(rows, room().terms);
    coupling_.split_off(solver_kind_ == ForceSolver::active_set);
    solver_->reserve(rows, 32 * rows);
}

void JointContact::change(const std::vector<double>& friction, const ContactSolver& solver) {
    RowContact::change(friction, solver);
    if (solver.solver == solver_kind_) return;
    solver_kind_ = solver.solver;
    coupling_.split_off(solver_kind_ == ForceSolver::active_set);
    solver_ = AnyNonnegativeSolver(make_solver(solver_kind_));
    solver_->reserve(room().rows, 32 * room().rows);
}

void JointContact::solve(PredictedMotion& motion, ContactSolverStatistics& statistics) {
    assemble(motion);
    solve_forces(statistics);
    clear_impulses(motion);
    add_impulses(motion);
}

void JointContact::assemble(const PredictedMotion& motion) {
    coupling_.assemble(rows_.all(), chosen_, motion.inverse_mass, motion.dt * motion.kick);
    const std::size_t count = coupling_.places();
    penetration_.assign(count, 0.0);
    force_.resize(count);
    standing_.assign(count, BoundedSolver::between);
    for (std::size_t place = 0; place < count; ++place) {
        if (!coupling_.has_row(place)) continue;
        penetration_[place] = rows_[row_index(place)].penetration;
        standing_[place] = expected(row_index(place));
    }
}

void JointContact::solve_forces(ContactSolverStatistics& statistics) {
    for (const Coupling::Group& group : coupling_.groups()) {
        const int rounds =
            solver_->solve(coupling_.matrix(), penetration_, standing_, force_, group.begin, group.end);
        ++statistics.problems;
        statistics.iterations += rounds;
        statistics.most_iterations = std::max(statistics.most_iterations, rounds);
        statistics.fallbacks += solver_->relaxed();
        const auto rows = static_cast<int>(std::count_if(coupling_.order().begin() + group.begin,
                                                         coupling_.order().begin() + group.end,
                                                         [](std::int32_t row) { return row >= 0; }));
        statistics.rows += rows;
        statistics.most_rows = std::max(statistics.most_rows, rows);
    }
    for (std::size_t place = 0; place < coupling_.places(); ++place) {
        if (!coupling_.has_row(place)) continue;
        const std::size_t k = row_index(place);
        rows_[k].force = std::max(0.0, force_[place]);
        expected(k) = standing_[place];
    }
}

std::size_t JointContact::row_index(std::size_t place) const {
    return static_cast<std::size_t>(chosen_[static_cast<std::size_t>(coupling_.order()[place])]);
}

void JointContact::clear_impulses(const PredictedMotion& motion) {
    for (const std::int32_t node : *motion.touched)
        motion.impulse[2 * node] = motion.impulse[2 * node + 1] = 0;
}

void JointContact::add_impulses(const PredictedMotion& motion) {
    const RowSpan rows = rows_.all();
    for (const std::int32_t k : chosen_) add_impulse(rows, rows[static_cast<std::size_t>(k)], motion);
}

void JointContact::add_impulse(const RowSpan& rows, const ContactRow& row, const PredictedMotion& motion) {
    const double impulse = motion.kick * row.force;
    for (const RowTerm& term : rows.terms(row)) {
        const std::int32_t node = term.node;
        char& listed = listed_[static_cast<std::size_t>(node)];
        if (!listed) motion.touched->push_back(node);
        listed = 1;
        motion.impulse[2 * node] += impulse * term.g[0];
        motion.impulse[2 * node + 1] += impulse * term.g[1];
    }
}

/// By how much the impulses so far open a row's gap within the step [length].
double JointContact::opening(std::span<const RowTerm> terms, const PredictedMotion& motion) const {
    return motion.dt * along(terms, [&](std::int32_t node) {
               const double *inverse_mass = motion.inverse_mass + 2 * node,
                            *impulse = motion.impulse + 2 * node;
               return std::array{inverse_mass[0] * impulse[0], inverse_mass[1] * impulse[1]};
           });
}

double JointContact::deepest_penetration() const {
    double deepest = 0;
    for (const double p : penetration_) deepest = std::max(deepest, p);
    return deepest;
}

double JointContact::correct(PredictedMotion& motion) {
    double largest = 0;
    for (const std::int32_t node : *motion.touched) {
        listed_[static_cast<std::size_t>(node)] = 0;
        const double x = motion.inverse_mass[2 * node] * motion.impulse[2 * node],
                     y = motion.inverse_mass[2 * node + 1] * motion.impulse[2 * node + 1];
        Node& n = motion.nodes[node];
        n.v[0] += x;
        n.v[1] += y;
        n.x[0] += motion.dt * x;
        n.x[1] += motion.dt * y;
        largest = std::max(largest, x * x + y * y);
    }
    return std::sqrt(largest);
}

}  // namespace percuss
