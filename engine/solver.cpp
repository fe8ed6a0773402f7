#include "solver.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>
#include <numeric>

#include <fmt/format.h>

#include "contact/joint/make_rows.hpp"
#include "contact/joint/massless_layer.hpp"
#include "mesh/build.hpp"
#include "run/fields.hpp"
#include "run/history_columns.hpp"
#include "run/state_hash.hpp"
#include "scene/parse.hpp"

namespace percuss {
namespace {

constexpr std::int32_t nodes_per_chunk = 512;
constexpr std::int32_t blocks_per_chunk = 32;
/// Below this many elements a second thread costs more in waiting than it saves.
constexpr std::int32_t elements_worth_a_thread = 1500;

std::shared_ptr<const RunSetup> make_setup(Scene scene) {
    auto setup = std::make_shared<RunSetup>();
    setup->mesh = build_mesh(scene);
    check_mesh(scene, setup->mesh);
    setup->scene = std::move(scene);
    return setup;
}

int useful_threads(int wanted, std::int32_t cells) {
    const auto most = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
    return std::clamp(std::min(wanted, cells / elements_worth_a_thread), 1, most);
}

}  // namespace

Solver::Solver(Scene scene, int threads)
    : setup_(make_setup(std::move(scene))),
      in_force_(std::make_shared<const InFlight>(in_flight(setup_->scene))),
      team_(useful_threads(threads, setup_->mesh.cell_count())),
      imposed_(impose_motion(setup_->scene, setup_->mesh)),
      loads_(setup_->scene, setup_->mesh),
      contact_scheme_(setup_->scene.contact_solver.scheme),
      probes_(bind_probes(setup_->scene, setup_->mesh)) {
    const Scene& s = setup_->scene;
    scale_ = s.geometry == Geometry::axisymmetric ? 2 * std::numbers::pi : s.thickness;
    for (std::size_t body = 0; body < s.bodies.size(); ++body)
        batches_.push_back(make_batch(s, setup_->mesh, static_cast<std::int32_t>(body), imposed_.held));
    layers_ = LayerViscosity(s, setup_->mesh, batches_);
    state_.layer_pressure.assign(layers_.size(), 0);
    averages_volumes_ = std::any_of(batches_.begin(), batches_.end(),
                                    [](const Batch& batch) { return batch.kernel.volumes != nullptr; });
    build_nodes();
    build_chunks();
    contact_ = make_contact_method(s, setup_->mesh, contact_scheme_);
    pairs_.resize(s.contacts.size());
    for (std::size_t p = 0; p < pairs_.size(); ++p) pairs_[p].self = is_self_contact(s.contacts[p]);
    for (std::size_t p = 0; p < pairs_.size(); ++p) {
        const PairSurfaces surfaces = pair_surfaces(s, setup_->mesh, s.contacts[p]);
        pairs_[p].flags.assign(surfaces.master.nodes.size() + surfaces.slave.nodes.size(), 0);
        pairs_[p].active.reserve(pairs_[p].flags.size());
    }
    if (!loads_.none()) external_.assign(2 * mass_.size(), 0);
    if (!imposed_.prescribed.empty()) {
        imposed_change_.assign(2 * mass_.size(), 0);
        driven_.assign(2 * mass_.size(), 0);
        for (const auto& p : imposed_.prescribed)
            driven_[2 * static_cast<std::size_t>(p.node) + static_cast<std::size_t>(p.direction)] = p.acts;
        drive_.assign(s.bodies.size(), {0, 0});
    }
    if (!massless_.empty()) imposed_change_.resize(2 * mass_.size(), 0);
    if (!pairs_.empty()) {
        contact_impulse_.assign(2 * mass_.size(), 0);
        velocity_before_contact_.assign(2 * mass_.size(), 0);
    }
    if (s.lagged) state_.lagged_nodes = state_.nodes;
    probe_values_.resize(probes_.size());
    probe_nodes_.resize(probes_.size());
    row_.resize(history_columns(s).size());

    Ledger& ledger = state_.ledger;
    ledger.body_momentum.assign(s.bodies.size(), {0, 0});
    ledger.body_velocity.assign(s.bodies.size(), {0, 0});
    ledger.pair_work.assign(pairs_.size(), 0);
    if (has_friction(setup_->scene)) ledger.pair_friction_work.assign(pairs_.size(), 0);
    ledger.body_works.resize(s.bodies.size());
    statistics_.cells = setup_->mesh.cell_count();
    statistics_.threads = team_.size();
    statistics_.pairs.resize(pairs_.size());
    highest_.resize(static_cast<std::size_t>(team_.size()));
    find_quiet_regions({});
    evaluate_critical_step();
    look_ahead_for_springs();
    check_fixed_step(in_force_->step);
    // Node by node: held and driven nodes do not have their body's velocity; nodes of walls belong to no
    // body.
    for (std::size_t n = 0; n < body_of_node_.size(); ++n) {
        const auto body = static_cast<std::size_t>(body_of_node_[n]);
        const double* v = state_.nodes[n].v;
        for (std::size_t d = 0; d < 2; ++d) ledger.body_momentum[body][d] += mass_[n] * v[d];
        statistics_.momentum_scale += scale_ * mass_[n] * std::hypot(v[0], v[1]);
        ledger.initial_kinetic += 0.5 * mass_[n] * (v[0] * v[0] + v[1] * v[1]);
    }
    for (std::size_t body = 0; body < s.bodies.size(); ++body) {
        for (std::size_t d = 0; d < 2; ++d) {
            ledger.body_velocity[body][d] = ledger.body_momentum[body][d] / body_mass_[body];
            statistics_.momentum_initial[d] += scale_ * ledger.body_momentum[body][d];
        }
    }
    ledger.lowest = ledger.largest_kinetic = ledger.initial_kinetic;
    ledger.present.kinetic = ledger.present.external = scale_ * ledger.initial_kinetic;
    statistics_.initial_energy = scale_ * ledger.initial_kinetic;
    statistics_.angular_momentum_initial = angular_momentum();
}

void Solver::build_nodes() {
    const Mesh& mesh = setup_->mesh;
    const Scene& scene = setup_->scene;
    const std::size_t count = mesh.nodes.size();
    state_.nodes.resize(count);
    mass_.assign(count, 0);
    internal_.assign(2 * count, 0);
    for (std::size_t body = 0; body < mesh.bodies.size(); ++body) {
        const MeshBody& part = mesh.bodies[body];
        const auto& velocity = scene.bodies[body].velocity;
        for (auto node = static_cast<std::size_t>(part.node_begin);
             node < static_cast<std::size_t>(part.node_end); ++node)
            // Not -0, which a first step at rest would turn into 0.
            state_.nodes[node] = {{mesh.nodes[node].x() + 0.0, mesh.nodes[node].y() + 0.0},
                                  {velocity[0], velocity[1]}};
        for (std::int32_t cell = part.cell_begin; cell < part.cell_end; ++cell) {
            const Cell& corners = mesh.cells[static_cast<std::size_t>(cell)];
            const auto share =
                corner_masses(corners, mesh.nodes, batches_[body].material.density, scene.geometry);
            for (std::size_t i = 0; i < static_cast<std::size_t>(corner_count(corners)); ++i)
                mass_[static_cast<std::size_t>(corners[i])] += share[i];
        }
        body_of_node_.insert(body_of_node_.end(), static_cast<std::size_t>(part.node_end - part.node_begin),
                             static_cast<std::int32_t>(body));
        body_mass_.push_back(
            std::accumulate(mass_.begin() + part.node_begin, mass_.begin() + part.node_end, 0.0));
    }
    std::vector<char> massless(count, 0);
    if (scene.contact_solver.scheme == ContactScheme::massless && !scene.contacts.empty()) {
        const MasslessLayer layer(scene, mesh);
        layer.move_mass(mass_);
        for (const MasslessLayer::LayerNode& of : layer.nodes()) {
            massless[static_cast<std::size_t>(of.node)] = 1;
            for (std::size_t d = 0; d < 2; ++d)
                if (of.unknown[d] >= 0) massless_.push_back(2 * static_cast<std::size_t>(of.node) + d);
        }
    }
    inverse_mass_.resize(2 * count);
    for (const Edge& wall : mesh.walls)
        for (const std::int32_t node : wall.nodes) {
            const Vec2& x = mesh.nodes[static_cast<std::size_t>(node)];
            state_.nodes[static_cast<std::size_t>(node)] = {{x.x(), x.y()}, {0, 0}};
        }
    for (std::size_t node = 0; node < count; ++node) {
        for (std::size_t d = 0; d < 2; ++d) {
            inverse_mass_[2 * node + d] = imposed_.held[node][d] || mass_[node] == 0 ? 0 : 1 / mass_[node];
            if (imposed_.held[node][d]) state_.nodes[node].v[d] = 0;
            if (imposed_.held[node][d] || (inverse_mass_[2 * node + d] == 0 && !massless[node]))
                supports_.push_back(2 * node + d);
        }
    }
    for (const auto& p : imposed_.prescribed)
        supports_.push_back(2 * static_cast<std::size_t>(p.node) + static_cast<std::size_t>(p.direction));
    std::sort(supports_.begin(), supports_.end());
    supports_.erase(std::unique(supports_.begin(), supports_.end()), supports_.end());
    // Radial forces on a ring cancel: they carry no momentum of the whole.
    if (scene.geometry == Geometry::axisymmetric)
        std::erase_if(supports_, [](std::size_t k) { return k % 2 == 0; });
    for (const auto& p : imposed_.prescribed)
        if (p.acts)
            state_.nodes[static_cast<std::size_t>(p.node)].v[p.direction] =
                imposed_.motions[static_cast<std::size_t>(p.motion)].velocity(0);

    for (const Batch& batch : batches_)
        rounding_energy_ += 1e-24 * body_mass_[static_cast<std::size_t>(batch.body)] * batch.material.p_wave /
                            batch.material.density;

    // Where each node finds its corner forces: cells in mesh order, so that sums do not depend on threads.
    std::vector<std::vector<const double*>> of_node(count);
    for (const Batch& batch : batches_) {
        for (std::int32_t element = 0; element < batch.count; ++element) {
            for (int corner = 0; corner < batch.corners; ++corner) {
                const auto at = static_cast<std::size_t>(
                    ((element / block_lanes) * batch.corners + corner) * block_lanes + element % block_lanes);
                of_node[static_cast<std::size_t>(batch.nodes[at])].push_back(batch.force.data() + 2 * at);
            }
        }
    }
    corner_begin_.assign(1, 0);
    for (const auto& list : of_node) {
        corners_.insert(corners_.end(), list.begin(), list.end());
        corner_begin_.push_back(static_cast<std::int32_t>(corners_.size()));
    }
}

void Solver::build_chunks() {
    for (std::size_t body = 0; body < batches_.size(); ++body) {
        const MeshBody& part = setup_->mesh.bodies[body];
        for (std::int32_t begin = part.node_begin; begin < part.node_end; begin += nodes_per_chunk)
            node_chunks_.push_back(
                {static_cast<std::int32_t>(body), begin, std::min(begin + nodes_per_chunk, part.node_end)});
        for (int begin = 0; begin < batches_[body].blocks(); begin += blocks_per_chunk)
            element_chunks_.push_back({static_cast<std::int32_t>(body), begin,
                                       std::min(begin + blocks_per_chunk, batches_[body].blocks())});
    }
    node_sums_.resize(node_chunks_.size());
    element_sums_.resize(element_chunks_.size());
    regions_ = QuietRegions(element_chunks_, node_chunks_);
}

void Solver::find_quiet_regions(const std::vector<char>& visited) {
    std::fill(internal_.begin(), internal_.end(), 0.0);
    // Here others than its own nodes move or load an element.
    if (setup_->scene.lagged || !layers_.none() || !massless_.empty()) return regions_.visit_all();
    std::vector<char> busy(body_of_node_.size(), 0);
    for (std::size_t n = 0; n < busy.size(); ++n) {
        const auto& [x, v] = state_.nodes[n];
        const Vec2& first = setup_->mesh.nodes[n];
        const bool averaged = batches_[static_cast<std::size_t>(body_of_node_[n])].kernel.volumes != nullptr;
        busy[n] = averaged || v[0] != 0 || v[1] != 0 || x[0] != first.x() || x[1] != first.y();
    }
    loads_.mark_loaded(busy);
    for (const auto& p : imposed_.prescribed) busy[static_cast<std::size_t>(p.node)] = 1;
    regions_.find(batches_, busy, visited);
}

void Solver::check_fixed_step(const StepSize& step) {
    if (!step.fixed) return;
    const bool known = bounds_elements(*state_.critical_of);
    const double critical = known ? critical_step_with_contact() : critical_step_of_elements();
    if (*step.fixed <= critical) return;
    const bool springs = known && critical < state_.critical_step;
    const Scene& scene = setup_->scene;
    const auto unit = scene.units.display(Quantity::time, *step.fixed);
    throw SceneError(
        {fmt::format("{}: time step {:.6g} {} is above the critical step{}; at most {:.6g} {} is stable",
                     describe_place(scene, step.place), *step.fixed * unit.scale, unit.label,
                     springs ? " with the springs of contact" : "", critical * unit.scale, unit.label)});
}

/// Whether a critical step that was found with these values is that of the values in force.
bool Solver::bounds_elements(const InFlight& values) const {
    if (&values == in_force_.get()) return true;
    for (std::size_t b = 0; b < values.bodies.size(); ++b) {
        const InFlight::OfBody &old = values.bodies[b], &now = in_force_->bodies[b];
        if (old.viscosity != now.viscosity || old.hourglass != now.hourglass) return false;
    }
    return true;
}

void Solver::take_up(const InFlight& values) {
    for (std::size_t b = 0; b < batches_.size(); ++b) {
        const InFlight::OfBody& of = values.bodies[b];
        ElasticConstants& material = batches_[b].material;
        if (of.viscosity) {
            material.viscosity_linear = of.viscosity->linear;
            material.viscosity_quadratic = of.viscosity->quadratic;
        }
        material.hourglass = of.hourglass;
    }
    if (contact_) contact_->change(values.friction, values.contact_solver);
    if (!loads_.none()) {
        Scene scene = setup_->scene;
        for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
            scene.bodies[b].body_force = values.bodies[b].body_force;
            scene.bodies[b].loads = values.bodies[b].loads;
        }
        loads_ = Loads(scene, setup_->mesh);
        if (!regions_.none()) find_quiet_regions(regions_.visited());
    }
}

