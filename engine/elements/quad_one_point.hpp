#pragma once

#include "elements/kinematics.hpp"

namespace percuss::PERCUSS_ISA {

/// Four-node quad with one integration point: volume-weighted mean gradients, exact ring volume for the
/// pressure, and Flanagan-Belytschko hourglass stiffness (1981, doi:10.1002/nme.1620170504) in rate form, so
/// that no rigid or homogeneous motion feels it.
template <class Law, Geometry geometry, bool hourglass, bool viscous>
struct QuadOnePoint {
    static constexpr int corners = 4;
    static constexpr int points = 1;
    // after m, d, s; hourglass forces x, y; viscous pressure
    static constexpr int law_begin = 3 + (hourglass ? 2 : 0) + (viscous ? 1 : 0);
    static constexpr int state_size = law_begin + Law::extra_state;

    template <class Real>
    [[gnu::always_inline]] static void update(Batch& batch, const Node* nodes, double dt, int block, int lane,
                                              KernelSums& sums) {
        const ElasticConstants& material = batch.material;
        const std::size_t first = static_cast<std::size_t>(block);
        const std::int32_t* index = batch.nodes.data() + first * (4 * block_lanes) + lane;
        double* state = batch.state.data() + first * (state_size * block_lanes) + lane;
        double* force = batch.force.data() + first * (8 * block_lanes) + 2 * lane;

        const auto n1 = gather<Real>(nodes, index), n2 = gather<Real>(nodes, index + block_lanes);
        const auto n3 = gather<Real>(nodes, index + 2 * block_lanes),
                   n4 = gather<Real>(nodes, index + 3 * block_lanes);
        const auto x = to_modes(n1.x, n2.x, n3.x, n4.x), y = to_modes(n1.y, n2.y, n3.y, n4.y);
        const auto u = to_modes(n1.vx, n2.vx, n3.vx, n4.vx), w = to_modes(n1.vy, n2.vy, n3.vy, n4.vy);
        const auto g = quad_geometry(x, y);
        const auto b = quad_integrals<Real, geometry>(g);

        // Mean displacement gradient of the step at its end.
        const Real both = 1.0 / (b.volume * g.j0);  // a division costs as much as a dozen products
        const Real inverse_volume = both * g.j0, inverse_j0 = both * b.volume;
        const Real increment = dt * inverse_volume;
        Gradient<Real> h;
        h.h11 = increment * (b.bx1 * u.c1 + b.bx2 * u.c2 + b.bx3 * u.c3);
        h.h12 = increment * (b.by1 * u.c1 + b.by2 * u.c2 + b.by3 * u.c3);
        h.h21 = increment * (b.bx1 * w.c1 + b.bx2 * w.c2 + b.bx3 * w.c3);
        h.h22 = increment * (b.by1 * w.c1 + b.by2 * w.c2 + b.by3 * w.c3);
        h.hoop = increment * (b.hoop0 * u.c0 + b.hoop1 * u.c1 + b.hoop2 * u.c2);
        const auto strain = step_strain<Real, geometry>(h);
        // The gradient of xi eta, whose coefficients are u.c3 / 4 and w.c3 / 4, is at most sqrt(2 sides /
        // j0).
        const Real sides = inverse_j0 * (g.x1 * g.x1 + g.x2 * g.x2 + g.y1 * g.y1 + g.y2 * g.y2);
        keep_largest(sums.strain + lane,
                     square_of(h) + (0.125 * dt * dt) * (sides * inverse_j0) * (u.c3 * u.c3 + w.c3 * w.c3));

        // Stress: pressure from the volume, deviator from the law.
        Deviator<Real> s{load<Real>(state), load<Real>(state + block_lanes),
                         load<Real>(state + 2 * block_lanes)};
        rotate(s, strain.cosine, strain.sine);
        const Real initial_volume = load<Real>(batch.volume.data() + first * block_lanes + lane);
        const Real inverse_ratio = initial_volume * inverse_volume;
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
        Real mean = mean_stress_of_volume(b.volume, initial_volume, inverse_volume, material.bulk);
        if constexpr (viscous) {
            const Real q = bulk_viscosity<Real>(strain.trace * (1.0 / dt), material.density * inverse_ratio,
                                                Real(4.0 * g.j0), material);
            double* kept = state + (law_begin - 1) * block_lanes;
            add_to(sums.viscous + lane, viscous_work<Real>(kept, q, strain.trace * b.volume));
            mean -= q;
        }
        const auto stress = total_stress<Real, geometry>(mean, s, inverse_ratio);

        // Corner forces in modes.
        Modes<Real> fx, fy;
        fx.c0 = stress.s33 * b.hoop0;
        fx.c1 = stress.s11 * b.bx1 + stress.s12 * b.by1 + stress.s33 * b.hoop1;
        fx.c2 = stress.s11 * b.bx2 + stress.s12 * b.by2 + stress.s33 * b.hoop2;
        fx.c3 = stress.s11 * b.bx3 + stress.s12 * b.by3;
        fy.c0 = 0.0 * b.volume;
        fy.c1 = stress.s12 * b.bx1 + stress.s22 * b.by1;
        fy.c2 = stress.s12 * b.bx2 + stress.s22 * b.by2;
        fy.c3 = stress.s12 * b.bx3 + stress.s22 * b.by3;

        if constexpr (hourglass) {
            // gamma_I = xi eta - xi J2/J0 - eta J1/J0 is orthogonal to every linear field of the present
            // positions.
            const Real gamma1 = -g.j2 * inverse_j0, gamma2 = -g.j1 * inverse_j0;
            const Real qx = dt * (u.c3 + gamma1 * u.c1 + gamma2 * u.c2);
            const Real qy = dt * (w.c3 + gamma1 * w.c1 + gamma2 * w.c2);
            const Real weight = geometry == Geometry::axisymmetric ? g.x0 : Real(0.0 * g.x0 + 1.0);
            // 2 mu, not lambda + 2 mu: bending keeps the volume, and must stay soft as nu approaches 1/2.
            const Real stiffness = (0.25 * material.hourglass * material.shear) * weight * sides;
            const Real old_x = load<Real>(state + 3 * block_lanes),
                       old_y = load<Real>(state + 4 * block_lanes);
            const Real turned_x = strain.cosine * old_x - strain.sine * old_y;
            const Real turned_y = strain.sine * old_x + strain.cosine * old_y;
            const Real new_x = turned_x + stiffness * qx, new_y = turned_y + stiffness * qy;
            store(state + 3 * block_lanes, new_x);
            store(state + 4 * block_lanes, new_y);
            add_to(sums.hourglass + lane, Real(0.5 * ((turned_x + new_x) * qx + (turned_y + new_y) * qy)));
            fx.c1 += new_x * gamma1;
            fx.c2 += new_x * gamma2;
            fx.c3 += new_x;
            fy.c1 += new_y * gamma1;
            fy.c2 += new_y * gamma2;
            fy.c3 += new_y;
        }

        const auto cx = to_corners(fx), cy = to_corners(fy);
        store_pairs(force, cx.a1, cy.a1);
        store_pairs(force + 2 * block_lanes, cx.a2, cy.a2);
        store_pairs(force + 4 * block_lanes, cx.a3, cy.a3);
        store_pairs(force + 6 * block_lanes, cx.a4, cy.a4);
        const Real none = 0.0 * b.volume, one = none + 1.0;
        add_to(sums.inverted + lane, Real((g.j0 > 0.0) & (b.volume > 0.0) ? none : one));
    }
};

}  // namespace percuss::PERCUSS_ISA
