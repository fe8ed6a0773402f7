#pragma once

#include <cstdint>
#include <vector>

#include "aligned.hpp"
#include "dynamics/node.hpp"

namespace percuss {

struct Batch;

/// What averaged triangles share at one node. A node has a third of the volume of each of its elements.
struct alignas(32) NodalVolume {
    double ratio = 1;    ///< J, present over initial volume of the node
    double stress = 0;   ///< mean stress of the bulk law at J, tension positive [stress]
    double viscous = 0;  ///< pressure of bulk viscosity at the node's rate of volume [stress]
    double damping = 0;  ///< its slope over that rate [stress time]
};

/// Average nodal pressure (Bonet & Burton 1998, Communications in Numerical Methods in Engineering 14, 437):
/// the volumetric energy is the sum over nodes of V_a U(J_a), J_a = v_a / V_a, v_a = sum over its elements of
/// v_e / 3. Its gradient gives each element the mean of its nodes' stresses U'(J_a), acting on the gradient
/// of v_e: forces are those of an energy, and a mesh of triangles has about as many constraints of volume as
/// nodes, not twice as many.
struct NodalVolumes {
    std::int32_t node_begin = 0;         ///< first node of the body
    AlignedVector<NodalVolume> nodes;    ///< from node_begin on; empty for other elements
    AlignedVector<double> elements;      ///< [block][component][lane]: volume; viscous: its rate, size
    std::vector<std::int32_t> begin;     ///< per node: its range in `places`
    std::vector<std::int32_t> places;    ///< of its elements' volumes in `elements`, in the order of the mesh
    std::vector<double> initial_thrice;  ///< per node: sum of its elements' initial volumes, 3 V_a
};

/// The nodal volumes of a batch whose nodes and initial volumes are set. @param node_end one past the body's
/// last node.
void build_nodal_volumes(Batch& batch, std::int32_t node_begin, std::int32_t node_end);

/// Sums the elements' volumes at nodes [begin, end) of the whole mesh, all of this body, in the order of the
/// mesh.
/// @pre the batch's volume kernel has seen all its blocks.
void sum_nodal_volumes(Batch& batch, std::int32_t begin, std::int32_t end);

/// Both passes over a whole batch, which force and frequency kernels of averaged triangles need before them
/// at the same positions and velocities; nothing for other elements.
void average_volumes(Batch& batch, const Node* nodes);

}  // namespace percuss