void Solver::change(std::shared_ptr<const InFlight> values) {
    if (*values == *in_force_) return;
    take_up(*values);
    in_force_.swap(values);
    try {
        check_fixed_step(in_force_->step);
    } catch (const SceneError&) {
        take_up(*values);
        in_force_.swap(values);
        throw;
    }
}

void Solver::make_contact(ContactScheme scheme) {
    contact_scheme_ = scheme;
    contact_ = make_contact_method(setup_->scene, setup_->mesh, scheme);
    contact_->change(in_force_->friction, in_force_->contact_solver);
}

/// The new method knows positions and velocities only, as at the start of a run, and which master nodes had
/// force. Not before the next step: until then the old one holds the forces of the last one.
void Solver::switch_contact() {
    make_contact(in_force_->contact_solver.scheme);
    std::vector<std::vector<std::int32_t>> active;
    for (const Pair& pair : pairs_) active.push_back(pair.active);
    contact_->restart(active);
}

/// The springs of surfaces that touch from the start count in the first step, before there were any rows.
void Solver::look_ahead_for_springs() {
    state_.contact_frequency = 0;
    if (!contact_ || contact_scheme_ != ContactScheme::penalty) return;
    AlignedVector<Node> nodes = state_.nodes;
    for (Node& node : nodes)
        for (std::size_t d = 0; d < 2; ++d) node.x[d] += state_.critical_step * node.v[d];
    RunStatistics unused;
    PredictedMotion motion{state_.critical_step, state_.critical_step,    nodes.data(),
                           inverse_mass_.data(), contact_impulse_.data(), &touched_};
    contact_->resolve(motion, unused);
    state_.contact_frequency = motion.squared_frequency;
    std::fill(contact_impulse_.begin(), contact_impulse_.end(), 0.0);
    touched_.clear();
    contact_->restart(std::vector<std::vector<std::int32_t>>(pairs_.size()));
}

