#pragma once

#include "elements/lanes.hpp"
#include "materials/elastic.hpp"

namespace percuss::PERCUSS_ISA {

/// Displacement increment of a step, differentiated with respect to the positions at its end: h_ij =
/// du_i/dx_j, and the hoop stretch increment u_r / r.
template <class Real>
struct Gradient {
    Real h11, h12, h21, h22, hoop;
};

/// Strain increment and rotation of a step, measured at mid-step, where a rigid rotation has none of the
/// former.
template <class Real>
struct StepStrain {
    Deviator<Real> deviator;
    Real trace;
    Real cosine, sine;  ///< of the rotation in the plane
};

/// Mid-step gradient G = H (I - H/2)^-1, exact for every affine motion: its symmetric part vanishes in a
/// rigid rotation, and the Cayley transform of its skew part is that rotation (Hughes & Winget 1980).
template <class Real, Geometry geometry>
[[gnu::always_inline]] inline StepStrain<Real> step_strain(const Gradient<Real>& h) {
    // With D = det(I - H/2) the tangent of half the rotation is q/D, so that one division serves all.
    const Real determinant = h.h11 * h.h22 - h.h12 * h.h21;
    const Real d = 1.0 - 0.5 * (h.h11 + h.h22) + 0.25 * determinant;
    const Real q = 0.25 * (h.h21 - h.h12);
    const Real dd = d * d, qq = q * q, sum = dd + qq;
    const Real both = 1.0 / (d * sum);
    const Real inverse = both * sum, scale = both * d;
    const Real g11 = (h.h11 - 0.5 * determinant) * inverse;
    const Real g22 = (h.h22 - 0.5 * determinant) * inverse;
    const Real shear = (h.h12 + h.h21) * inverse;

    StepStrain<Real> strain;
    const Real in_plane = g11 + g22;
    strain.deviator.d = 0.5 * (g11 - g22);
    strain.deviator.s = 0.5 * shear;
    if constexpr (geometry == Geometry::axisymmetric) {
        // Mid-step hoop strain u / (r - u/2), to second order in u/r: no rotation touches it.
        const Real hoop = h.hoop * (1.0 + 0.5 * h.hoop);
        strain.trace = in_plane + hoop;
        strain.deviator.m = 0.5 * in_plane - strain.trace * (1.0 / 3.0);
    } else if constexpr (geometry == Geometry::plane_strain) {
        strain.trace = in_plane;
        strain.deviator.m = in_plane * (1.0 / 6.0);
    } else {
        // Plane stress: the in-plane mean belongs to the (in-plane) bulk law, nothing is left for m.
        strain.trace = in_plane;
        strain.deviator.m = 0.0 * in_plane;
    }
    strain.cosine = (dd - qq) * scale;
    strain.sine = 2.0 * (q * d) * scale;
    // The increment belongs to mid-step; the mean of it and of it turned by the whole step is it turned by
    // half a step, to second order. Without this the work of stresses misses the stored energy by the first
    // order of a step.
    Deviator<Real> turned = strain.deviator;
    rotate(turned, strain.cosine, strain.sine);
    strain.deviator.d = 0.5 * (strain.deviator.d + turned.d);
    strain.deviator.s = 0.5 * (strain.deviator.s + turned.s);
    return strain;
}

/// Cauchy stress.
template <class Real>
struct Stress {
    Real s11, s22, s33, s12;
};

/// Cauchy stress from its mean and the Kirchhoff deviator; inverse_ratio = 1/J.
template <class Real, Geometry geometry>
[[gnu::always_inline]] inline Stress<Real> total_stress(Real mean, const Deviator<Real>& tau,
                                                        Real inverse_ratio) {
    const Real m = inverse_ratio * tau.m, d = inverse_ratio * tau.d, s = inverse_ratio * tau.s;
    if constexpr (geometry == Geometry::plane_stress) {
        return {mean + d, mean - d, 0.0 * mean, s};
    } else {
        return {mean + m + d, mean + m - d, mean - 2.0 * m, s};
    }
}

/// Work of a viscous pressure over a step, half with its value at the start and half with that at the end, as
/// nodal forces work in a leapfrog: what the ledger books then is what the nodes lost. Keeps the pressure for
/// the next step.
template <class Real>
[[gnu::always_inline]] inline Real viscous_work(double* kept, Real pressure, Real volume_change) {
    const Real before = load<Real>(kept);
    store(kept, pressure);
    return -0.5 * (before + pressure) * volume_change;
}

/// Bulk viscosity (von Neumann & Richtmyer; linear term Landshoff), a pressure in compression only:
/// q = rho h (c1 c |D| + c2 h D^2) with D = `rate`, h^2 = `area` and c^2 = p_wave / rho.
template <class Real>
[[gnu::always_inline]] inline Real bulk_viscosity(Real rate, Real density, Real area,
                                                  const ElasticConstants& material) {
    const Real zero = 0.0 * rate;
    const Real closing = rate < 0.0 ? -rate : zero;
    const Real mass = density * area;
    return closing * (material.viscosity_linear * square_root(Real(mass * material.p_wave)) +
                      material.viscosity_quadratic * (mass * closing));
}

/// The coefficients of a function of the four corners in the basis 1, xi_I, eta_I, xi_I eta_I (corner signs).
template <class Real>
struct Modes {
    Real c0, c1, c2, c3;
};

/// Sums of corner values with the corner signs: (sum a, sum xi a, sum eta a, sum xi eta a).
template <class Real>
[[gnu::always_inline]] inline Modes<Real> to_modes(Real a1, Real a2, Real a3, Real a4) {
    const Real p = a1 + a3, q = a2 + a4, u = a3 - a1, w = a2 - a4;
    return {p + q, u + w, u - w, p - q};
}

/// Reciprocals of four values by one division.
template <class Real>
[[gnu::always_inline]] inline void invert(Real (&values)[4]) {
    const Real first = values[0] * values[1], second = values[2] * values[3];
    const Real all = 1.0 / (first * second);
    const Real of_first = all * second, of_second = all * first;
    const Real inverse[4] = {of_first * values[1], of_first * values[0], of_second * values[3],
                             of_second * values[2]};
    for (int k = 0; k < 4; ++k) values[k] = inverse[k];
}

template <class Real>
[[gnu::always_inline]] inline Real square_of(const Gradient<Real>& h) {
    return h.h11 * h.h11 + h.h12 * h.h12 + (h.h21 * h.h21 + h.h22 * h.h22) + h.hoop * h.hoop;
}

/// Keeps the largest square of what this step strains an element.
template <class Real>
[[gnu::always_inline]] inline void keep_largest(double* squares, Real square) {
    const Real kept = load<Real>(squares);
    store(squares, Real(square > kept ? square : kept));
}

template <class Real>
[[gnu::always_inline]] inline Real magnitude(Real a) {
    return a < 0.0 ? -a : a;
}

/// Corner values c0 + xi_I c1 + eta_I c2 + xi_I eta_I c3, corners 1 to 4 = (--), (+-), (++), (-+).
template <class Real>
struct Corners {
    Real a1, a2, a3, a4;
};

template <class Real>
[[gnu::always_inline]] inline Corners<Real> to_corners(const Modes<Real>& m) {
    const Real p = m.c0 + m.c3, q = m.c0 - m.c3, u = m.c1 + m.c2, w = m.c1 - m.c2;
    return {p - u, q + w, p + u, q - w};
}

/// Geometry of a bilinear quad in modes: x = x0 + x1 xi + x2 eta + x3 xi eta, Jacobian J0 + J1 xi + J2 eta.
template <class Real>
struct QuadGeometry {
    Real x0, x1, x2, x3, y1, y2, y3, j0, j1, j2;
};

template <class Real>
[[gnu::always_inline]] inline QuadGeometry<Real> quad_geometry(const Modes<Real>& x, const Modes<Real>& y) {
    QuadGeometry<Real> g;
    g.x0 = 0.25 * x.c0;
    g.x1 = 0.25 * x.c1;
    g.x2 = 0.25 * x.c2;
    g.x3 = 0.25 * x.c3;
    g.y1 = 0.25 * y.c1;
    g.y2 = 0.25 * y.c2;
    g.y3 = 0.25 * y.c3;
    g.j0 = g.x1 * g.y2 - g.x2 * g.y1;
    g.j1 = g.x1 * g.y3 - g.x3 * g.y1;
    g.j2 = g.x3 * g.y2 - g.x2 * g.y3;
    return g;
}

/// Exact integrals over a bilinear quad with weight w = r (axisymmetric, per radian) or 1 (plane, unit
/// thickness), as modes: bx_I = int N_I,x w dA and by_I = int N_I,y w dA have no constant mode; the hoop row
/// int N_I dA has no xi eta mode. `volume` = int w dA.
template <class Real>
struct QuadIntegrals {
    Real volume;
    Real bx1, bx2, bx3;
    Real by1, by2, by3;
    Real hoop0, hoop1, hoop2;
};

template <class Real, Geometry geometry>
[[gnu::always_inline]] inline QuadIntegrals<Real> quad_integrals(const QuadGeometry<Real>& g) {
    QuadIntegrals<Real> b;
    if constexpr (geometry == Geometry::axisymmetric) {
        constexpr double third = 1.0 / 3.0;
        b.volume = 4.0 * (g.x0 * g.j0 + third * (g.x1 * g.j1 + g.x2 * g.j2));
        b.bx1 = g.x0 * g.y2 + third * (g.x1 * g.y3);
        b.bx2 = -(g.x0 * g.y1 + third * (g.x2 * g.y3));
        b.bx3 = third * (g.x2 * g.y2 - g.x1 * g.y1);
        b.by1 = -(g.x0 * g.x2 + third * (g.x1 * g.x3));
        b.by2 = g.x0 * g.x1 + third * (g.x2 * g.x3);
        b.by3 = third * (g.x1 * g.x1 - g.x2 * g.x2);
        b.hoop0 = g.j0;
        b.hoop1 = third * g.j1;
        b.hoop2 = third * g.j2;
    } else {
        b.volume = 4.0 * g.j0;
        b.bx1 = g.y2;
        b.bx2 = -g.y1;
        b.by1 = -g.x2;
        b.by2 = g.x1;
        b.bx3 = b.by3 = b.hoop0 = b.hoop1 = b.hoop2 = 0.0 * g.j0;
    }
    return b;
}

}  // namespace percuss::PERCUSS_ISA
