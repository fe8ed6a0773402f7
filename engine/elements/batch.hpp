#pragma once

#include <array>
#include <cstdint>

#include "aligned.hpp"
#include "dynamics/node.hpp"
#include "elements/nodal_volume.hpp"
#include "scene/scene.hpp"

namespace percuss {

/// Elements are stored in blocks of this many, whatever the instruction set: state[block][component][lane].
inline constexpr int block_lanes = 8;

/// Elastic constants as the kernels use them.
struct ElasticConstants {
    double density = 0;  ///< [mass/length^3]
    double bulk = 0;     ///< K; plane stress: E / (2 (1 - nu)), the in-plane bulk modulus [stress]
    double shear = 0;    ///< mu [stress]
    double p_wave = 0;   ///< lambda + 2 mu (plane stress: E / (1 - nu^2)) [stress]
    double viscosity_linear = 0, viscosity_quadratic = 0;
    double hourglass = 0;  ///< Flanagan-Belytschko coefficient
};

[[nodiscard]] ElasticConstants elastic_constants(const Material& material, const Body& body,
                                                 Geometry geometry);

/// What a kernel adds up over its elements, lane by lane: the sum does not depend on how many lanes a
/// register has.
struct alignas(64) KernelSums {
    double hourglass[block_lanes] =
        {};                            ///< work taken up by hourglass stiffness, per radian or unit thickness
    double viscous[block_lanes] = {};  ///< work taken up by bulk viscosity, likewise
    double inverted[block_lanes] = {};  ///< number of elements whose mean Jacobian is not positive
    double plastic[block_lanes] = {};   ///< work taken up by plastic flow, per radian or unit thickness
    double strain[block_lanes] = {};    ///< largest square (Frobenius) of a displacement gradient of this step
};

struct Batch;

/// Brings the stresses of blocks [begin, end) to the present positions (increments dt * v) and writes corner
/// forces.
using ForceKernel = void (*)(Batch& batch, const Node* nodes, double dt, int begin, int end,
                             KernelSums& sums);
/// Upper bound of the largest squared circular frequency [1/time^2] of the elements in blocks [begin, end),
/// viscosity accounted for, so that 2 / sqrt(bound) is a stable step.
using FrequencyKernel = double (*)(const Batch& batch, const Node* nodes, int begin, int end);
/// Writes the present volumes of blocks [begin, end) to `batch.shared`, for its nodes to sum up.
using VolumeKernel = void (*)(Batch& batch, const Node* nodes, int begin, int end);

/// What the kernels need of an element kind.
struct KernelSet {
    ForceKernel forces = nullptr;
    FrequencyKernel frequency = nullptr;
    int state_size = 0;  ///< doubles of state per element
    int points = 1;      ///< integration points per element
    int law_begin =
        0;  ///< first component of the law's own state, at the end of the state: [point][law_size]
    int law_size =
        0;  ///< doubles of it per point; plastic laws: equivalent plastic strain, yield stress, temperature
    VolumeKernel volumes = nullptr;  ///< averaged triangles only: comes before the other two
    int volume_components = 0;       ///< doubles of `shared.elements` per element
};

/// All elements of one body: one element kind, one material, one geometry, contiguous storage.
struct Batch {
    std::int32_t body = 0;
    ElementKind kind = ElementKind::quad_one_point;
    Geometry geometry = Geometry::axisymmetric;
    std::int32_t cell_begin = 0;  ///< first cell of the mesh
    std::int32_t count = 0;       ///< elements
    int corners = 4;
    ElasticConstants material;
    KernelSet kernel;

    AlignedVector<std::int32_t> nodes;  ///< [block][corner][lane]
    AlignedVector<double> volume;       ///< initial volume per radian or unit thickness: [block][lane]
    AlignedVector<double>
        inverse_mass;  ///< of the element's own corner masses, 0 where held: [block][corner][2][lane]
    AlignedVector<double> state;  ///< [block][component][lane]
    AlignedVector<double> force;  ///< internal corner forces, per radian: [block][corner][lane][2]
    Plasticity plasticity;
    NodalVolumes shared;  ///< averaged triangles only

    [[nodiscard]] int blocks() const { return (count + block_lanes - 1) / block_lanes; }
    [[nodiscard]] int filled(int block) const {
        const int left = count - block * block_lanes;
        return left < block_lanes ? left : block_lanes;
    }
};

/// Row-sum corner masses of one element per radian or unit thickness, m_I = rho * integral of N_I r dA,
/// exact; unused corners are 0. @param x corner positions.
[[nodiscard]] std::array<double, 4> corner_masses(const Cell& cell, const std::vector<Vec2>& nodes,
                                                  double density, Geometry geometry);

/// Volume per radian or unit thickness of a cell at the given node positions.
[[nodiscard]] double cell_volume(const Cell& cell, const Node* nodes, Geometry geometry);

/// A cell whose Jacobian is not positive where its kernel evaluates it.
[[nodiscard]] bool is_inverted(const Cell& cell, const Node* nodes, ElementKind kind, Geometry geometry);

/// The batch of body `body`. @param held per node and direction: velocity is not free. @throws nothing;
/// inputs are checked by build_mesh.
[[nodiscard]] Batch make_batch(const Scene& scene, const Mesh& mesh, std::int32_t body,
                               const std::vector<std::array<bool, 2>>& held);

/// Sets the state of all elements to the undeformed, unstressed one.
void reset_state(Batch& batch);

/// What an element's law remembers of its plastic flow, means over its volume.
struct PlasticState {
    double strain = 0;       ///< equivalent plastic strain
    double yield = 0;        ///< yield stress; infinite where the material is elastic [stress]
    double temperature = 0;  ///< 0 where the law has none [temperature]
};
[[nodiscard]] PlasticState plastic_state(const Batch& batch, const Node* nodes, std::int32_t element);

/// Mean stress (rr, zz, hoop, shear; tension positive) of element `element` of the batch [stress].
[[nodiscard]] std::array<double, 4> mean_stress(const Batch& batch, const Node* nodes, std::int32_t element);

/// Energy stored in element `element` by its strains (not by hourglass stiffness), from its state alone, per
/// radian or unit thickness: the check on the ledger, which counts the work of nodal forces.
[[nodiscard]] double stored_energy(const Batch& batch, const Node* nodes, std::int32_t element);

}  // namespace percuss