bool Solver::finished() const { return state_.time >= setup_->scene.duration * (1 - 1e-12); }

double Solver::angular_momentum() const {
    if (setup_->scene.geometry == Geometry::axisymmetric) return 0;
    double sum = 0;
    for (std::size_t n = 0; n < mass_.size(); ++n) {
        const Node& node = state_.nodes[n];
        sum += mass_[n] * (node.x[0] * node.v[1] - node.x[1] * node.v[0]);
    }
    return scale_ * sum;
}

std::shared_ptr<Snapshot> Solver::snapshot() const {
    auto snapshot = std::make_shared<Snapshot>();
    snapshot->setup = setup_;
    snapshot->time = state_.time;
    snapshot->step = state_.step;
    snapshot->dt = state_.dt;
    snapshot->critical_step = critical_step_with_contact();
    snapshot->position.reserve(2 * state_.nodes.size());
    snapshot->velocity.reserve(2 * state_.nodes.size());
    snapshot->stress.reserve(setup_->mesh.cells.size());
    for (const Node& node : state_.nodes) {
        snapshot->position.insert(snapshot->position.end(), {node.x[0], node.x[1]});
        snapshot->velocity.insert(snapshot->velocity.end(), {node.v[0], node.v[1]});
    }
    for (const Batch& batch : batches_)
        for (std::int32_t element = 0; element < batch.count; ++element)
            snapshot->stress.push_back(mean_stress(batch, state_.nodes.data(), element));
    add_plastic_fields(*snapshot);
    add_contacts(snapshot.get());
    for (std::size_t body = 0; body < body_mass_.size(); ++body) {
        const auto& momentum = state_.ledger.body_momentum[body];
        snapshot->bodies.push_back({{momentum[0] / body_mass_[body], momentum[1] / body_mass_[body]}});
    }
    snapshot->body_energies = body_energies();
    snapshot->energy = state_.ledger.present;
    return snapshot;
}

