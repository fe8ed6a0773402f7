#include "run/state_history.hpp"

namespace percuss {
namespace {

template <class Array>
std::size_t bytes(const Array& array) {
    return array.capacity() * sizeof(array[0]);
}

template <class Arrays>
std::size_t bytes_of_each(const Arrays& arrays) {
    std::size_t sum = bytes(arrays);
    for (const auto& array : arrays) sum += bytes(array);
    return sum;
}

/// What contact remembers is its own affair; this is within a fifth of the whole for the coarsest nail, and
/// too much rather than too little for larger meshes.
std::size_t contact_bytes(std::size_t nodes, std::size_t pairs) { return nodes * (8 + 8 * pairs); }

}  // namespace

std::size_t memory_of(const KeptState& kept) {
    const SolverState& s = kept.solver;
    const Ledger& ledger = s.ledger;
    std::size_t sum = sizeof(KeptState) + bytes(s.nodes) + bytes(s.lagged_nodes) +
                      bytes_of_each(s.element_state) + bytes_of_each(s.corner_force) +
                      bytes_of_each(s.active) + bytes(s.pairs) + bytes(s.statistics.pairs) +
                      bytes(ledger.body_momentum) + bytes(ledger.body_velocity) + bytes(ledger.pair_work) +
                      bytes(ledger.pair_friction_work) + bytes(ledger.body_works) + bytes(kept.record.traces);
    if (s.contact) sum += contact_bytes(s.nodes.size(), s.active.size());
    for (const TraceRecorder::Progress& trace : kept.record.traces) sum += bytes(trace.impulse);
    return sum;
}

}  // namespace percuss
