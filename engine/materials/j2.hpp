#pragma once

#include "materials/elastic.hpp"

namespace percuss::PERCUSS_ISA {

/// Points whose elastic trial stress is beyond the yield stress: what their hardening law sees of it. Cauchy
/// stresses.
template <class Real>
struct Trial {
    Real equivalent;    ///< q = sqrt(3/2 s:s) of the trial deviator [stress]
    Real triple_shear;  ///< 3 mu / J: by this q falls for each unit of plastic strain [stress]
    Real old_along;     ///< stress before the step along the flow direction, 3/2 s_old:s_trial / q [stress]
    Real volume_ratio;  ///< J, present volume over initial volume
    double density;     ///< initial [mass/length^3]
    double dt;          ///< [time]

    /// Plastic work of the step per present volume (J of it per initial volume): mean of the stresses before
    /// and after it, as the nodal forces' work is booked, so that elastic energy and plastic work add up to
    /// the ledger's internal work [stress].
    [[nodiscard]] Real work(Real plastic_strain, Real equivalent_after) const {
        return 0.5 * plastic_strain * (old_along + equivalent_after);
    }
};

/// Plastic strain of a step, and the equivalent stress at its end [stress].
template <class Real>
struct Flow {
    Real plastic_strain, equivalent;
};

/// Finite-strain J2 plasticity, hypoelastic: radial return of the rotated deviator plus elastic increment
/// (Wilkins 1964; Krieg & Key 1976). A Hardening finds the plastic strain x of the step from its consistency
/// condition
///   q - 3 mu / J x = yield stress after x
/// in Cauchy stress, and keeps its state per point: equivalent plastic strain, yield stress (so that elastic
/// steps evaluate no law), ... A law with `on_lanes` takes all points of a register at once, the others take
/// them one by one.
template <class Hardening>
struct J2 {
    static constexpr int extra_state = Hardening::state_size;

    /// @param stress rotated Kirchhoff deviator J s on entry, new one on return
    /// @param state of the hardening, [component][lane]
    /// @param inverse_ratio 1/J, initial over present volume
    /// @returns plastic work per initial volume [stress]
    template <class Real>
    [[gnu::always_inline]] static Real update(Deviator<Real>& stress, const Deviator<Real>& strain_increment,
                                              double* state, const Batch& batch, Real inverse_ratio,
                                              double dt) {
        const Deviator<Real> old = stress;
        Elastic::update(stress, strain_increment, batch.material);
        const Real square = 9.0 * (stress.m * stress.m) + 3.0 * (stress.d * stress.d + stress.s * stress.s);
        const Real yield = load<Real>(state + block_lanes);
        const Real excess = square * (inverse_ratio * inverse_ratio) - yield * yield;
        const Real none = 0.0 * square;
        if (!any_positive(excess)) return none;

        const auto& law = *std::get_if<typename Hardening::Parameters>(&batch.plasticity);
        const Real one = none + 1.0;
        const auto flows = excess > 0.0;
        const Real kirchhoff = square_root(Real(flows ? square : one));
        const Real equivalent = kirchhoff * inverse_ratio, inverse = 1.0 / equivalent;
        const Real volume_ratio = inverse * kirchhoff;
        const Real along = 9.0 * (old.m * stress.m) + 3.0 * (old.d * stress.d + old.s * stress.s);
        const Trial<Real> trial{equivalent,
                                (3 * batch.material.shear) * inverse_ratio,
                                along * inverse * (inverse_ratio * inverse_ratio),
                                volume_ratio,
                                batch.material.density,
                                dt};
        const Flow<Real> flow = flow_of_lanes(law, trial, state, excess);
        const Real scale = flows ? Real(flow.equivalent * inverse) : one;
        stress.m *= scale;
        stress.d *= scale;
        stress.s *= scale;
        return flows ? Real(volume_ratio * trial.work(flow.plastic_strain, flow.equivalent)) : none;
    }

  private:
    /// @param excess positive where a point flows; elsewhere the state stays.
    template <class Real>
    [[gnu::always_inline]] static Flow<Real> flow_of_lanes(const typename Hardening::Parameters& law,
                                                           const Trial<Real>& trial, double* state,
                                                           Real excess) {
        if constexpr (Hardening::on_lanes) {
            return Hardening::template flow<Real>(law, trial, state, excess);
        } else {
            constexpr auto lanes = static_cast<std::size_t>(lanes_of<Real>);
            double beyond[lanes], equivalent[lanes], triple_shear[lanes], along[lanes], ratio[lanes];
            double strains[lanes] = {}, after[lanes] = {};
            store(beyond, excess);
            store(equivalent, trial.equivalent);
            store(triple_shear, trial.triple_shear);
            store(along, trial.old_along);
            store(ratio, trial.volume_ratio);
            for (std::size_t lane = 0; lane < lanes; ++lane) {
                if (!(beyond[lane] > 0)) continue;
                const Flow<double> flow =
                    Hardening::flow(law,
                                    Trial<double>{equivalent[lane], triple_shear[lane], along[lane],
                                                  ratio[lane], trial.density, trial.dt},
                                    state + lane);
                strains[lane] = flow.plastic_strain;
                after[lane] = flow.equivalent;
            }
            return {load<Real>(strains), load<Real>(after)};
        }
    }
};

}  // namespace percuss::PERCUSS_ISA
