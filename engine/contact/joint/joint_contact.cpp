#include "contact/joint/joint_contact.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "contact/joint/make_rows.hpp"
#include "contact/solvers/conjugate_gradient.hpp"
#include "contact/solvers/gauss_seidel.hpp"
#include "dynamics/double2.hpp"
#include "run/phase_timer.hpp"

namespace percuss {
namespace {

/// A row outside the problem may close by this part of the deepest predicted penetration too far.
constexpr double violation_tolerance = 1e-9;

/// No gap of a row is (StepMotion::held).
constexpr double not_held = -1;

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
    : coupling_(mesh.node_count(), wall_nodes(mesh)),
      recovery_speed_(scene.contact_solver.recovery_speed),
      listed_(static_cast<std::size_t>(mesh.node_count()), 0),
      solver_(make_solver(scene.contact_solver.solver)),
      solver_kind_(scene.contact_solver.solver) {
    std::size_t rows = 0, terms = 0;
    for (const ContactPair& pair : scene.contacts) {
        const PairSurfaces surfaces = pair_surfaces(scene, mesh, pair);
        pairs_.push_back({make_rows(scene, mesh, pair), condition ? condition : &position_level,
                          add_surface(surfaces.master), add_surface(surfaces.slave)});
        const RowBuilder::Size size = pairs_.back().builder->size();
        pairs_.back().last.assign(size.keys, Last::not_in_problem);
        if (!condition && pair.level == ContactLevel::velocity)
            pairs_.back().held.assign(size.keys, not_held);
        rows += size.rows;
        terms += size.terms;
    }
    rows_.reserve(rows, terms);
    chosen_.reserve(rows);
    in_problem_.reserve(rows);
    expected_.reserve(rows);
    penetration_.reserve(rows);
    force_.reserve(rows);
    standing_.reserve(rows);
    coupling_.reserve(rows, terms);
    coupling_.split_off(solver_kind_ == ForceSolver::active_set);
    solver_->reserve(rows, 32 * rows);
}

void JointContact::change(const std::vector<double>&, const ContactSolver& solver) {
    recovery_speed_ = solver.recovery_speed;
    if (solver.solver == solver_kind_) return;
    solver_kind_ = solver.solver;
    coupling_.split_off(solver_kind_ == ForceSolver::active_set);
    solver_ = AnyNonnegativeSolver(make_solver(solver_kind_));
}

std::size_t JointContact::add_surface(const Surface& surface) {
    const auto same = std::find_if(surfaces_.begin(), surfaces_.end(),
                                   [&](const Moving& moving) { return moving.nodes == surface.nodes; });
    if (same == surfaces_.end()) {
        surfaces_.push_back({surface.nodes, {}, {}});
        return surfaces_.size() - 1;
    }
    return static_cast<std::size_t>(same - surfaces_.begin());
}

RowSpan JointContact::rows(std::size_t pair) const {
    return rows_.part(pairs_[pair].rows_begin, pairs_[pair].rows_end);
}

void JointContact::restart(const std::vector<std::vector<std::int32_t>>& active) {
    rows_.clear();
    for (std::size_t p = 0; p < pairs_.size(); ++p) {
        Pair& pair = pairs_[p];
        pair.rows_begin = pair.rows_end = 0;
        pair.left_open = 0;
        std::fill(pair.held.begin(), pair.held.end(), not_held);
        pair.builder->restart(active[p]);
        std::fill(pair.last.begin(), pair.last.end(), Last::not_in_problem);
        for (const std::int32_t owner : active[p]) pair.last[static_cast<std::size_t>(owner)] = Last::pressed;
        pair.remembers = !active[p].empty();
    }
}

void JointContact::resolve(PredictedMotion& motion, RunStatistics& statistics) {
    PhaseTimer timer;
    find(motion);
    timer.book(statistics.seconds.contact_search);
    largest_correction_ = 0;
    choose_rows();
    if (!chosen_.empty()) {
        do solve(motion, statistics.contact_solver);
        while (add_violated(motion));
        correct(motion);
    }
    remember();
    for (Pair& pair : pairs_)
        pair.builder->advance({pair.relative + 2 * motion.dt * largest_correction_,
                               pair.master_motion + motion.dt * largest_correction_,
                               pair.slave_motion + motion.dt * largest_correction_});
    timer.book(statistics.seconds.contact_solve);
}

void JointContact::find(const PredictedMotion& motion) {
    for (Moving& surface : surfaces_) {
        Double2 low = load_pair(motion.nodes[surface.nodes.front()].v), high = low;
        for (const std::int32_t node : surface.nodes) {
            const Double2 v = load_pair(motion.nodes[node].v);
            low = smaller(v, low);
            high = larger(v, high);
        }
        surface.lowest = {low[0], low[1]};
        surface.highest = {high[0], high[1]};
    }
    rows_.clear();
    for (Pair& pair : pairs_) {
        const Moving &m = surfaces_[pair.master], &s = surfaces_[pair.slave];
        double relative = 0, master = 0, slave = 0;
        for (std::size_t d = 0; d < 2; ++d) {
            const double most = std::max(m.highest[d] - s.lowest[d], s.highest[d] - m.lowest[d]);
            const double most_master = std::max(m.highest[d], -m.lowest[d]),
                         most_slave = std::max(s.highest[d], -s.lowest[d]);
            relative += most * most;
            master += most_master * most_master;
            slave += most_slave * most_slave;
        }
        pair.relative = motion.dt * std::sqrt(relative);
        pair.master_motion = motion.dt * std::sqrt(master);
        pair.slave_motion = motion.dt * std::sqrt(slave);
        pair.rows_begin = rows_.size();
        const double range = pair.relative * std::max(1.0, longest_step_ / motion.dt);
        pair.builder->find(
            {motion.nodes, motion.dt, std::max(range, pair.left_open), motion.dt * recovery_speed_,
             pair.condition, pair.held.empty() ? nullptr : pair.held.data()},
            rows_);
        pair.rows_end = rows_.size();
    }
}

void JointContact::empty_problem() {
    chosen_.clear();
    in_problem_.assign(rows_.size(), 0);
    expected_.assign(rows_.size(), BoundedSolver::between);
}

void JointContact::put_in_problem(std::size_t row) {
    in_problem_[row] = 1;
    chosen_.push_back(static_cast<std::int32_t>(row));
}

void JointContact::choose_rows() {
    empty_problem();
    for (const Pair& pair : pairs_) {
        for (std::size_t k = pair.rows_begin; k < pair.rows_end; ++k) {
            const ContactRow& row = rows_[k];
            const Last last = pair.last[static_cast<std::size_t>(row.key)];
            if (row.penetration <= row.margin && last != Last::pressed) continue;
            // What others kept closed in the last step, they will again.
            if (last == Last::open) expected_[k] = BoundedSolver::at_lower;
            put_in_problem(k);
        }
    }
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
        standing_[place] = expected_[row_index(place)];
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
        statistics.rows += group.end - group.begin;
        statistics.most_rows = std::max(statistics.most_rows, group.end - group.begin);
    }
    for (std::size_t place = 0; place < coupling_.places(); ++place) {
        if (!coupling_.has_row(place)) continue;
        const std::size_t k = row_index(place);
        rows_[k].force = std::max(0.0, force_[place]);
        expected_[k] = standing_[place];
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
double JointContact::opening(std::span<const RowTerm> terms, const PredictedMotion& motion) {
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

bool JointContact::add_violated(const PredictedMotion& motion) {
    if (chosen_.size() == rows_.size()) return false;
    const double deepest = deepest_penetration();
    bool added = false;
    for (std::size_t k = 0; k < rows_.size(); ++k) {
        if (in_problem_[k]) continue;
        const ContactRow& row = rows_[k];
        const double closing = row.penetration - opening(rows_.terms(row), motion);
        if (closing <= row.margin + violation_tolerance * deepest) continue;
        in_problem_[k] = 1;
        added = true;
    }
    if (!added) return false;
    chosen_.clear();
    for (std::size_t k = 0; k < rows_.size(); ++k)
        if (in_problem_[k]) chosen_.push_back(static_cast<std::int32_t>(k));
    return true;
}

void JointContact::correct(const PredictedMotion& motion) {
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
    largest_correction_ = std::sqrt(largest);
}

/// A row that had force keeps the gap that it was met at, until nothing can close it in the next step.
void JointContact::hold_gaps(Pair& pair) {
    next_held_.assign(pair.held.size(), not_held);
    pair.left_open = 0;
    for (std::size_t k = pair.rows_begin; k < pair.rows_end; ++k) {
        const ContactRow& row = rows_[k];
        const auto key = static_cast<std::size_t>(row.key);
        const double held = pair.held[key];
        const bool stays = held >= 0 && -row.penetration <= pair.relative;
        if (row.force <= 0 && !stays) continue;
        next_held_[key] = held >= 0 ? held : row.margin;
        pair.left_open = std::max(pair.left_open, next_held_[key]);
    }
    pair.held.swap(next_held_);
}

void JointContact::remember() {
    for (Pair& pair : pairs_) {
        if (!pair.held.empty()) hold_gaps(pair);
        const bool any = pair.rows_end > pair.rows_begin;
        if (!any && !pair.remembers) continue;  // one of many pairs that are far apart
        pair.remembers = any;
        std::fill(pair.last.begin(), pair.last.end(), Last::not_in_problem);
        for (std::size_t k = pair.rows_begin; k < pair.rows_end; ++k)
            if (in_problem_[k]) {
                Last& last = pair.last[static_cast<std::size_t>(rows_[k].key)];  // rows in a valley share one
                last = rows_[k].force > 0 || last == Last::pressed ? Last::pressed : Last::open;
            }
    }
}

}  // namespace percuss
