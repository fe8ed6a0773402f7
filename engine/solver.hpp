#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "contact/contact_method.hpp"
#include "dynamics/ledger.hpp"
#include "dynamics/loads.hpp"
#include "dynamics/quiet_regions.hpp"
#include "dynamics/team.hpp"
#include "elements/batch.hpp"
#include "elements/layer_viscosity.hpp"
#include "run/history.hpp"
#include "run/in_flight.hpp"
#include "run/phase_timer.hpp"
#include "run/probes.hpp"
#include "run/snapshot.hpp"
#include "run/statistics.hpp"

namespace percuss {

/// All that changes from step to step: enough to go on from, bit by bit.
struct SolverState {
    AlignedVector<Node> nodes;
    std::vector<AlignedVector<double>> element_state, corner_force;  ///< per batch
    AlignedVector<Node>
        lagged_nodes;  ///< lagged mode: where stresses were last evaluated, and the motion that led there
    Ledger ledger;
    RunStatistics statistics;                       ///< filled by save()
    std::vector<std::vector<std::int32_t>> active;  ///< per pair: owners of rows with force; filled by save()
    std::vector<PairState> pairs;                   ///< of the last step; filled by save()
    /// What contact remembers between steps; filled by save(). Whoever changes positions resets it: restore()
    /// then lets contact begin anew.
    std::shared_ptr<const ContactMethod> contact;
    ContactScheme contact_scheme = ContactScheme::projection;  ///< of `contact`; filled by save()
    std::shared_ptr<const InFlight> in_force;     ///< values that can change in flight; filled by save()
    std::shared_ptr<const InFlight> critical_of;  ///< the values that critical_step was found with
    double time = 0, dt = 0, critical_step = 0;
    double contact_frequency = 0;        ///< squared, that springs of contact add to the elements' [1/time^2]
    std::vector<double> layer_pressure;  ///< of the viscosity in contact layers, per element of them [stress]
    std::int64_t step = 0;
    std::int64_t quiet_blocks = 0;  ///< that steps have left out, summed over them
    std::vector<char> visited;      ///< QuietRegions::visited; filled by save()
    double strain_since_critical =
        1;  ///< sum of the steps' largest strains since critical_step was evaluated
};

/// Why a run cannot go on.
struct Divergence {
    std::string message;
    std::int32_t cell = -1;  ///< of the mesh, that the message names; -1: it names none
};

/// The explicit dynamics of one scene, stepped by whoever calls step(). Not thread-safe; Engine wraps it in a
/// thread.
class Solver {
  public:
    /// @throws SceneError when the scene cannot be meshed or its fixed step is above the critical one.
    explicit Solver(Scene scene, int threads = 1);

    /// Advances the scene by one time step (step.cpp: read it first). @returns why the run cannot go on, if
    /// so; the state is then not usable until restore().
    std::optional<Divergence> step();
    [[nodiscard]] bool finished() const;
    /// Goes on with other values from the next step on; equal ones change nothing, bit by bit. @pre they
    /// are those of a scene by which this one's run can go on (effect_of_change). @throws SceneError when a
    /// fixed step would be above the critical one; nothing has changed then.
    void change(std::shared_ptr<const InFlight> values);
    /// The values in force.
    [[nodiscard]] const std::shared_ptr<const InFlight>& in_force() const { return in_force_; }

    [[nodiscard]] std::shared_ptr<const RunSetup> setup() const { return setup_; }
    [[nodiscard]] double time() const { return state_.time; }
    [[nodiscard]] std::int64_t steps() const { return state_.step; }
    [[nodiscard]] double critical_step() const { return state_.critical_step; }
    [[nodiscard]] std::shared_ptr<Snapshot> snapshot() const;
    /// The contact part of a snapshot: pair states and nodal contact forces of the last step.
    void add_contacts(Snapshot* snapshot) const;
    /// @param complete false leaves out what needs a pass over all elements: state hash, strain energy check.
    [[nodiscard]] RunStatistics statistics(bool complete = true) const;

    /// Numbers of the last step in the order of history_columns (run/history_columns.hpp).
    [[nodiscard]] std::span<const double> history_row() const { return row_; }

    /// From now on steps visit what is at rest, too: the bits stay the same (for comparisons).
    void visit_all() { regions_.visit_all(); }
    [[nodiscard]] SolverState save() const;
    /// @pre `state` comes from a solver of the same scene.
    void restore(const SolverState& state);
    [[nodiscard]] std::span<const Node> nodes() const { return state_.nodes; }
    /// 2 / omega_max of the undeformed mesh by power iteration on the assembled stiffness [time]; converges
    /// from above.
    [[nodiscard]] double critical_step_by_power_iteration(int most_iterations = 2000) const;
    [[nodiscard]] const std::vector<double>& lumped_mass() const {
        return mass_;
    }  ///< per radian or unit thickness
    [[nodiscard]] const std::vector<Batch>& batches() const { return batches_; }
    [[nodiscard]] double angular_momentum() const;  ///< about the origin, plane scenes; 0 when axisymmetric
    [[nodiscard]] double scale() const {
        return scale_;
    }  ///< 2 pi, or the thickness: per-radian numbers to whole ones