void Solver::add_contacts(Snapshot* snapshot) const {
    std::vector<ContactForce>& forces = snapshot->contact_forces;
    for (std::size_t p = 0; p < pairs_.size(); ++p) {
        snapshot->pairs.push_back(pairs_[p].state);
        const auto begin = static_cast<std::ptrdiff_t>(forces.size());
        for (const RowSpan& rows : {contact_->rows(p), contact_->friction_rows(p)}) {
            for (const ContactRow& row : rows) {
                std::int32_t k = 0;
                for (const RowTerm& term : rows.terms(row)) {
                    const bool master = k++ < row.master_terms;
                    const double force = scale_ * row.force;
                    if (force == 0 || term.node >= static_cast<std::int32_t>(body_of_node_.size()) ||
                        (term.g[0] == 0 && term.g[1] == 0))
                        continue;  // a wall's end
                    forces.push_back({term.node,
                                      static_cast<std::int32_t>(p),
                                      master,
                                      {force * term.g[0], force * term.g[1]}});
                }
            }
        }
        // One force for each node of either side.
        const auto key = [](const ContactForce& f) { return std::pair(!f.master, f.node); };
        std::sort(forces.begin() + begin, forces.end(),
                  [&](const ContactForce& a, const ContactForce& b) { return key(a) < key(b); });
        auto last = forces.begin() + begin;
        for (auto next = last; next != forces.end(); ++next) {
            if (next == last) continue;
            if (key(*next) == key(*last)) {
                for (std::size_t d = 0; d < 2; ++d) last->force[d] += next->force[d];
            } else {
                *++last = *next;
            }
        }
        if (last != forces.end()) forces.erase(last + 1, forces.end());
    }
}

