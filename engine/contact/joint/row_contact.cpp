#include "contact/joint/row_contact.hpp"

#include <algorithm>
#include <cmath>

#include "contact/joint/make_rows.hpp"
#include "contact/solvers/bounded.hpp"
#include "dynamics/double2.hpp"
#include "run/phase_timer.hpp"

namespace percuss {
namespace {

/// A row outside the problem may close by this part of the deepest predicted penetration too far.
constexpr double violation_tolerance = 1e-9;

/// No gap of a row is (StepMotion::held).
constexpr double not_held = -1;

}  // namespace

RowContact::RowContact(const Scene& scene, const Mesh& mesh, ConditionOf condition)
    : recovery_speed_(scene.contact_solver.recovery_speed) {
    for (const ContactPair& pair : scene.contacts) {
        const PairSurfaces surfaces = pair_surfaces(scene, mesh, pair);
        pairs_.push_back({make_rows(scene, mesh, pair), condition ? condition : &position_level,
                          add_surface(surfaces.master), add_surface(surfaces.slave)});
        const RowBuilder::Size size = pairs_.back().builder->size();
        pairs_.back().last.assign(size.keys, Last::not_in_problem);
        if (!condition && pair.level == ContactLevel::velocity)
            pairs_.back().held.assign(size.keys, not_held);
        room_.keys += size.keys;
        room_.rows += size.rows;
        room_.terms += size.terms;
    }
    rows_.reserve(room_.rows, room_.terms);
    chosen_.reserve(room_.rows);
    in_problem_.reserve(room_.rows);
    expected_.reserve(room_.rows);
}

void RowContact::change(const std::vector<double>&, const ContactSolver& solver) {
    recovery_speed_ = solver.recovery_speed;
}

std::size_t RowContact::add_surface(const Surface& surface) {
    const auto same = std::find_if(surfaces_.begin(), surfaces_.end(),
                                   [&](const Moving& moving) { return moving.nodes == surface.nodes; });
    if (same == surfaces_.end()) {
        surfaces_.push_back({surface.nodes, {}, {}});
        return surfaces_.size() - 1;
    }
    return static_cast<std::size_t>(same - surfaces_.begin());
}

RowSpan RowContact::rows(std::size_t pair) const {
    return rows_.part(pairs_[pair].rows_begin, pairs_[pair].rows_end);
}

void RowContact::restart(const std::vector<std::vector<std::int32_t>>& active) {
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

void RowContact::resolve(PredictedMotion& motion, RunStatistics& statistics) {
    PhaseTimer timer;
    find(motion);
    timer.book(statistics.seconds.contact_search);
    double largest_correction = 0;  // of a velocity
    choose_rows();
    if (!chosen_.empty() || solves_without_rows()) {
        do solve(motion, statistics.contact_solver);
        while (add_violated(motion));
        largest_correction = correct(motion);
    }
    remember();
    for (Pair& pair : pairs_)
        pair.builder->advance({pair.relative + 2 * motion.dt * largest_correction,
                               pair.master_motion + motion.dt * largest_correction,
                               pair.slave_motion + motion.dt * largest_correction});
    timer.book(statistics.seconds.contact_solve);
}

void RowContact::find(const PredictedMotion& motion) {
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
        pair.fastest = std::max(pair.fastest, pair.relative / motion.dt);
        const double range = std::max({pair.relative, pair.fastest * longest_step_, pair.left_open}) + reach_;
        pair.builder->find({motion.nodes, motion.dt, range, motion.dt * recovery_speed_, pair.condition,
                            pair.held.empty() ? nullptr : pair.held.data()},
                           rows_);
        pair.rows_end = rows_.size();
    }
}

void RowContact::empty_problem() {
    chosen_.clear();
    in_problem_.assign(rows_.size(), 0);
    expected_.assign(rows_.size(), BoundedSolver::between);
}

void RowContact::put_in_problem(std::size_t row) {
    in_problem_[row] = 1;
    chosen_.push_back(static_cast<std::int32_t>(row));
}

void RowContact::choose_rows() {
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

bool RowContact::add_violated(const PredictedMotion& motion) {
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

/// A row that had force keeps the gap that it was met at, until nothing can close it in the next step.
void RowContact::hold_gaps(Pair& pair) {
    next_held_.assign(pair.held.size(), not_held);
    pair.left_open = 0;
    for (std::size_t k = pair.rows_begin; k < pair.rows_end; ++k) {
        const ContactRow& row = rows_[k];
        const auto key = static_cast<std::size_t>(row.key);
        const double held = pair.held[key];
        const bool stays = held >= 0 && -row.penetration <= pair.relative;
        if (row.force <= 0 && !stays) continue;
        const double now = held >= 0 ? held : row.margin;
        // Two faces of a valley share a key: neither may be pushed off for the other's gap.
        next_held_[key] = next_held_[key] >= 0 ? std::min(next_held_[key], now) : now;
        pair.left_open = std::max(pair.left_open, next_held_[key]);
    }
    pair.held.swap(next_held_);
}

void RowContact::remember() {
    for (Pair& pair : pairs_) {
        const bool any = pair.rows_end > pair.rows_begin;
        if (!any && !pair.remembers) continue;  // one of many pairs that are far apart
        if (!pair.held.empty()) hold_gaps(pair);
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
