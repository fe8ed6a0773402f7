#pragma once

#include "elements/lanes.hpp"

namespace percuss::PERCUSS_ISA {

/// Symmetric, trace-free tensor of a plane or axisymmetric state: the parts that a rotation in the plane
/// keeps and mixes.
///   s_11 = m + d,  s_22 = m - d,  s_33 = -2 m,  s_12 = s
template <class Real>
struct Deviator {
    Real m, d, s;
};

/// Rotates a deviator by the angle whose half tangent is w/2 (Cayley transform of the mid-step spin w: the
/// exact rotation of a rigid step; Hughes & Winget 1980, doi:10.1002/nme.1620151210).
template <class Real>
[[gnu::always_inline]] inline void rotate(Deviator<Real>& stress, Real cosine, Real sine) {
    const Real cosine2 = cosine * cosine - sine * sine;
    const Real sine2 = 2.0 * (sine * cosine);
    const Real d = cosine2 * stress.d - sine2 * stress.s;
    stress.s = sine2 * stress.d + cosine2 * stress.s;
    stress.d = d;
}

/// Mean Cauchy stress from 1/J, tension positive: U'(J) of U = K/2 (J + 1/J - 2). Its Kirchhoff stress K/2 (J
/// - 1/J) agrees with Hencky's K ln J to third order, costs no logarithm and goes to -infinity as J -> 0.
template <class Real>
[[gnu::always_inline]] inline Real mean_stress_of_volume(Real inverse_ratio, double bulk) {
    return (0.5 * bulk) * (1.0 - inverse_ratio * inverse_ratio);
}

/// The same by the difference of volumes: exactly 0 at the initial one, where initial * (1 / volume) need not
/// be 1, and without cancellation near it.
template <class Real>
[[gnu::always_inline]] inline Real mean_stress_of_volume(Real volume, Real initial, Real inverse_volume,
                                                         double bulk) {
    return (0.5 * bulk) * ((volume - initial) * inverse_volume) * (1.0 + initial * inverse_volume);
}

/// Hypoelastic Kirchhoff deviator tau = J s, the seam where plastic laws go: a law takes the rotated deviator
/// and the mid-step deviatoric strain increment to the new deviator, keeping `extra_state` doubles of its own
/// per point. Of Kirchhoff stress because the power per initial volume is then tau : d = d/dt (tau : tau / 4
/// mu): an energy exists at any strain.
struct Elastic {
    static constexpr int extra_state = 0;

    template <class Real>
    [[gnu::always_inline]] static void update(Deviator<Real>& stress, const Deviator<Real>& strain_increment,
                                              const ElasticConstants& material) {
        const double two_mu = 2.0 * material.shear;
        stress.m += two_mu * strain_increment.m;
        stress.d += two_mu * strain_increment.d;
        stress.s += two_mu * strain_increment.s;
    }
};

}  // namespace percuss::PERCUSS_ISA