void Solver::add_plastic_fields(Snapshot& snapshot) const {
    const Scene& scene = setup_->scene;
    if (!has_plasticity(scene)) return;
    const auto ambient = ambient_temperature(scene);
    for (const Batch& batch : batches_) {
        const bool heats = batch.kernel.law_size > 2;
        for (std::int32_t element = 0; element < batch.count; ++element) {
            const PlasticState state = plastic_state(batch, state_.nodes.data(), element);
            snapshot.plastic_strain.push_back(state.strain);
            snapshot.yield_stress.push_back(state.yield);
            if (ambient) snapshot.temperature.push_back(heats ? state.temperature : *ambient);
        }
    }
}

std::vector<BodyEnergies> Solver::body_energies() const {
    std::vector<BodyEnergies> bodies(batches_.size());
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        BodyEnergies& energy = bodies[b];
        const Ledger::Works& works = state_.ledger.body_works[b];
        energy.plastic = scale_ * works.plastic;
        energy.hourglass = scale_ * works.hourglass;
        energy.viscous = scale_ * works.viscous;
        for (std::int32_t element = 0; element < batches_[b].count; ++element)
            energy.elastic += scale_ * stored_energy(batches_[b], state_.nodes.data(), element);
        const MeshBody& part = setup_->mesh.bodies[b];
        for (auto n = static_cast<std::size_t>(part.node_begin); n < static_cast<std::size_t>(part.node_end);
             ++n) {
            const auto& v = state_.nodes[n].v;
            energy.kinetic += 0.5 * scale_ * mass_[n] * (v[0] * v[0] + v[1] * v[1]);
        }
    }
    return bodies;
}