  private:
    /// What is counted about a pair.
    struct Pair {
        PairState state;
        bool self = false;                 // is_self_contact
        std::vector<std::int32_t> active;  // owners of rows with force in the last step
        std::vector<char> flags;           // per owner: 1 had force in the last step, 2 has it in this one
    };

    void build_nodes();
    void build_chunks();
    void find_quiet_regions(const std::vector<char>& visited);
    void check_fixed_step(const StepSize& step);
    void take_up(const InFlight& values);
    void make_contact(ContactScheme scheme);  // with the values in force
    void switch_contact();
    void look_ahead_for_springs();
    [[nodiscard]] bool bounds_elements(const InFlight& values) const;
    [[nodiscard]] double critical_step_of_elements();
    [[nodiscard]] double critical_step_with_contact() const;

    // The phases of a step, in order.
    void read_probes();
    std::optional<Divergence> choose_step(PhaseTimer& timer);
    void predict();
    void resolve_contacts();
    std::optional<Divergence> close_ledger();
    std::optional<Divergence> internal_forces();

    template <bool loaded>
    void predict_chunk(std::size_t chunk, NodeSums& sums);
    [[nodiscard]] double largest_strain() const;
    void switch_prescribed();
    void impose_velocities(NodeSums& sums);
    void stresses_at_predicted_positions();
    void integrate_elements(const Node* nodes);
    void damp_contact_layers(const Node* nodes);
    void average_nodal_volumes(const Node* nodes);
    void evaluate_critical_step();
    void start_half_step_early();
    void account_external_impulse();
    /// Of a pair's rows: resultant on the master body (of a body with itself, where action and reaction would
    /// cancel, the sum of their magnitudes by components), and works of the force in the step around it.
    struct RowSums {
        std::array<double, 2> force{0, 0};
        double work_before = 0, work = 0;
        int active = 0;
    };
    struct ContactWorks {
        double contact = 0, friction = 0;
    };
    [[nodiscard]] RowSums sum_rows(const RowSpan& rows, bool self) const;
    ContactWorks account_contacts(NodeSums& sums);
    void count_events(std::size_t pair);
    void fill_history_row();
    void add_plastic_fields(Snapshot& snapshot) const;
    [[nodiscard]] std::vector<BodyEnergies> body_energies() const;
    [[nodiscard]] Divergence locate_inverted() const;
    /// An element that a message can name.
    struct Located {
        std::string name;
        std::int32_t cell = -1;  // of the mesh
    };
    [[nodiscard]] Located locate_non_finite() const;
    [[nodiscard]] Located locate_most_energy() const;
    [[nodiscard]] std::string element_name(const Batch& batch, std::int32_t element) const;
    [[nodiscard]] std::string moment() const;  ///< the present time with its unit
    [[nodiscard]] double strain_energy_error() const;
    [[nodiscard]] ForcesOnNodes forces_on_nodes() const;

    std::shared_ptr<const RunSetup> setup_;
    std::shared_ptr<const InFlight> in_force_;
    double scale_ = 1;
    Team team_;
    SolverState state_;
    std::vector<Batch> batches_;
    LayerViscosity layers_;
    std::vector<QuietRegions::Chunk> node_chunks_, element_chunks_;  // of nodes; of blocks of elements
    QuietRegions regions_;
    std::vector<NodeSums> node_sums_;
    NodeSums sums_;
    std::vector<std::array<double, 2>> momentum_before_;  // per body
    std::vector<KernelSums> element_sums_;
    std::vector<double> highest_;  // per thread, squared frequency of its elements
    std::vector<double> mass_, body_mass_;
    double rounding_energy_ =
        0;  ///< of strains of 1e-12 in all bodies: a scene may wait at rest for its load
    std::vector<std::int32_t> body_of_node_;
    std::vector<double> inverse_mass_;         // 2 per node, 0 where the velocity is imposed
    std::vector<double> internal_, external_;  // 2 per node; external_ only when the scene has loads
    std::vector<std::int32_t> corner_begin_;   // per node: its range in corners_
    std::vector<const double*> corners_;       // pairs (fx, fy) among the batches' corner forces
    std::vector<std::size_t> supports_;  // 2 node + direction of velocities that may be imposed, and of walls
    ImposedMotion imposed_;
    // Of prescribed motion; empty when there is none.
    std::vector<double> imposed_change_;        // 2 per node: change of velocity in this step
    std::vector<char> driven_;                  // 2 per node: whether a prescribed motion acts
    std::vector<std::array<double, 2>> drive_;  // per body: force of what drives it [force]
    Loads loads_;
    std::unique_ptr<ContactMethod> contact_;  // null without pairs
    ContactScheme contact_scheme_;            // its
    std::vector<Pair> pairs_;
    std::vector<double> contact_impulse_;  // 2 per node, zero but during a step
    std::vector<std::int32_t> touched_;
    std::vector<double> velocity_before_contact_;  // 2 per node, of the touched ones
    std::vector<ProbeReading> probes_;
    std::vector<double> probe_values_;
    std::vector<Node> probe_nodes_;
    std::vector<std::size_t> massless_;  // velocity components of contact nodes without mass
    std::vector<double> row_;
    RunStatistics statistics_;
    double kick_ = 0;
    double stored_in_contact_ = 0;   // by its springs in this step, per radian or unit thickness
    bool averages_volumes_ = false;  // there are averaged triangles
};

}  // namespace percuss
