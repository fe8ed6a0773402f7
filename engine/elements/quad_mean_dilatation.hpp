#pragma once

#include "elements/kinematics.hpp"

namespace percuss::PERCUSS_ISA {

/// Four-node quad with 2 x 2 points for the deviator and one pressure from the exact volume (mean dilatation,
/// B-bar: Nagtegaal, Parks & Rice 1974, doi:10.1016/0045-7825(74)90032-2; Hughes 1980): no hourglass modes,
/// no volume locking.
template <class Law, Geometry geometry, bool viscous>
struct QuadMeanDilatation {
    static constexpr int corners = 4;
    static constexpr int points = 4;
    static constexpr int law_begin =
        4 * 3 + (viscous ? 1 : 0);  // after m, d, s at each point; viscous pressure
    static constexpr int state_size = law_begin + 4 * Law::extra_state;

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
        const double quarter = 0.25 * dt;  // velocity modes to displacement coefficients
        const Real u0 = quarter * u.c0, u1 = quarter * u.c1, u2 = quarter * u.c2, u3 = quarter * u.c3;
        const Real w1 = quarter * w.c1, w2 = quarter * w.c2, w3 = quarter * w.c3;

        const Real initial_volume = load<Real>(batch.volume.data() + first * block_lanes + lane);
        const Real inverse_volume = 1.0 / b.volume;
        const Real inverse_ratio = initial_volume * inverse_volume;
        Real mean = mean_stress_of_volume(b.volume, initial_volume, inverse_volume, material.bulk);
        if constexpr (viscous) {
            // Mean trace of the step at its end, to second order at mid-step.
            Real trace =
                b.bx1 * u.c1 + b.bx2 * u.c2 + b.bx3 * u.c3 + b.by1 * w.c1 + b.by2 * w.c2 + b.by3 * w.c3;
            if constexpr (geometry == Geometry::axisymmetric)
                trace += b.hoop0 * u.c0 + b.hoop1 * u.c1 + b.hoop2 * u.c2;
            const Real q = bulk_viscosity<Real>(trace * inverse_volume, material.density * inverse_ratio,
                                                Real(4.0 * g.j0), material);
            add_to(sums.viscous + lane, viscous_work<Real>(state + 12 * block_lanes, q, dt * trace));
            mean -= q;
        }

        // The pressure acts on the exact volume gradient.
        const Real hoop_mean = geometry == Geometry::axisymmetric ? mean : Real(0.0 * mean);
        Modes<Real> fx{hoop_mean * b.hoop0, mean * b.bx1 + hoop_mean * b.hoop1,
                       mean * b.bx2 + hoop_mean * b.hoop2, mean * b.bx3};
        Modes<Real> fy{0.0 * mean, mean * b.by1, mean * b.by2, mean * b.by3};

        Real bad = 0.0 * b.volume;
        constexpr double gauss = 0.57735026918962576451;
        constexpr double xi[4] = {-gauss, gauss, gauss, -gauss}, eta[4] = {-gauss, -gauss, gauss, gauss};
        Real jacobian[4], radius[4], inverse[4];
        for (int point = 0; point < 4; ++point) {
            const double p = xi[point], e = eta[point];
            jacobian[point] = g.j0 + p * g.j1 + e * g.j2;
            if constexpr (geometry == Geometry::axisymmetric)
                radius[point] = g.x0 + p * g.x1 + e * g.x2 + (p * e) * g.x3;
            else
                radius[point] = 0.0 * g.x0 + 1.0;
            inverse[point] = jacobian[point] * radius[point];
            bad += (jacobian[point] > 0.0) & (radius[point] > 0.0) ? Real(0.0 * bad) : Real(0.0 * bad + 1.0);
        }
        invert(inverse);
        for (int point = 0; point < 4; ++point) {
            const double p = xi[point], e = eta[point];
            const Real x_xi = g.x1 + e * g.x3, x_eta = g.x2 + p * g.x3;
            const Real y_xi = g.y1 + e * g.y3, y_eta = g.y2 + p * g.y3;
            const Real u_xi = u1 + e * u3, u_eta = u2 + p * u3;
            const Real w_xi = w1 + e * w3, w_eta = w2 + p * w3;
            const Real inverse_jacobian = inverse[point] * radius[point];
            Gradient<Real> h;
            h.h11 = (u_xi * y_eta - u_eta * y_xi) * inverse_jacobian;
            h.h12 = (u_eta * x_xi - u_xi * x_eta) * inverse_jacobian;
            h.h21 = (w_xi * y_eta - w_eta * y_xi) * inverse_jacobian;
            h.h22 = (w_eta * x_xi - w_xi * x_eta) * inverse_jacobian;
            if constexpr (geometry == Geometry::axisymmetric)
                h.hoop = (u0 + p * u1 + e * u2 + (p * e) * u3) * (inverse[point] * jacobian[point]);
            else
                h.hoop = 0.0 * g.x0;
            keep_largest(sums.strain + lane, square_of(h));
            const auto strain = step_strain<Real, geometry>(h);

            double* at = state + point * (3 * block_lanes);
            Deviator<Real> s{load<Real>(at), load<Real>(at + block_lanes), load<Real>(at + 2 * block_lanes)};
            rotate(s, strain.cosine, strain.sine);
            if constexpr (Law::extra_state == 0) {
                Law::template update<Real>(s, strain.deviator, material);
            } else {
                double* extra = state + (law_begin + point * Law::extra_state) * block_lanes;
                const Real work =
                    Law::template update<Real>(s, strain.deviator, extra, batch, inverse_ratio, dt);
                add_to(sums.plastic + lane, Real(work * inverse_ratio * jacobian[point] * radius[point]));
            }
            store(at, s.m);
            store(at + block_lanes, s.d);
            store(at + 2 * block_lanes, s.s);

            // N_I,x J = [xi_I y_eta - eta_I y_xi + xi_I eta_I (eta y_eta - xi y_xi)] / 4, likewise for y.
            const auto stress = total_stress<Real, geometry>(Real(0.0 * mean), s, inverse_ratio);
            const Real weight = 0.25 * radius[point];
            const Real s11 = weight * stress.s11, s22 = weight * stress.s22, s12 = weight * stress.s12;
            fx.c1 += s11 * y_eta - s12 * x_eta;
            fx.c2 += s12 * x_xi - s11 * y_xi;
            fx.c3 += s11 * (e * y_eta - p * y_xi) + s12 * (p * x_xi - e * x_eta);
            fy.c1 += s12 * y_eta - s22 * x_eta;
            fy.c2 += s22 * x_xi - s12 * y_xi;
            fy.c3 += s12 * (e * y_eta - p * y_xi) + s22 * (p * x_xi - e * x_eta);
            if constexpr (geometry == Geometry::axisymmetric) {
                const Real hoop = 0.25 * stress.s33 * jacobian[point];  // N_I hoop stress dA
                fx.c0 += hoop;
                fx.c1 += p * hoop;
                fx.c2 += e * hoop;
                fx.c3 += (p * e) * hoop;
            }
        }

        const auto cx = to_corners(fx), cy = to_corners(fy);
        store_pairs(force, cx.a1, cy.a1);
        store_pairs(force + 2 * block_lanes, cx.a2, cy.a2);
        store_pairs(force + 4 * block_lanes, cx.a3, cy.a3);
        store_pairs(force + 6 * block_lanes, cx.a4, cy.a4);
        add_to(sums.inverted + lane, bad);
    }
};

}  // namespace percuss::PERCUSS_ISA