RunStatistics Solver::statistics(bool complete) const {
    RunStatistics statistics = statistics_;
    const Ledger& ledger = state_.ledger;
    const double reference = std::max(ledger.initial_kinetic, ledger.largest_load);  // what was put in
    statistics.steps = state_.step;
    double blocks = 0;
    for (const Batch& batch : batches_) blocks += batch.blocks();
    if (state_.step > 0)
        statistics.visited_share =
            1 - static_cast<double>(state_.quiet_blocks) / (blocks * static_cast<double>(state_.step));
    const PhaseSeconds& seconds = statistics.seconds;
    statistics.step_seconds = seconds.elements + seconds.contact_search + seconds.contact_solve +
                              seconds.integrate + seconds.critical_step + seconds.loads + seconds.probes;
    statistics.initial_energy = scale_ * ledger.initial_kinetic;
    if (reference > 0) {
        statistics.maximum_growth = ledger.growth / reference;
        statistics.maximum_loss = ledger.loss / reference;
        if (complete) statistics.elastic_energy_error = strain_energy_error() / reference;
    }
    for (std::size_t p = 0; p < pairs_.size(); ++p) statistics.pairs[p].work = scale_ * ledger.pair_work[p];
    for (std::size_t p = 0; p < ledger.pair_friction_work.size(); ++p)
        statistics.pairs[p].friction_work = scale_ * ledger.pair_friction_work[p];
    for (const auto& momentum : ledger.body_momentum)
        for (std::size_t d = 0; d < 2; ++d) statistics.momentum_final[d] += scale_ * momentum[d];
    statistics.angular_momentum_final = angular_momentum();
    if (!complete) return statistics;
    statistics.bodies = body_energies();
    std::uint64_t hash = hash_bytes(state_.nodes.data(), state_.nodes.size() * sizeof(Node));
    for (const Batch& batch : batches_)
        hash = hash_bytes(batch.state.data(), batch.state.size() * sizeof(double), hash);
    statistics.state_hash = hash_text(hash);
    return statistics;
}

