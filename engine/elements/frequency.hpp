#pragma once

#include <algorithm>

#include "elements/kinematics.hpp"

/// Upper bounds of the largest squared frequency of one element with its own share of the masses. By
/// Rayleigh's quotient no assembly of elements oscillates faster than its fastest element, so 2/omega is a
/// stable step of the whole mesh.
namespace percuss::PERCUSS_ISA {

template <class Real, int n>
struct Matrix {
    Real a[n][n];
};

/// Largest row sum of absolute values.
template <class Real, int n>
[[gnu::always_inline]] inline Real row_norm(const Matrix<Real, n>& m) {
    Real norm = 0.0 * m.a[0][0];
    for (int i = 0; i < n; ++i) {
        Real sum = magnitude(m.a[i][0]);
        for (int j = 1; j < n; ++j) sum += magnitude(m.a[i][j]);
        norm = larger_of(norm, sum);
    }
    return norm;
}

/// Bound of the spectral radius by a norm of a power: rho(A) <= |A^(2^squarings)|^(1/2^squarings). Each
/// squaring takes the square root of the norm's excess; the intermediate scaling keeps the powers within
/// range.
template <class Real, int n>
[[gnu::always_inline]] inline Real spectral_radius_bound(Matrix<Real, n> m, int squarings) {
    Real bound = row_norm(m), root = bound;
    for (int k = 0; k < squarings; ++k) {
        const Real scale = 1.0 / larger_of(root, Real(0.0 * root + 1e-300));
        for (int i = 0; i < n; ++i)
            for (int j = 0; j < n; ++j) m.a[i][j] *= scale;
        Matrix<Real, n> square;
        for (int i = 0; i < n; ++i)
            for (int j = 0; j < n; ++j) {
                Real sum = m.a[i][0] * m.a[0][j];
                for (int l = 1; l < n; ++l) sum += m.a[i][l] * m.a[l][j];
                square.a[i][j] = sum;
            }
        m = square;
        root = row_norm(m);  // of the scaled square
        Real excess = root;  // bound so far times excess^(1/2^(k+1))
        for (int r = 0; r <= k; ++r) excess = square_root(excess);
        bound *= excess;
    }
    return bound;
}

/// Tangents at the present volume: bulk modulus J U''(J) = K / J^2, shear modulus mu / J.
template <class Real, Geometry geometry>
struct Moduli {
    Real direct, lateral, shear;

    [[gnu::always_inline]] Moduli(const ElasticConstants& material, Real ratio)
        : Moduli(material, ratio, material.bulk / (ratio * ratio)) {}

