#pragma once

#include "elements/kinematics.hpp"

namespace percuss::PERCUSS_ISA {

/// Three-node triangle with constant strain; ring integrals are exact (A r_mean, and A/3 for each hoop row).
/// @tparam averaged mean stress and bulk viscosity come from its nodes, see NodalVolumes; a triangle by
/// itself locks where the volume is kept.
template <class Law, Geometry geometry, bool viscous, bool averaged>
struct Triangle {
    static constexpr int corners = 3;
    static constexpr int points = 1;
    static constexpr int law_begin = 3 + (viscous ? 1 : 0);  // after m, d, s; viscous pressure
    static constexpr int state_size = law_begin + Law::extra_state;

    template <class Real>
    [[gnu::always_inline]] static void update(Batch& batch, const Node* nodes, double dt, int block, int lane,
                                              KernelSums& sums) {
        const ElasticConstants& material = batch.material;
        const std::size_t first = static_cast<std::size_t>(block);
        const std::int32_t* index = batch.nodes.data() + first * (3 * block_lanes) + lane;
        double* state = batch.state.data() + first * (state_size * block_lanes) + lane;
        double* force = batch.force.data() + first * (6 * block_lanes) + 2 * lane;

        const auto n1 = gather<Real>(nodes, index), n2 = gather<Real>(nodes, index + block_lanes);
        const auto n3 = gather<Real>(nodes, index + 2 * block_lanes);
        // Twice the area and, per corner, its product with the shape function's gradient.
        const Real x21 = n2.x - n1.x, x31 = n3.x - n1.x, y21 = n2.y - n1.y, y31 = n3.y - n1.y;
        const Real twice_area = x21 * y31 - x31 * y21;
        const Real inverse = 1.0 / twice_area;
        const Real u21 = n2.vx - n1.vx, u31 = n3.vx - n1.vx, w21 = n2.vy - n1.vy, w31 = n3.vy - n1.vy;
        const Real increment = dt * inverse;
        Gradient<Real> h;
        h.h11 = increment * (u21 * y31 - u31 * y21);
        h.h12 = increment * (u31 * x21 - u21 * x31);
        h.h21 = increment * (w21 * y31 - w31 * y21);
        h.h22 = increment * (w31 * x21 - w21 * x31);
        Real radius = 0.0 * inverse + 1.0;
        h.hoop = 0.0 * inverse;
        if constexpr (geometry == Geometry::axisymmetric) {
            radius = (n1.x + n2.x + n3.x) * (1.0 / 3.0);
            h.hoop = dt * (n1.vx + n2.vx + n3.vx) / (n1.x + n2.x + n3.x);
        }
        const Real volume = 0.5 * twice_area * radius;
        keep_largest(sums.strain + lane, square_of(h));
        const auto strain = step_strain<Real, geometry>(h);

        Deviator<Real> s{load<Real>(state), load<Real>(state + block_lanes),
                         load<Real>(state + 2 * block_lanes)};
        rotate(s, strain.cosine, strain.sine);
        const Real initial_volume = load<Real>(batch.volume.data() + first * block_lanes + lane);
        const Real inverse_ratio = initial_volume / volume;
        if constexpr (Law::extra_state == 0) {
            Law::template update<Real>(s, strain.deviator, material);
        } else {
            const Real work = Law::template update<Real>(s, strain.deviator, state + law_begin * block_lanes,
                                                         batch, inverse_ratio, dt);
            add_to(sums.plastic + lane, Real(work * initial_volume));
        }
        store(state, s.m);
        store(state + block_lanes, s.d);
        store(state + 2 * block_lanes, s.s);
        Real mean, q;
        if constexpr (averaged) {
            const auto shared = mean_nodal_volume<Real>(batch.shared, index);
            mean = shared.stress;
            q = shared.viscous;
        } else {
            mean = mean_stress_of_volume(inverse_ratio, material.bulk);
            if constexpr (viscous)
                q = bulk_viscosity<Real>(strain.trace * (1.0 / dt), material.density * inverse_ratio,
                                         Real(0.5 * twice_area), material);
        }
        if constexpr (viscous) {
            add_to(sums.viscous + lane,
                   viscous_work<Real>(state + 3 * block_lanes, q, strain.trace * volume));
            mean -= q;
        }
        const auto stress = total_stress<Real, geometry>(mean, s, inverse_ratio);

        const Real s11 = 0.5 * radius * stress.s11, s22 = 0.5 * radius * stress.s22,
                   s12 = 0.5 * radius * stress.s12;
        const Real hoop = geometry == Geometry::axisymmetric ? Real(stress.s33 * twice_area * (1.0 / 6.0))
                                                             : Real(0.0 * twice_area);
        const Real f2x = s11 * y31 - s12 * x31, f2y = s12 * y31 - s22 * x31;
        const Real f3x = s12 * x21 - s11 * y21, f3y = s22 * x21 - s12 * y21;
        store_pairs(force, Real(hoop - (f2x + f3x)), Real(-(f2y + f3y)));
        store_pairs(force + 2 * block_lanes, Real(hoop + f2x), f2y);
        store_pairs(force + 4 * block_lanes, Real(hoop + f3x), f3y);
        const Real none = 0.0 * volume, one = none + 1.0;
        add_to(sums.inverted + lane, Real((twice_area > 0.0) & (volume > 0.0) ? none : one));
    }
};

/// Volumes of averaged triangles; with viscosity also their rates [volume/time] and sizes, the roots of their
/// areas.
template <Geometry geometry, bool viscous>
struct TriangleVolume {
    static constexpr int components = viscous ? 3 : 1;

    template <class Real>
    [[gnu::always_inline]] static void update(Batch& batch, const Node* nodes, int block, int lane) {
        const std::size_t first = static_cast<std::size_t>(block);
        const std::int32_t* index = batch.nodes.data() + first * (3 * block_lanes) + lane;
        double* to = batch.shared.elements.data() + first * (components * block_lanes) + lane;
        const auto n1 = gather<Real>(nodes, index), n2 = gather<Real>(nodes, index + block_lanes);
        const auto n3 = gather<Real>(nodes, index + 2 * block_lanes);
        const Real x21 = n2.x - n1.x, x31 = n3.x - n1.x, y21 = n2.y - n1.y, y31 = n3.y - n1.y;
        const Real twice_area = x21 * y31 - x31 * y21;
        Real radius = 0.0 * twice_area + 1.0;
        if constexpr (geometry == Geometry::axisymmetric) radius = (n1.x + n2.x + n3.x) * (1.0 / 3.0);
        store(to, Real(0.5 * twice_area * radius));
        if constexpr (viscous) {
            const Real u21 = n2.vx - n1.vx, u31 = n3.vx - n1.vx, w21 = n2.vy - n1.vy, w31 = n3.vy - n1.vy;
            Real rate = 0.5 * radius * (u21 * y31 - u31 * y21 + w31 * x21 - w21 * x31);
            if constexpr (geometry == Geometry::axisymmetric)
                rate += twice_area * (1.0 / 6.0) * (n1.vx + n2.vx + n3.vx);
            store(to + block_lanes, rate);
            store(to + 2 * block_lanes, square_root(Real(0.5 * twice_area)));
        }
    }
};

}  // namespace percuss::PERCUSS_ISA