double Solver::strain_energy_error() const {
    double stored = 0, work = 0;
    for (const Batch& batch : batches_) {
        for (std::int32_t element = 0; element < batch.count; ++element) {
            stored += stored_energy(batch, state_.nodes.data(), element);
            // The half of the present internal forces' work that the ledger books with the next step.
            for (int corner = 0; corner < batch.corners; ++corner) {
                const auto at = static_cast<std::size_t>(
                    ((element / block_lanes) * batch.corners + corner) * block_lanes + element % block_lanes);
                const Node& node = state_.nodes[static_cast<std::size_t>(batch.nodes[at])];
                work += batch.force[2 * at] * node.v[0] + batch.force[2 * at + 1] * node.v[1];
            }
        }
    }
    const Ledger& ledger = state_.ledger;
    return std::abs(ledger.internal + 0.5 * state_.dt * work - ledger.hourglass - ledger.viscous -
                    ledger.plastic - stored);
}

SolverState Solver::save() const {
    SolverState state = state_;
    state.statistics = statistics_;
    state.in_force = in_force_;
    state.contact_scheme = contact_scheme_;
    state.visited = regions_.visited();
    for (const Pair& pair : pairs_) {
        state.active.push_back(pair.active);
        state.pairs.push_back(pair.state);
    }
    if (contact_) state.contact = contact_->copy();
    for (const Batch& batch : batches_) {
        state.element_state.push_back(batch.state);
        state.corner_force.push_back(batch.force);
    }
    return state;
}

void Solver::restore(const SolverState& state) {
    for (std::size_t b = 0; b < batches_.size(); ++b) {
        // Copied in place: nodes point into the corner forces.
        std::copy(state.element_state[b].begin(), state.element_state[b].end(), batches_[b].state.begin());
        std::copy(state.corner_force[b].begin(), state.corner_force[b].end(), batches_[b].force.begin());
    }
    const PhaseSeconds spent = statistics_.seconds;  // wall time does not go back
    statistics_ = state.statistics;
    statistics_.seconds = spent;
    if (state.in_force != in_force_) {
        take_up(*state.in_force);
        in_force_ = state.in_force;
    }
    state_ = state;
    state_.in_force.reset();
    state_.element_state.clear();
    state_.corner_force.clear();
    state_.active.clear();
    state_.pairs.clear();
    state_.contact.reset();
    state_.visited.clear();
    if (state.visited.empty())
        regions_.visit_all();
    else
        find_quiet_regions(state.visited);
    if (contact_ && state.contact_scheme != contact_scheme_) make_contact(state.contact_scheme);
    if (contact_ && state.contact) contact_->become(*state.contact);
    if (contact_ && !state.contact) contact_->restart(state.active);
    average_nodal_volumes(setup_->scene.lagged ? state_.lagged_nodes.data() : state_.nodes.data());
    for (std::size_t p = 0; p < pairs_.size(); ++p) {
        Pair& pair = pairs_[p];
        pair.state = state.contact ? state.pairs[p] : PairState{};
        pair.active = state.active[p];
        std::fill(pair.flags.begin(), pair.flags.end(), char{0});
        for (const std::int32_t owner : pair.active) pair.flags[static_cast<std::size_t>(owner)] = 1;
    }
}

}  // namespace percuss