    [[gnu::always_inline]] Moduli(const ElasticConstants& material, Real ratio, Real bulk) {
        constexpr double share = geometry == Geometry::plane_stress ? 1.0 : 2.0 / 3.0;
        shear = material.shear / ratio;
        lateral = bulk - share * shear;
        direct = lateral + 2.0 * shear;
    }
};

/// omega^2 with damping: explicit viscous forces of coefficient c lower the stable step to 2/omega
/// (sqrt(1+x^2) - x), x = c/(2 omega); returned as the omega^2 that has the same step.
template <class Real>
[[gnu::always_inline]] inline Real damped(Real omega_squared, Real damping) {
    const Real omega = square_root(omega_squared);
    const Real x = 0.5 * damping / omega;
    const Real effective = omega * (square_root(Real(1.0 + x * x)) + x);
    return effective * effective;
}

/// Damping coefficient of bulk viscosity on the volumetric mode, whose mass-weighted square is `volumetric`.
template <class Real>
[[gnu::always_inline]] inline Real viscous_damping(Real volumetric, Real rate, Real density, Real length,
                                                   const ElasticConstants& material) {
    const Real speed = square_root(material.p_wave / density);
    return density * length * volumetric *
           (material.viscosity_linear * speed +
            2.0 * material.viscosity_quadratic * length * magnitude(rate));
}

/// What stresses add to the stiffness, per volume and square of a velocity gradient L: as an element moves
/// on, its forces are turned, and stretched with its sides. The Kirchhoff deviator tau does no more than the
/// magnitude of its largest principal value, and |tau| in the plane for its own turning (the commutator of
/// Jaumann's rate); a tensile mean stress acts as it is. A pressure only softens what it acts along, and what
/// it stiffens, shear, stays below the bulk modulus at that pressure. [stress]
template <class Real>
[[gnu::always_inline]] inline Real stress_stiffness(Real m, Real d, Real s, Real inverse_ratio, Real mean) {
    const Real in_plane = square_root(Real(d * d + s * s)), middle = magnitude(m);
    const Real principal = larger_of(Real(middle + in_plane), Real(2.0 * middle));
    return inverse_ratio * (principal + in_plane) + larger_of(mean, Real(0.0 * mean));
}

/// Larger eigenvalue of a symmetric 2 x 2 matrix.
template <class Real>
[[gnu::always_inline]] inline Real larger_eigenvalue(Real xx, Real xy, Real yy) {
    const Real half = 0.5 * (xx - yy);
    return 0.5 * (xx + yy) + square_root(Real(half * half + xy * xy));
}

/// One-point quads and triangles: in the space of strains and hourglass modes, omega^2 = rho(C B M^-1 B^T), a
/// 6 x 6 problem (rr, zz, hoop, shear, hourglass x, y) instead of an 8 x 8 one.
template <class Real, Geometry geometry, int corners, bool hourglass>
[[gnu::always_inline]] inline Real strain_space_bound(const Real (&bx)[4], const Real (&by)[4],
                                                      const Real (&hoop)[4], const Real (&gamma)[4],
                                                      const Real (&mx)[4], const Real (&my)[4], Real volume,
                                                      Real stiffness, const Moduli<Real, geometry>& c,
                                                      Real stressed) {
    const auto dot = [&](const Real(&a)[4], const Real(&b)[4], const Real(&m)[4]) {
        Real sum = a[0] * b[0] * m[0];
        for (int i = 1; i < corners; ++i) sum += a[i] * b[i] * m[i];
        return sum;
    };
    constexpr int n = hourglass ? 6 : 4;
    const Real none = 0.0 * volume, inverse = 1.0 / volume;
    Matrix<Real, n> g;
    for (auto& row : g.a)
        for (auto& value : row) value = none;
    g.a[0][0] = dot(bx, bx, mx) * inverse;
    g.a[1][1] = dot(by, by, my) * inverse;
    g.a[2][2] = dot(hoop, hoop, mx) * inverse;
    g.a[0][2] = g.a[2][0] = dot(bx, hoop, mx) * inverse;
    g.a[0][3] = g.a[3][0] = dot(bx, by, mx) * inverse;
    g.a[1][3] = g.a[3][1] = dot(by, bx, my) * inverse;
    g.a[2][3] = g.a[3][2] = dot(hoop, by, mx) * inverse;
    const Real yy_x = dot(by, by, mx) * inverse, xx_y = dot(bx, bx, my) * inverse;
    g.a[3][3] = yy_x + xx_y;
    // The gradient of x velocities, then that of y velocities, which do not couple in its square.
    const Real gradient = larger_of(Real(larger_eigenvalue(g.a[0][0], g.a[0][3], yy_x) + g.a[2][2]),
                                  larger_eigenvalue(xx_y, g.a[1][3], g.a[1][1]));
    if constexpr (hourglass) {
        g.a[4][4] = dot(gamma, gamma, mx);
        g.a[5][5] = dot(gamma, gamma, my);
        g.a[0][4] = g.a[4][0] = dot(bx, gamma, mx);
        g.a[2][4] = g.a[4][2] = dot(hoop, gamma, mx);
        g.a[3][4] = g.a[4][3] = dot(by, gamma, mx);
        g.a[1][5] = g.a[5][1] = dot(by, gamma, my);
        g.a[3][5] = g.a[5][3] = dot(bx, gamma, my);
    }
    // Strain rows carry modulus and 1/volume, hourglass rows the stiffness. A similarity transformation keeps
    // the spectrum and balances the two, which keeps the norm below close to the spectral radius.
    const Real balance = square_root(Real(stiffness * inverse / c.direct));
    Matrix<Real, n> a;
    for (int j = 0; j < n; ++j) {
        const Real per = j >= 4 ? balance : Real(none + 1.0);
        const Real g0 = g.a[0][j] * per, g1 = g.a[1][j] * per, g2 = g.a[2][j] * per, g3 = g.a[3][j] * per;
        a.a[0][j] = c.direct * g0 + c.lateral * (g1 + g2);
        a.a[1][j] = c.direct * g1 + c.lateral * (g0 + g2);
        a.a[2][j] = c.direct * g2 + c.lateral * (g0 + g1);
        a.a[3][j] = c.shear * g3;
        if constexpr (hourglass) {
            const Real back = j >= 4 ? stiffness : Real(stiffness * inverse / balance);
            a.a[4][j] = back * g.a[4][j];
            a.a[5][j] = back * g.a[5][j];
        }
    }
    return spectral_radius_bound(a, 2) + stressed * gradient;
}

/// stress_stiffness() of the state's first three numbers from `component` on.
template <class Real>
[[gnu::always_inline]] inline Real stress_stiffness_of(const Batch& batch, int block, int lane, int component,
                                                       Real inverse_ratio, Real mean) {
    const double* state =
        batch.state.data() + lane +
        (static_cast<std::size_t>(block) * static_cast<std::size_t>(batch.kernel.state_size) +
         static_cast<std::size_t>(component)) *
            block_lanes;
    return stress_stiffness(load<Real>(state), load<Real>(state + block_lanes),
                            load<Real>(state + 2 * block_lanes), inverse_ratio, mean);
}

template <class Real>
[[gnu::always_inline]] inline void load_masses(const Batch& batch, int block, int lane, Real (&mx)[4],
                                               Real (&my)[4]) {
    const double* m =
        batch.inverse_mass.data() +
        static_cast<std::size_t>(block) * static_cast<std::size_t>(batch.corners * 2 * block_lanes) + lane;
    for (int corner = 0; corner < batch.corners; ++corner) {
        mx[corner] = load<Real>(m + (2 * corner) * block_lanes);
        my[corner] = load<Real>(m + (2 * corner + 1) * block_lanes);
    }
}

template <class Real>
[[gnu::always_inline]] inline void unpack(const Modes<Real>& modes, Real (&values)[4]) {
    const auto c = to_corners(modes);
    values[0] = c.a1;
    values[1] = c.a2;
    values[2] = c.a3;
    values[3] = c.a4;
}

template <Geometry geometry, bool hourglass, bool viscous>
struct QuadOnePointFrequency {
    template <class Real>
    [[gnu::always_inline]] static Real bound(const Batch& batch, const Node* nodes, int block, int lane) {
        const std::int32_t* index =
            batch.nodes.data() + static_cast<std::size_t>(block) * (4 * block_lanes) + lane;
        const auto n1 = gather<Real>(nodes, index), n2 = gather<Real>(nodes, index + block_lanes);
        const auto n3 = gather<Real>(nodes, index + 2 * block_lanes),
                   n4 = gather<Real>(nodes, index + 3 * block_lanes);
        const auto g = quad_geometry(to_modes(n1.x, n2.x, n3.x, n4.x), to_modes(n1.y, n2.y, n3.y, n4.y));
        const auto b = quad_integrals<Real, geometry>(g);
        const Real none = 0.0 * b.volume;
        Real bx[4], by[4], hoop[4], gamma[4], mx[4] = {}, my[4] = {};
        unpack<Real>({none, b.bx1, b.bx2, b.bx3}, bx);
        unpack<Real>({none, b.by1, b.by2, b.by3}, by);
        unpack<Real>({b.hoop0, b.hoop1, b.hoop2, none}, hoop);
        const Real inverse_j0 = 1.0 / g.j0;
        unpack<Real>({none, -g.j2 * inverse_j0, -g.j1 * inverse_j0, none + 1.0}, gamma);
        load_masses(batch, block, lane, mx, my);
        const Real weight = geometry == Geometry::axisymmetric ? g.x0 : Real(none + 1.0);
        const Real stiffness = (0.25 * batch.material.hourglass * batch.material.shear) * weight *
                               inverse_j0 * (g.x1 * g.x1 + g.x2 * g.x2 + g.y1 * g.y1 + g.y2 * g.y2);
        const Real initial =
            load<Real>(batch.volume.data() + static_cast<std::size_t>(block) * block_lanes + lane);
        const Moduli<Real, geometry> moduli(batch.material, Real(b.volume / initial));
        const Real inverse_ratio = initial / b.volume;
        const Real stressed = stress_stiffness_of<Real>(
            batch, block, lane, 0, inverse_ratio, mean_stress_of_volume(inverse_ratio, batch.material.bulk));
        Real omega2 = strain_space_bound<Real, geometry, 4, hourglass>(bx, by, hoop, gamma, mx, my, b.volume,
                                                                       stiffness, moduli, stressed);
        if constexpr (viscous) {
            Real volumetric = none, rate = none;
            const Real vx[4] = {n1.vx, n2.vx, n3.vx, n4.vx}, vy[4] = {n1.vy, n2.vy, n3.vy, n4.vy};
            for (int i = 0; i < 4; ++i) {
                const Real radial = bx[i] + hoop[i];
                volumetric += radial * radial * mx[i] + by[i] * by[i] * my[i];
                rate += radial * vx[i] + by[i] * vy[i];
            }
            omega2 = damped(omega2, viscous_damping<Real>(volumetric / b.volume, rate / b.volume,
                                                          batch.material.density * initial / b.volume,
                                                          square_root(Real(4.0 * g.j0)), batch.material));
        }
        return omega2;
    }
};

/// Averaged triangles: a node's volume changes by a mean over its elements, and the square of a mean is not
/// above the mean of squares (Jensen). So the nodes' energy of volume, and likewise the power of their
/// viscosity, is bounded by a sum over elements whose modulus and damping are means over their nodes: V_e U''
/// = V_e K mean(1/J_a^3).
template <Geometry geometry, bool viscous, bool averaged>
struct TriangleFrequency {
    template <class Real>
    [[gnu::always_inline]] static Real bound(const Batch& batch, const Node* nodes, int block, int lane) {
        const std::int32_t* index =
            batch.nodes.data() + static_cast<std::size_t>(block) * (3 * block_lanes) + lane;
        const auto n1 = gather<Real>(nodes, index), n2 = gather<Real>(nodes, index + block_lanes);
        const auto n3 = gather<Real>(nodes, index + 2 * block_lanes);
        const Real twice_area = (n2.x - n1.x) * (n3.y - n1.y) - (n3.x - n1.x) * (n2.y - n1.y);
        const Real none = 0.0 * twice_area;
        const Real radius =
            geometry == Geometry::axisymmetric ? Real((n1.x + n2.x + n3.x) * (1.0 / 3.0)) : Real(none + 1.0);
        const Real volume = 0.5 * twice_area * radius, half = 0.5 * radius;
        const Real bx[4] = {half * (n2.y - n3.y), half * (n3.y - n1.y), half * (n1.y - n2.y), none};
        const Real by[4] = {half * (n3.x - n2.x), half * (n1.x - n3.x), half * (n2.x - n1.x), none};
        const Real ring = geometry == Geometry::axisymmetric ? Real(twice_area * (1.0 / 6.0)) : none;
        const Real hoop[4] = {ring, ring, ring, none}, gamma[4] = {none, none, none, none};
        Real mx[4] = {}, my[4] = {};
        load_masses(batch, block, lane, mx, my);
        const Real initial =
            load<Real>(batch.volume.data() + static_cast<std::size_t>(block) * block_lanes + lane);
        const Real ratio = volume / initial;
        Moduli<Real, geometry> moduli(batch.material, ratio);
        Real damping = none, mean = mean_stress_of_volume(Real(initial / volume), batch.material.bulk);
        if constexpr (averaged) {
            const auto shared = mean_nodal_volume<Real>(batch.shared, index);
            mean = shared.stress;
            moduli = {batch.material, ratio, Real(batch.material.bulk * ratio * shared.inverse_ratio_cubed)};
            damping = shared.damping;
        }
        const Real stressed = stress_stiffness_of<Real>(batch, block, lane, 0, Real(initial / volume), mean);
        Real omega2 = strain_space_bound<Real, geometry, 3, false>(bx, by, hoop, gamma, mx, my, volume, none,
                                                                   moduli, stressed);
        if constexpr (viscous && averaged) {
            Real volumetric = none;
            for (int i = 0; i < 3; ++i) {
                const Real radial = bx[i] + hoop[i];
                volumetric += radial * radial * mx[i] + by[i] * by[i] * my[i];
            }
            omega2 = damped(omega2, Real(damping * volumetric / volume));
        } else if constexpr (viscous) {
            Real volumetric = none, rate = none;
            const Real vx[3] = {n1.vx, n2.vx, n3.vx}, vy[3] = {n1.vy, n2.vy, n3.vy};
            for (int i = 0; i < 3; ++i) {
                const Real radial = bx[i] + hoop[i];
                volumetric += radial * radial * mx[i] + by[i] * by[i] * my[i];
                rate += radial * vx[i] + by[i] * vy[i];
            }
            omega2 =
                damped(omega2, viscous_damping<Real>(volumetric / volume, rate / volume,
                                                     batch.material.density * initial / volume,
                                                     square_root(Real(0.5 * twice_area)), batch.material));
        }
        return omega2;
    }
};

/// 2 x 2 points with mean dilatation: the mass-scaled 8 x 8 element stiffness itself.
template <Geometry geometry, bool viscous>
struct QuadMeanDilatationFrequency {
    template <class Real>
    [[gnu::always_inline]] static Real bound(const Batch& batch, const Node* nodes, int block, int lane) {
        const std::int32_t* index =
            batch.nodes.data() + static_cast<std::size_t>(block) * (4 * block_lanes) + lane;
        const auto n1 = gather<Real>(nodes, index), n2 = gather<Real>(nodes, index + block_lanes);
        const auto n3 = gather<Real>(nodes, index + 2 * block_lanes),
                   n4 = gather<Real>(nodes, index + 3 * block_lanes);
        const auto g = quad_geometry(to_modes(n1.x, n2.x, n3.x, n4.x), to_modes(n1.y, n2.y, n3.y, n4.y));
        const auto b = quad_integrals<Real, geometry>(g);
        const Real none = 0.0 * b.volume;
        Real mx[4] = {}, my[4] = {};
        load_masses(batch, block, lane, mx, my);
        Real root[8];
        for (int i = 0; i < 4; ++i) {
            root[i] = square_root(mx[i]);
            root[4 + i] = square_root(my[i]);
        }
        const Real initial =
            load<Real>(batch.volume.data() + static_cast<std::size_t>(block) * block_lanes + lane);
        const Real ratio = b.volume / initial;
        const Real bulk = batch.material.bulk / (ratio * ratio);

        Matrix<Real, 8> k;
        Real volume_row[8];
        {
            Real bx[4], by[4], hoop[4];
            unpack<Real>({none, b.bx1, b.bx2, b.bx3}, bx);
            unpack<Real>({none, b.by1, b.by2, b.by3}, by);
            unpack<Real>({b.hoop0, b.hoop1, b.hoop2, none}, hoop);
            for (int i = 0; i < 4; ++i) {
                volume_row[i] = (bx[i] + hoop[i]) * root[i];
                volume_row[4 + i] = by[i] * root[4 + i];
            }
            const Real factor = bulk / b.volume;
            for (int i = 0; i < 8; ++i)
                for (int j = 0; j < 8; ++j) k.a[i][j] = factor * volume_row[i] * volume_row[j];
        }
        constexpr double gauss = 0.57735026918962576451;
        constexpr double xi[4] = {-gauss, gauss, gauss, -gauss}, eta[4] = {-gauss, -gauss, gauss, gauss};
        for (int point = 0; point < 4; ++point) {
            const double p = xi[point], e = eta[point];
            const Real jacobian = g.j0 + p * g.j1 + e * g.j2, inverse = 1.0 / jacobian;
            const Real x_xi = g.x1 + e * g.x3, x_eta = g.x2 + p * g.x3, y_xi = g.y1 + e * g.y3,
                       y_eta = g.y2 + p * g.y3;
            Real nx[4], ny[4], nh[4];
            unpack<Real>({none, 0.25 * inverse * y_eta, -0.25 * inverse * y_xi,
                          0.25 * inverse * (e * y_eta - p * y_xi)},
                         nx);
            unpack<Real>({none, -0.25 * inverse * x_eta, 0.25 * inverse * x_xi,
                          0.25 * inverse * (p * x_xi - e * x_eta)},
                         ny);
            Real radius = none + 1.0;
            unpack<Real>({none, none, none, none}, nh);
            if constexpr (geometry == Geometry::axisymmetric) {
                radius = g.x0 + p * g.x1 + e * g.x2 + (p * e) * g.x3;
                const Real shape = 0.25 / radius;
                unpack<Real>({shape, p * shape, e * shape, (p * e) * shape}, nh);
            }
            // Deviatoric energy mu (e11^2 + e22^2 + e33^2 - tr^2/3) * 2 + mu gamma^2; plane stress: 2 mu
            // d^2-part only.
            Real row11[8], row22[8], row33[8], shear[8];
            for (int i = 0; i < 4; ++i) {
                row11[i] = nx[i] * root[i];
                row11[4 + i] = none;
                row22[i] = none;
                row22[4 + i] = ny[i] * root[4 + i];
                row33[i] = nh[i] * root[i];
                row33[4 + i] = none;
                shear[i] = ny[i] * root[i];
                shear[4 + i] = nx[i] * root[4 + i];
            }
            constexpr double share = geometry == Geometry::plane_stress ? 0.5 : 1.0 / 3.0;
            const Real weight = radius * jacobian, factor = (batch.material.shear / ratio) * weight;
            const Real stressed = weight * stress_stiffness_of<Real>(
                                               batch, block, lane, 3 * point, Real(1.0 / ratio),
                                               mean_stress_of_volume(Real(1.0 / ratio), batch.material.bulk));
            for (int i = 0; i < 8; ++i)
                for (int j = 0; j < 8; ++j) {
                    const Real trace_i = row11[i] + row22[i] + row33[i],
                               trace_j = row11[j] + row22[j] + row33[j];
                    k.a[i][j] += factor * (2.0 * (row11[i] * row11[j] + row22[i] * row22[j] +
                                                  row33[i] * row33[j] - share * trace_i * trace_j) +
                                           shear[i] * shear[j]);
                }
            for (int i = 0; i < 4; ++i)
                for (int j = 0; j < 4; ++j) {
                    const Real gradient = stressed * (nx[i] * nx[j] + ny[i] * ny[j]);
                    k.a[i][j] += root[i] * root[j] * (gradient + stressed * nh[i] * nh[j]);
                    k.a[4 + i][4 + j] += root[4 + i] * root[4 + j] * gradient;
                }
        }
        Real omega2 = spectral_radius_bound(k, 3);
        if constexpr (viscous) {
            Real volumetric = none, rate = none;
            const Real v[8] = {n1.vx, n2.vx, n3.vx, n4.vx, n1.vy, n2.vy, n3.vy, n4.vy};
            for (int i = 0; i < 8; ++i) {
                volumetric += volume_row[i] * volume_row[i];
                rate += root[i] > 0.0 ? Real(volume_row[i] * v[i] / root[i]) : none;
            }
            omega2 = damped(omega2, viscous_damping<Real>(volumetric / b.volume, rate / b.volume,
                                                          batch.material.density * initial / b.volume,
                                                          square_root(Real(4.0 * g.j0)), batch.material));
        }
        return omega2;
    }
};

}  // namespace percuss::PERCUSS_ISA
