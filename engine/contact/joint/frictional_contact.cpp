#include "contact/joint/frictional_contact.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace percuss {
namespace {

/// Friction has settled when it moves no row's node along its normal by more than this part of the deepest
/// predicted penetration from one round to the next. What is left is taken up by the next step.
constexpr double settled = 1e-6;
constexpr int most_rounds = 50;
/// Where two rows can take the same force, contact and friction may answer each other in a cycle of two for
/// ever. Rounds after these go a quarter of the way only, which ends it as long as one overshoots by less
/// than 6.
constexpr int whole_rounds = 20;

}  // namespace

template <class Normal>
FrictionalContact<Normal>::FrictionalContact(const Scene& scene, const Mesh& mesh)
    : Normal(scene, mesh), tangential_(mesh.node_count(), wall_nodes(mesh)) {
    std::size_t rows = 0, terms = 0;
    for (const ContactPair& pair : scene.contacts) {
        pairs_.push_back({pair.friction});
        if (pair.friction == 0) continue;
        const RowBuilder::Size size = this->size_of(pairs_.size() - 1);
        rows += size.rows;
        terms += size.terms;
    }
    tangents_.reserve(rows, terms);
    grips_.reserve(rows);
    all_.reserve(rows);
    slip_.reserve(rows);
    limit_.reserve(rows);
    friction_.reserve(rows);
    standing_.reserve(rows);
    tangential_.reserve(rows, terms);
    bounded_.reserve(rows, 32 * rows);
}

template <class Normal>
RowSpan FrictionalContact<Normal>::friction_rows(std::size_t pair) const {
    const Pair& p = pairs_[pair];
    return tangents_.part(p.tangents_begin, p.tangents_end);
}

template <class Normal>
void FrictionalContact<Normal>::restart(const std::vector<std::vector<std::int32_t>>& active) {
    Normal::restart(active);
    clear_tangents();
}

template <class Normal>
void FrictionalContact<Normal>::change(const std::vector<double>& friction, const ContactSolver& solver) {
    Normal::change(friction, solver);
    for (std::size_t p = 0; p < pairs_.size(); ++p) pairs_[p].friction = friction[p];
}

template <class Normal>
void FrictionalContact<Normal>::clear_tangents() {
    tangents_.clear();
    grips_.clear();
    for (Pair& pair : pairs_) {
        pair.tangents_begin = pair.tangents_end = 0;
        pair.sticking = 0;
    }
}

template <class Normal>
void FrictionalContact<Normal>::solve(PredictedMotion& motion, ContactSolverStatistics& statistics) {
    this->assemble(motion);
    choose_tangents(motion);
    tangential_.assemble(tangents_.all(), all_, motion.inverse_mass, motion.dt * motion.kick);
    standing_.assign(tangential_.places(), BoundedSolver::between);
    int round = 0;
    bool changed = true;
    while (changed && round < most_rounds) {
        ++round;
        this->solve_forces(statistics);
        this->clear_impulses(motion);
        this->add_impulses(motion);
        solve_friction(motion);
        this->clear_impulses(motion);
        const RowSpan tangents = tangents_.all();
        for (const ContactRow& tangent : tangents) this->add_impulse(tangents, tangent, motion);
        const double deepest = this->deepest_penetration();
        changed = meet_friction(motion, round > whole_rounds ? 0.25 : 1.0) > settled * deepest;
    }
    this->add_impulses(motion);
    count_sticking();
    ++statistics.friction_solutions;
    statistics.friction_rounds += round;
    statistics.most_friction_rounds = std::max(statistics.most_friction_rounds, round);
    statistics.unsettled += changed;
}

/// Tangents of the chosen rows, with how far their nodes would slide back in the predicted motion.
template <class Normal>
void FrictionalContact<Normal>::choose_tangents(const PredictedMotion& motion) {
    clear_tangents();
    auto k = chosen_.begin();
    for (std::size_t p = 0; p < pairs_.size(); ++p) {
        Pair& pair = pairs_[p];
        pair.tangents_begin = tangents_.size();
        for (; k != chosen_.end() && static_cast<std::size_t>(*k) < this->rows_end(p); ++k) {
            if (pair.friction == 0) continue;
            ContactRow& tangent = tangents_.add_turned(rows_.all(), rows_[static_cast<std::size_t>(*k)]);
            tangent.penetration = -motion.dt * along(tangents_.terms(tangent),
                                                     [&](std::int32_t node) { return motion.nodes[node].v; });
            tangent.force = 0;
            grips_.push_back({pair.friction, *k, false});
        }
        pair.tangents_end = tangents_.size();
    }
    all_.resize(tangents_.size());
    std::iota(all_.begin(), all_.end(), 0);
}

/// Friction forces for the present contact forces, whose impulses are on the nodes.
template <class Normal>
void FrictionalContact<Normal>::solve_friction(const PredictedMotion& motion) {
    const std::size_t count = tangential_.places();
    slip_.assign(count, 0.0);
    limit_.assign(count, 0.0);
    friction_.resize(count);
    const auto tangent_at = [&](std::size_t place) {
        return static_cast<std::size_t>(tangential_.order()[place]);
    };
    for (std::size_t place = 0; place < count; ++place) {
        if (!tangential_.has_row(place)) continue;
        const std::size_t t = tangent_at(place);
        slip_[place] = tangents_[t].penetration - opening(tangents_.terms(tangents_[t]), motion);
        limit_[place] = grips_[t].friction * rows_[static_cast<std::size_t>(grips_[t].row)].force;
    }
    for (const Coupling::Group& group : tangential_.groups())
        bounded_.solve_within(limit_, tangential_.matrix(), slip_, standing_, friction_, group.begin,
                              group.end);
    for (std::size_t place = 0; place < count; ++place) {
        if (!tangential_.has_row(place)) continue;
        const std::size_t t = tangent_at(place);
        tangents_[t].force = friction_[place];
        grips_[t].sticks = limit_[place] > 0 && standing_[place] == BoundedSolver::between;
    }
}

/// What the contact forces have to prevent beside the friction forces, whose impulses are on the nodes;
/// nothing where they follow from the positions.
/// @param share of its change that is taken over
/// @returns largest change of it [length].
template <class Normal>
double FrictionalContact<Normal>::meet_friction(const PredictedMotion& motion, double share) {
    double most = 0;
    for (std::size_t place = 0; place < penetration_.size(); ++place) {
        if (!this->has_row(place)) continue;
        const ContactRow& row = rows_[this->row_index(place)];
        const double penetration = row.penetration - opening(rows_.terms(row), motion);
        most = std::max(most, std::abs(penetration - penetration_[place]));
        penetration_[place] = share * penetration + (1 - share) * penetration_[place];
    }
    return most;
}

template <class Normal>
void FrictionalContact<Normal>::count_sticking() {
    for (Pair& pair : pairs_) {
        pair.sticking = 0;
        for (std::size_t t = pair.tangents_begin; t < pair.tangents_end; ++t)
            pair.sticking += grips_[t].sticks;
    }
}

template class FrictionalContact<JointContact>;
template class FrictionalContact<PenaltyContact>;
template class FrictionalContact<BipenaltyContact>;

}  // namespace percuss
