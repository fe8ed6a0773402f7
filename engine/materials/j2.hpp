#pragma once

#include "materials/elastic.hpp"

namespace percuss::PERCUSS_ISA {

/// One point whose elastic trial stress is beyond the yield stress: what its hardening law sees of it. Cauchy
/// stresses.
struct Trial {
    double equivalent;    ///< q = sqrt(3/2 s:s) of the trial deviator [stress]
    double triple_shear;  ///< 3 mu / J: by this q falls for each unit of plastic strain [stress]
    double old_along;     ///< stress before the step along the flow direction, 3/2 s_old:s_trial / q [stress]
    double volume_ratio;  ///< J, present volume over initial volume
    double density;       ///< initial [mass/length^3]
    double dt;            ///< [time]

    /// Plastic work of the step per present volume (J of it per initial volume): mean of the stresses before
    /// and after it, as the nodal forces' work is booked, so that elastic energy and plastic work add up to
    /// the ledger's internal work [stress].
    [[nodiscard]] double work(double plastic_strain, double equivalent_after) const {
        return 0.5 * plastic_strain * (old_along + equivalent_after);
    }
};

/// Plastic strain of a step, and the equivalent stress at its end [stress].
struct Flow {
    double plastic_strain, equivalent;
};

/// Finite-strain J2 plasticity, hypoelastic: radial return of the rotated deviator plus elastic increment
/// (Wilkins 1964; Krieg & Key 1976). A Hardening finds the plastic strain x of the step from its consistency
/// condition
///   q - 3 mu / J x = yield stress after x
/// in Cauchy stress, and keeps its state per point: equivalent plastic strain, yield stress (so that elastic
/// steps evaluate no law), ...
template <class Hardening>
struct J2 {
    static constexpr int extra_state = Hardening::state_size;

    /// @param stress rotated Kirchhoff deviator J s on entry, new one on return
    /// @param state of the hardening, [component][lane]
    /// @param volume_ratio J, present over initial volume
    /// @returns plastic work per initial volume [stress]
    template <class Real>
    [[gnu::always_inline]] static Real update(Deviator<Real>& stress, const Deviator<Real>& strain_increment,
                                              double* state, const Batch& batch, Real volume_ratio,
                                              double dt) {
        const Deviator<Real> old = stress;
        Elastic::update(stress, strain_increment, batch.material);
        const Real square = 9.0 * (stress.m * stress.m) + 3.0 * (stress.d * stress.d + stress.s * stress.s);
        const Real yield = volume_ratio * load<Real>(state + block_lanes);
        const Real excess = square - yield * yield;

        Real work = 0.0 * square;
        double beyond[lanes_of<Real>];
        store(beyond, excess);
        bool yields = false;
        for (const double value : beyond) yields |= value > 0;
        if (!yields) return work;

        const Real along = 9.0 * (old.m * stress.m) + 3.0 * (old.d * stress.d + old.s * stress.s);
        double squares[lanes_of<Real>], alongs[lanes_of<Real>], ratios[lanes_of<Real>];
        double scales[lanes_of<Real>], works[lanes_of<Real>];
        store(squares, square);
        store(alongs, along);
        store(ratios, volume_ratio);
        for (int lane = 0; lane < lanes_of<Real>; ++lane) {
            scales[lane] = 1;
            works[lane] = 0;
            if (!(beyond[lane] > 0)) continue;
            const double kirchhoff = std::sqrt(squares[lane]), inverse = 1 / ratios[lane];
            const Trial trial{kirchhoff * inverse,
                              3 * batch.material.shear * inverse,
                              alongs[lane] / kirchhoff * inverse,
                              ratios[lane],
                              batch.material.density,
                              dt};
            const Flow flow = Hardening::flow(*std::get_if<typename Hardening::Parameters>(&batch.plasticity),
                                              trial, state + lane);
            scales[lane] = flow.equivalent / trial.equivalent;
            works[lane] = ratios[lane] * trial.work(flow.plastic_strain, flow.equivalent);
        }
        const Real scale = load<Real>(scales);
        stress.m *= scale;
        stress.d *= scale;
        stress.s *= scale;
        return load<Real>(works);
    }
};

}  // namespace percuss::PERCUSS_ISA
