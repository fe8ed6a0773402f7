// One time step, top-down. Positions x belong to times t_n, velocities v to the middle of the steps between
// them; "before" and "after" are the velocities that lead to and away from x_n. The order matters: contact
// corrects positions and velocities before stresses are evaluated, so stresses never see a penetration, and
// energy never grows.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "dynamics/double2.hpp"
#include "run/history_columns.hpp"
#include "run/phase_timer.hpp"
#include "solver.hpp"

namespace percuss {
namespace {

/// The critical step is evaluated anew before any element can have been strained by more than this since the
/// last time, and in any case after so many steps.
constexpr double strain_between_evaluations = 0.05;
constexpr int steps_between_evaluations = 64;

std::pair<std::size_t, std::size_t> share_of(std::size_t count, int part, int parts) {
    const auto p = static_cast<std::size_t>(part), n = static_cast<std::size_t>(parts);
    return {count * p / n, count * (p + 1) / n};
}

}  // namespace

std::optional<Divergence> Solver::step() {
    PhaseTimer timer;
    PhaseSeconds& seconds = statistics_.seconds;

    if (!probes_.empty()) {
        read_probes();
        timer.book(seconds.probes);
    }
    if (auto divergence = choose_step(timer)) return divergence;
    if (!loads_.none()) {
        loads_.evaluate(state_.nodes.data(), mass_, state_.time, external_);
        timer.book(seconds.loads);
    }
    predict();  // v += dt M^-1 (f_ext - f_int), x += dt v
    timer.book(seconds.integrate);

    if (setup_->scene.lagged) stresses_at_predicted_positions();
    timer.book(seconds.elements);

    resolve_contacts();  // finds penetrations, solves for contact forces, corrects x and v

    timer = {};
    if (!regions_.none()) regions_.take_in_moving(state_.nodes, touched_);
    auto divergence = close_ledger();  // energies, momenta and forces of t_n: v after it is known only now
    if (divergence) return divergence;
    timer.book(seconds.integrate);

    divergence = internal_forces();  // at the corrected x
    timer.book(seconds.elements);
    return divergence;
}

void Solver::read_probes() {
    for (std::size_t k = 0; k < probes_.size(); ++k) {
        const ProbeReading& probe = probes_[k];
        if (probe.cell >= 0)
            probe_values_[k] = read_cell(probe, batches_, state_.nodes.data());
        else
            probe_nodes_[k] = state_.nodes[static_cast<std::size_t>(probe.node)];
    }
}

std::optional<Divergence> Solver::choose_step(PhaseTimer& timer) {
    const bool other_values = state_.critical_of != in_force_ && !bounds_elements(*state_.critical_of);
    if (state_.strain_since_critical >= strain_between_evaluations || other_values) {
        evaluate_critical_step();
        timer.book(statistics_.seconds.critical_step);
    }
    if (state_.critical_of != in_force_) state_.critical_of = in_force_;
    const StepSize& size = in_force_->step;
    const double critical = critical_step_with_contact();
    const double dt = size.fixed ? *size.fixed : size.courant * critical;
    if (dt > critical) {
        const auto unit = setup_->scene.units.display(Quantity::time, dt);
        return Divergence{fmt::format(
            "the critical step fell to {:.4g} {}{}, below the fixed step of {:.4g} {}", critical * unit.scale,
            unit.label, critical < state_.critical_step ? " with the springs of contact" : "",
            dt * unit.scale, unit.label)};
    }
    // An element on its way to nothing takes the time step along: the run would never end.
    if (state_.critical_step < 1e-6 * statistics_.critical_step_initial) {
        const Located most = locate_most_energy();
        return Divergence{
            fmt::format(
                "the critical step fell below a millionth of its first value at {}; most energy is in {}",
                moment(), most.name),
            most.cell};
    }
    // The acceleration at t_n acts from the middle of the step before to the middle of the step after.
    kick_ = state_.step == 0 ? dt : 0.5 * (state_.dt + dt);
    state_.dt = dt;
    statistics_.dt_min = state_.step == 0 ? dt : std::min(statistics_.dt_min, dt);
    statistics_.dt_max = std::max(statistics_.dt_max, dt);
    return std::nullopt;
}

/// Frequencies of elements and springs: the square of the highest of both together is at most their sum. And
/// a spring that takes hold between two steps gives back at most what it took up as long as it alone swings
/// no faster than 1/dt (at 2/dt a node could leave three times as fast as it came).
double Solver::critical_step_with_contact() const {
    if (state_.contact_frequency == 0) return state_.critical_step;
    const double of_elements = 2 / state_.critical_step;
    return 2 / std::sqrt(std::max(of_elements * of_elements, 3 * state_.contact_frequency) +
                         state_.contact_frequency);
}

double Solver::critical_step_of_elements() {
    const Node* nodes = state_.nodes.data();
    average_nodal_volumes(nodes);
    std::fill(highest_.begin(), highest_.end(), 0.0);
    team_.run([&](int part) {
        const auto [begin, end] = share_of(element_chunks_.size(), part, team_.size());
        for (std::size_t k = begin; k < end; ++k) {
            const QuietRegions::Chunk& chunk = element_chunks_[k];
            const Batch& batch = batches_[static_cast<std::size_t>(chunk.body)];
            double& most = highest_[static_cast<std::size_t>(part)];
            most = std::max(most, batch.kernel.frequency(batch, nodes, chunk.begin, chunk.end));
        }
    });
    double highest = *std::max_element(highest_.begin(), highest_.end());
    if (!layers_.none()) highest = std::max(highest, layers_.squared_frequency(batches_, nodes));
    return 2 / std::sqrt(highest);
}

void Solver::evaluate_critical_step() {
    state_.critical_step = critical_step_of_elements();
    state_.critical_of = in_force_;
    if (state_.step == 0)
        statistics_.critical_step_initial = statistics_.critical_step_min = state_.critical_step;
    statistics_.critical_step_min = std::min(statistics_.critical_step_min, state_.critical_step);

    state_.strain_since_critical = 0;
}

void Solver::predict() {
    if (imposed_.timed) switch_prescribed();
    if (state_.step == 0) start_half_step_early();
    const auto chunks = [this](int part) {
        const auto [begin, end] = share_of(node_chunks_.size(), part, team_.size());
        for (std::size_t k = begin; k < end; ++k) {
            if (loads_.none())
                predict_chunk<false>(k, node_sums_[k]);
            else
                predict_chunk<true>(k, node_sums_[k]);
        }
    };
    team_.run(chunks);

    Ledger& ledger = state_.ledger;
    momentum_before_ = ledger.body_momentum;
    for (auto& momentum : ledger.body_momentum) momentum = {0, 0};
    sums_ = {};
    for (std::size_t k = 0; k < node_chunks_.size(); ++k) {
        sums_ += node_sums_[k];
        auto& momentum = ledger.body_momentum[static_cast<std::size_t>(node_chunks_[k].body)];
        for (std::size_t d = 0; d < 2; ++d) momentum[d] += node_sums_[k].momentum[d];
    }
    if (!imposed_.prescribed.empty()) impose_velocities(sums_);
}

/// By how much the last step has strained an element at most. Something is added so that steps at rest come
/// to an evaluation, too.
double Solver::largest_strain() const {
    double square = 0;
    for (const KernelSums& sums : element_sums_)
        square = std::max(square, *std::max_element(std::begin(sums.strain), std::end(sums.strain)));
    return std::sqrt(square) + strain_between_evaluations / steps_between_evaluations;
}

/// Velocities are given for t = 0 and wanted half a step earlier: known accelerations are taken back.
void Solver::start_half_step_early() {
    if (loads_.none()) return;
    Ledger& ledger = state_.ledger;
    ledger.initial_kinetic = 0;
    for (std::size_t n = 0; n < body_of_node_.size(); ++n) {  // not the nodes of walls
        for (std::size_t d = 0; d < 2; ++d) {
            double& v = state_.nodes[n].v[d];
            const double change = -0.5 * kick_ * inverse_mass_[2 * n + d] * external_[2 * n + d];
            v += change;
            ledger.body_momentum[static_cast<std::size_t>(body_of_node_[n])][d] += mass_[n] * change;
            if (inverse_mass_[2 * n + d] > 0)
                statistics_.external_impulse[d] -= scale_ * 0.5 * kick_ * external_[2 * n + d];
            ledger.initial_kinetic += 0.5 * mass_[n] * v * v;
        }
    }
    ledger.lowest = ledger.largest_kinetic = ledger.initial_kinetic;
}

template <bool loaded>
void Solver::predict_chunk(std::size_t chunk, NodeSums& sums) {
    const double kick = kick_, dt = state_.dt;
    Node* nodes = state_.nodes.data();
    double* internal = internal_.data();
    const double *mass = mass_.data(), *inverse_masses = inverse_mass_.data(), *external = external_.data();
    const double* const* corners = corners_.data();
    const std::int32_t* corner_begin = corner_begin_.data();
    // Both directions at once; sums stay in registers until the chunk is done.
    Double2 kinetic{}, internal_before{}, internal_after{}, external_before{}, external_after{}, momentum{};
    for (const auto& [first, last] : regions_.nodes(chunk)) {
        for (std::int32_t n = first; n < last; ++n) {
            Double2 f{};
            for (std::int32_t k = corner_begin[n]; k < corner_begin[n + 1]; ++k) f += load_pair(corners[k]);
            Node& node = nodes[n];
            const Double2 before = load_pair(node.v), inverse_mass = load_pair(inverse_masses + 2 * n);
            Double2 net = -f;
            if constexpr (loaded) {
                net += load_pair(external + 2 * n);
                external_before += load_pair(external + 2 * n) * before;
            }
            const Double2 after = before + kick * inverse_mass * net, momentum_after = mass[n] * after;
            if constexpr (loaded) external_after += load_pair(external + 2 * n) * after;
            kinetic += before * momentum_after;
            internal_before += f * before;
            internal_after += f * after;
            momentum += momentum_after;
            store_pair(node.v, after);
            store_pair(node.x, load_pair(node.x) + dt * after);
            store_pair(internal + 2 * n, f);
        }
    }
    sums.kinetic = kinetic[0] + kinetic[1];
    sums.internal_before = internal_before[0] + internal_before[1];
    sums.internal_after = internal_after[0] + internal_after[1];
    sums.external_before = external_before[0] + external_before[1];
    sums.external_after = external_after[0] + external_after[1];
    sums.momentum = {momentum[0], momentum[1]};
}

/// Nodes are held while a motion is prescribed for them and free otherwise; of two motions at a time the one
/// that the scene names first acts.
void Solver::switch_prescribed() {
    const double middle = state_.time + 0.5 * state_.dt;
    const auto visit = [this](auto&& change) {
        for (auto& p : imposed_.prescribed) {
            const auto n = static_cast<std::size_t>(p.node), d = static_cast<std::size_t>(p.direction);
            if (!imposed_.held[n][d]) change(p, n, 2 * n + d);
        }
    };
    visit([&](const auto&, std::size_t n, std::size_t k) {
        inverse_mass_[k] = 1 / mass_[n];
        imposed_change_[k] = 0;
        driven_[k] = 0;
    });
    visit([&](auto& p, std::size_t, std::size_t k) {
        p.acts = !driven_[k] && imposed_.motions[static_cast<std::size_t>(p.motion)].acts(middle);
        if (!p.acts) return;
        inverse_mass_[k] = 0;
        driven_[k] = 1;
    });
}

/// Prescribed velocities jump to their value at the middle of the step; what that takes is work of the
/// outside.
void Solver::impose_velocities(NodeSums& sums) {
    std::fill(drive_.begin(), drive_.end(), std::array<double, 2>{0, 0});
    for (const auto& p : imposed_.prescribed) {
        if (!p.acts) continue;
        const auto n = static_cast<std::size_t>(p.node), d = static_cast<std::size_t>(p.direction),
                   k = 2 * n + d;
        double& v = state_.nodes[n].v[d];
        const double before = v, after = imposed_.motions[static_cast<std::size_t>(p.motion)].velocity(
                                     state_.time + 0.5 * state_.dt);
        const double change = after - before;
        v = after;
        state_.nodes[n].x[d] += state_.dt * change;
        imposed_change_[k] = change;
        const double load = loads_.none() ? 0 : external_[k];
        const double reaction = mass_[n] * change / kick_ + internal_[k] - load;
        sums.kinetic += mass_[n] * before * change;
        sums.internal_after += internal_[k] * change;
        sums.external_before += reaction * before;
        sums.external_after += reaction * after + load * change;
        const auto body = static_cast<std::size_t>(body_of_node_[n]);
        drive_[body][d] += reaction;
        state_.ledger.body_momentum[body][d] += mass_[n] * change;
    }
}

/// The teaching mode: stresses at the uncorrected positions, from where they were last evaluated. The
/// elements then hold the energy of a motion that the bodies never made: internal work is booked along it, as
/// an audit of the elements would.
void Solver::stresses_at_predicted_positions() {
    sums_.internal_before = sums_.internal_after = 0;
    for (std::size_t n = 0; n < state_.nodes.size(); ++n) {
        for (std::size_t d = 0; d < 2; ++d) {
            const double x = state_.nodes[n].x[d], force = internal_[2 * n + d];
            double &from = state_.lagged_nodes[n].x[d], &v = state_.lagged_nodes[n].v[d];
            sums_.internal_before += force * v;
            v = (x - from) / state_.dt;
            sums_.internal_after += force * v;
            from = x;
        }
    }
    integrate_elements(state_.lagged_nodes.data());
}

void Solver::resolve_contacts() {
    if (!contact_) return;
    if (contact_scheme_ != in_force_->contact_solver.scheme) switch_contact();
    const ForcesOnNodes forces = forces_on_nodes();
    PredictedMotion motion{
        state_.dt, kick_,  state_.nodes.data(), inverse_mass_.data(), contact_impulse_.data(),
        &touched_, &forces};
    if (!massless_.empty()) motion.moved = imposed_change_.data();
    contact_->resolve(motion, statistics_);
    for (const std::size_t k : massless_) {
        sums_.internal_after += internal_[k] * imposed_change_[k];
        if (!external_.empty()) sums_.external_after += external_[k] * imposed_change_[k];
    }
    state_.contact_frequency = motion.squared_frequency;
    stored_in_contact_ = motion.stored;
}

ForcesOnNodes Solver::forces_on_nodes() const {
    const auto data = [](const std::vector<double>& of) { return of.empty() ? nullptr : of.data(); };
    return {inverse_mass_.data(), internal_.data(), data(external_), data(imposed_change_)};
}

/// What changes the momentum of all bodies together: loads, and the reactions that impose velocities or hold
/// walls. A reaction is what the node's mass takes beyond its internal, external and contact forces.
void Solver::account_external_impulse() {
    std::array<double, 2> impulse{0, 0};
    double gross = 0;
    for (const std::size_t k : supports_) {
        if (inverse_mass_[k] != 0) continue;  // a prescribed motion that does not act now
        double reaction = kick_ * internal_[k];
        if (!contact_impulse_.empty()) reaction -= contact_impulse_[k];
        if (!imposed_change_.empty()) reaction += mass_[k / 2] * imposed_change_[k];
        if (!external_.empty()) reaction -= kick_ * external_[k];
        impulse[k % 2] += reaction;
        gross += std::abs(reaction);
    }
    for (std::size_t k = 0; k < external_.size(); ++k) {
        impulse[k % 2] += kick_ * external_[k];
        gross += std::abs(kick_ * external_[k]);
    }
    for (std::size_t d = 0; d < 2; ++d) statistics_.external_impulse[d] += scale_ * impulse[d];
    statistics_.external_impulse_gross += scale_ * gross;
}

Solver::RowSums Solver::sum_rows(const RowSpan& rows, bool self) const {
    RowSums sums;
    for (const ContactRow& row : rows) {
        if (row.force == 0) continue;
        const std::span<const RowTerm> terms = rows.terms(row);
        const double rate_before = along(terms, [&](std::int32_t node) {
            return &velocity_before_contact_[2 * static_cast<std::size_t>(node)];
        });
        const double rate_after =
            along(terms, [&](std::int32_t node) { return state_.nodes[static_cast<std::size_t>(node)].v; });
        const double half_impulse = 0.5 * kick_ * row.force;
        sums.work_before += half_impulse * rate_before;
        sums.work += half_impulse * (rate_before + rate_after);
        for (const RowTerm& term : terms.first(static_cast<std::size_t>(row.master_terms)))
            for (std::size_t d = 0; d < 2; ++d) {
                const double force = scale_ * row.force * term.g[d];
                sums.force[d] += self ? std::abs(force) : force;
            }
        ++sums.active;
    }
    return sums;
}

/// Contact's share of the sums, once all pairs have corrected. @returns works of contact and friction forces
/// before t_n; the works after it go to the ledger.
Solver::ContactWorks Solver::account_contacts(NodeSums& sums) {
    Ledger& ledger = state_.ledger;
    const ForcesOnNodes forces = forces_on_nodes();
    for (const std::int32_t node : touched_) {
        const auto change = forces.change(node, kick_, contact_impulse_.data());
        const auto n = static_cast<std::size_t>(node);
        for (std::size_t d = 0; d < 2; ++d)
            velocity_before_contact_[2 * n + d] = state_.nodes[n].v[d] - change[d];
    }
    ContactWorks works_before;
    for (std::size_t p = 0; p < pairs_.size(); ++p) {
        Pair& pair = pairs_[p];
        PairStatistics& statistics = statistics_.pairs[p];
        const RowSums contact = sum_rows(contact_->rows(p), pair.self);
        works_before.contact += contact.work_before;
        ledger.contact += contact.work;
        ledger.pair_work[p] += contact.work;
        pair.state = {};
        pair.state.force = contact.force;
        pair.state.active = contact.active;
        if (!ledger.pair_friction_work.empty()) {
            const RowSums friction = sum_rows(contact_->friction_rows(p), pair.self);
            works_before.friction += friction.work_before;
            ledger.friction += friction.work;
            ledger.pair_friction_work[p] += friction.work;
            for (std::size_t d = 0; d < 2; ++d) pair.state.force[d] += friction.force[d];
            pair.state.friction = friction.force;
            pair.state.sticking = contact_->sticking(p);
        }
        if (pair.state.active > 0) {
            pair.state.penetration = std::max(0.0, contact_->penetration(p, state_.nodes.data()));
            statistics.max_penetration = std::max(statistics.max_penetration, pair.state.penetration);
            statistics.peak_force =
                std::max(statistics.peak_force, std::hypot(pair.state.force[0], pair.state.force[1]));
            for (std::size_t d = 0; d < 2; ++d) statistics.impulse[d] += kick_ * pair.state.force[d];
            statistics.negative_forces += contact_->negative_forces(p);
        }
        count_events(p);
    }

    // Changes of velocity by contact, on the sums that the prediction made without it.
    for (const std::int32_t node : touched_) {
        const auto n = static_cast<std::size_t>(node);
        if (contact_impulse_[2 * n] == 0 && contact_impulse_[2 * n + 1] == 0) continue;  // seen already
        const double* before = &velocity_before_contact_[2 * n];
        for (std::size_t d = 0; d < 2; ++d) {
            const std::size_t k = 2 * n + d;
            const double impulse = contact_impulse_[k], change = inverse_mass_[k] * impulse;
            if (inverse_mass_[k] > 0) {
                sums.kinetic += before[d] * impulse;
                ledger.body_momentum[static_cast<std::size_t>(body_of_node_[n])][d] += impulse;
            } else {
                // An imposed velocity does not yield: its support takes the impulse and does the work.
                sums.external_before -= impulse / kick_ * before[d];
                sums.external_after -= impulse / kick_ * state_.nodes[n].v[d];
                if (!driven_.empty() && driven_[k])
                    drive_[static_cast<std::size_t>(body_of_node_[n])][d] -= impulse / kick_;
            }
            if (!setup_->scene.lagged) sums.internal_after += internal_[k] * change;
            if (!external_.empty()) sums.external_after += external_[k] * change;
            contact_impulse_[k] = 0;
        }
    }
    touched_.clear();
    return works_before;
}

void Solver::count_events(std::size_t index) {
    Pair& pair = pairs_[index];
    PairStatistics& statistics = statistics_.pairs[index];
    const RowSpan rows = contact_->rows(index);
    const bool was_active = !pair.active.empty();
    for (const ContactRow& row : rows) {
        if (row.force == 0) continue;
        char& flag = pair.flags[static_cast<std::size_t>(row.owner)];
        if (flag == 0) ++statistics.closings;  // a node may own several rows
        flag = static_cast<char>(flag | 2);
    }
    for (const std::int32_t owner : pair.active) {
        char& flag = pair.flags[static_cast<std::size_t>(owner)];
        if ((flag & 2) == 0) ++statistics.openings;
        flag = static_cast<char>(flag & 2);
    }
    pair.active.clear();
    for (const ContactRow& row : rows) {
        char& flag = pair.flags[static_cast<std::size_t>(row.owner)];
        if (row.force == 0 || flag == 1) continue;
        flag = 1;
        pair.active.push_back(row.owner);
    }
    if (was_active != !pair.active.empty()) ++statistics.events;
}

std::optional<Divergence> Solver::close_ledger() {
    Ledger& ledger = state_.ledger;
    const double contact = ledger.contact, friction = ledger.friction;
    if (!supports_.empty() || !external_.empty()) account_external_impulse();
    const ContactWorks before = pairs_.empty() ? ContactWorks{} : account_contacts(sums_);
    statistics_.contact_energy_in += scale_ * std::max(0.0, ledger.contact - contact);

    const double half = 0.5 * kick_;
    const double internal = ledger.internal + half * sums_.internal_before;
    const double loads = ledger.loads + half * sums_.external_before;
    ledger.internal += half * (sums_.internal_before + sums_.internal_after);
    ledger.loads += half * (sums_.external_before + sums_.external_after);
    const double kinetic = 0.5 * sums_.kinetic, total = kinetic + internal - loads + stored_in_contact_;
    ledger.largest_kinetic = std::max(ledger.largest_kinetic, kinetic);
    ledger.growth = std::max(ledger.growth, total - ledger.lowest);
    ledger.lowest = std::min(ledger.lowest, total);
    ledger.loss = std::max(ledger.loss, ledger.initial_kinetic - total);
    ledger.largest_load = std::max(ledger.largest_load, std::abs(loads));

    Energies& energy = ledger.present;
    energy.kinetic = scale_ * kinetic;
    energy.internal = scale_ * internal;
    energy.hourglass = scale_ * ledger.hourglass;
    energy.viscous = scale_ * ledger.viscous;
    energy.plastic = scale_ * ledger.plastic;
    energy.contact = scale_ * (contact + before.contact);
    energy.friction = scale_ * (friction + before.friction);
    energy.external = scale_ * (ledger.initial_kinetic + loads);
    for (std::size_t body = 0; body < body_mass_.size(); ++body)
        for (std::size_t d = 0; d < 2; ++d)
            ledger.body_velocity[body][d] =
                0.5 * (momentum_before_[body][d] + ledger.body_momentum[body][d]) / body_mass_[body];
    fill_history_row();

    if (!std::isfinite(total)) {
        const Located where = locate_non_finite();
        return Divergence{where.name + " is no longer finite at " + moment(), where.cell};
    }
    const double reference = std::max({ledger.initial_kinetic, ledger.largest_load, rounding_energy_});
    if (total - ledger.initial_kinetic > setup_->scene.energy_growth_limit * reference) {
        const Located most = locate_most_energy();
        return Divergence{
            fmt::format("energy grew by {:.3g} % of the input at {}; the limit is {:.3g} %; most is in {}",
                        100 * (total - ledger.initial_kinetic) / reference, moment(),
                        100 * setup_->scene.energy_growth_limit, most.name),
            most.cell};
    }
    return std::nullopt;
}

std::optional<Divergence> Solver::internal_forces() {
    if (!setup_->scene.lagged) integrate_elements(state_.nodes.data());
    state_.strain_since_critical += largest_strain();
    state_.quiet_blocks += regions_.quiet();
    state_.time += state_.dt;
    ++state_.step;
    double inverted = 0;
    Ledger& ledger = state_.ledger;
    for (std::size_t k = 0; k < element_sums_.size(); ++k) {
        const KernelSums& sums = element_sums_[k];
        Ledger::Works works;
        for (int lane = 0; lane < block_lanes; ++lane) {
            works.hourglass += sums.hourglass[lane];
            works.viscous += sums.viscous[lane];
            works.plastic += sums.plastic[lane];
            inverted += sums.inverted[lane];
        }
        ledger.hourglass += works.hourglass;
        ledger.viscous += works.viscous;
        ledger.plastic += works.plastic;
        ledger.body_works[static_cast<std::size_t>(element_chunks_[k].body)] += works;
    }
    if (inverted > 0) return locate_inverted();
    return std::nullopt;
}

/// Averaged triangles: volumes of the elements, then of the nodes, before any of their forces.
void Solver::average_nodal_volumes(const Node* nodes) {
    if (!averages_volumes_) return;
    team_.run([&](int part) {
        const auto [begin, end] = share_of(element_chunks_.size(), part, team_.size());
        for (std::size_t k = begin; k < end; ++k) {
            const QuietRegions::Chunk& chunk = element_chunks_[k];
            Batch& batch = batches_[static_cast<std::size_t>(chunk.body)];
            if (batch.kernel.volumes) batch.kernel.volumes(batch, nodes, chunk.begin, chunk.end);
        }
    });
    team_.run([&](int part) {
        const auto [begin, end] = share_of(node_chunks_.size(), part, team_.size());
        for (std::size_t k = begin; k < end; ++k) {
            const QuietRegions::Chunk& chunk = node_chunks_[k];
            Batch& batch = batches_[static_cast<std::size_t>(chunk.body)];
            if (batch.kernel.volumes) sum_nodal_volumes(batch, chunk.begin, chunk.end);
        }
    });
}

void Solver::integrate_elements(const Node* nodes) {
    average_nodal_volumes(nodes);
    team_.run([&](int part) {
        const auto [begin, end] = share_of(element_chunks_.size(), part, team_.size());
        for (std::size_t k = begin; k < end; ++k) {
            Batch& batch = batches_[static_cast<std::size_t>(element_chunks_[k].body)];
            element_sums_[k] = {};
            for (const auto& [first, last] : regions_.blocks(k))
                batch.kernel.forces(batch, nodes, state_.dt, first, last, element_sums_[k]);
        }
    });
    if (!layers_.none()) damp_contact_layers(nodes);
}

void Solver::damp_contact_layers(const Node* nodes) {
    Ledger& ledger = state_.ledger;
    layers_.add(batches_, nodes, state_.dt, state_.layer_pressure, [&](std::size_t body, double work) {
        ledger.viscous += work;
        ledger.body_works[body].viscous += work;
    });
}

std::string Solver::moment() const {
    const auto unit = setup_->scene.units.display(Quantity::time, state_.time);
    return fmt::format("{:.6g} {}", state_.time * unit.scale, unit.label);
}

std::string Solver::element_name(const Batch& batch, std::int32_t element) const {
    return fmt::format("element {} of body '{}'", element,
                       setup_->mesh.bodies[static_cast<std::size_t>(batch.body)].name);
}

Divergence Solver::locate_inverted() const {
    const Node* nodes = setup_->scene.lagged ? state_.lagged_nodes.data() : state_.nodes.data();
    for (const Batch& batch : batches_) {
        for (std::int32_t e = 0; e < batch.count; ++e) {
            const Cell& cell = setup_->mesh.cells[static_cast<std::size_t>(batch.cell_begin + e)];
            if (is_inverted(cell, nodes, batch.kind, batch.geometry))
                return {element_name(batch, e) + " turned inside out at " + moment(), batch.cell_begin + e};
        }
    }
    return {"an element turned inside out at " + moment(), -1};
}

Solver::Located Solver::locate_non_finite() const {
    for (const Batch& batch : batches_) {
        for (std::int32_t e = 0; e < batch.count; ++e) {
            for (const std::int32_t node :
                 setup_->mesh.cells[static_cast<std::size_t>(batch.cell_begin + e)]) {
                if (node < 0) continue;
                const auto& [x, v] = state_.nodes[static_cast<std::size_t>(node)];
                if (!std::isfinite(x[0] + x[1] + v[0] + v[1]))
                    return {element_name(batch, e), batch.cell_begin + e};
            }
        }
    }
    return {"the energy", -1};
}

Solver::Located Solver::locate_most_energy() const {
    Located found;
    double most = -1;
    for (const Batch& batch : batches_) {
        for (std::int32_t e = 0; e < batch.count; ++e) {
            const double stored = stored_energy(batch, state_.nodes.data(), e);
            if (stored > most) {
                most = stored;
                found = {element_name(batch, e), batch.cell_begin + e};
            }
        }
    }
    return found;
}

void Solver::fill_history_row() {
    const bool axisymmetric = setup_->scene.geometry == Geometry::axisymmetric;
    const std::size_t first = axisymmetric ? 1 : 0, second = 1 - first;
    auto to = row_.begin();
    const auto put = [&](double value) { *to++ = value; };
    put(state_.time);
    for (std::size_t p = 0; p < pairs_.size(); ++p) {
        const Pair& pair = pairs_[p];
        put(pair.state.force[first]);
        put(pair.state.force[second]);
        put(pair.state.active);
        put(pair.state.penetration);
        put(static_cast<double>(statistics_.pairs[p].openings + statistics_.pairs[p].closings));
        if (setup_->scene.contacts[p].friction > 0) {
            put(pair.state.friction[first]);
            put(pair.state.friction[second]);
            put(pair.state.sticking);
        }
    }
    for (const auto& velocity : state_.ledger.body_velocity) {
        put(velocity[first]);
        put(velocity[second]);
    }
    for (std::size_t body = 0; body < drive_.size(); ++body)
        for (const std::size_t d : {first, second})
            if (is_prescribed(setup_->scene.bodies[body], d)) put(scale_ * drive_[body][d]);
    const Energies& e = state_.ledger.present;
    for (const double energy :
         {e.kinetic, e.internal, e.hourglass, e.viscous, e.plastic, e.contact, e.external, e.balance()})
        put(energy);
    if (!state_.ledger.pair_friction_work.empty()) put(e.friction);
    put(state_.dt);
    put(critical_step_with_contact());
    for (std::size_t k = 0; k < probes_.size(); ++k) {
        const ProbeReading& probe = probes_[k];
        put(probe.cell >= 0 ? probe_values_[k]
                            : read_node(probe, probe_nodes_[k],
                                        state_.nodes[static_cast<std::size_t>(probe.node)], setup_->mesh));
    }
}

}  // namespace percuss
