#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "run/snapshot.hpp"

namespace percuss {

/// Wall-clock seconds by phase of the run.
struct PhaseSeconds {
    double elements = 0;
    double contact_search = 0;
    double contact_solve = 0;
    double integrate = 0;      ///< kick, drift, boundary conditions, ledger
    double critical_step = 0;  ///< finding it anew, every some steps
    double loads = 0;          ///< body forces, pressures and tractions
    double probes = 0;         ///< reading them
    double history = 0;        ///< appending the full-rate histories, taking snapshots
    double record = 0;         ///< writing run.h5 and history.csv (filled by the recorder)
    double render = 0;         ///< drawing (filled by the renderer)
};

struct PairStatistics {
    double peak_force = 0;                ///< largest magnitude of PairState::force [force]
    std::array<double, 2> impulse{0, 0};  ///< time integral of PairState::force [impulse]
    std::int64_t events = 0;              ///< changes of the pair's state: no active node <-> some
    std::int64_t openings = 0, closings = 0;  ///< of master nodes, one count per node and change
    std::int64_t negative_forces = 0;         ///< rows whose unrestricted C came out negative
    double max_penetration = 0;               ///< largest penetration left after correction [length]
    double work = 0;           ///< work done on the bodies by this pair's contact forces [energy]
    double friction_work = 0;  ///< work done on the bodies by its friction forces [energy]
};

/// What the solver of the joint contact problem did.
struct ContactSolverStatistics {
    std::int64_t problems = 0;            ///< connected groups of rows solved
    std::int64_t iterations = 0;          ///< factorisations for them
    std::int64_t fallbacks = 0;           ///< of them, how many ended in projected Gauss-Seidel
    std::int64_t rows = 0;                ///< in all of them
    int most_iterations = 0;              ///< for one of them
    std::int32_t most_rows = 0;           ///< in one of them
    std::int64_t friction_solutions = 0;  ///< steps in which contact and friction were solved in turn
    std::int64_t friction_rounds = 0;     ///< rounds for them
    int most_friction_rounds = 0;         ///< in one of them
    std::int64_t unsettled = 0;           ///< of them, how many ended before friction had settled
};

/// What a run did, counted while it ran.
struct RunStatistics {
    std::int64_t steps = 0;
    std::int64_t cells = 0;
    /// Blocks of elements that steps visited, of all blocks in all steps: what no wave has reached yet is left out.
    double visited_share = 1;
    double step_seconds = 0;  ///< wall seconds spent stepping, all phases of the step
    double total_seconds =
        0;  ///< wall seconds of the whole job, drawing and writing included (filled by its driver)
    PhaseSeconds seconds;
    double dt_min = 0, dt_max = 0;
    double critical_step_initial = 0, critical_step_min = 0;
    double initial_energy = 0;
    double maximum_growth =
        0;  ///< largest rise of K + I - W_external above an earlier minimum / initial energy
    double maximum_loss = 0;  ///< largest fall of K + I - W_external below its initial value / initial energy
    double elastic_energy_error =
        0;  ///< |ledger's strain energy - the elements' own stored energy| / initial energy
    std::array<double, 2> momentum_initial{0, 0}, momentum_final{0, 0};
    double momentum_scale = 0;  ///< sum of m |v| at the start, what momentum errors are divided by
    std::array<double, 2> external_impulse{
        0, 0};                          ///< of loads, supports, prescribed motion and walls on the bodies
    double external_impulse_gross = 0;  ///< sum of its parts' magnitudes
    double angular_momentum_initial = 0, angular_momentum_final = 0;  ///< plane scenes only
    std::vector<PairStatistics> pairs;
    ContactSolverStatistics contact_solver;
    double contact_energy_in =
        0;  ///< sum of the works of all contact forces in those steps where it is positive [energy]
    std::vector<BodyEnergies> bodies;  ///< in the order of scene.bodies; empty while the run goes on
    std::string state_hash;  ///< FNV-1a 64 of positions, velocities and element states, 16 hex digits
    int threads = 1;
};

}  // namespace percuss
