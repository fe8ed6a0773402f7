#pragma once

#include <memory>
#include <vector>

#include "contact/joint/massless_layer.hpp"
#include "contact/joint/massless_system.hpp"
#include "contact/joint/row_contact.hpp"

namespace percuss {

/// "massless": contact nodes without mass (Khenous, Laborde & Renard 2008,
/// Eur. J. Mech. A/Solids 27, 918-932; Tkachuk & Bischoff 2013, doi:10.1002/nme.4457). Nothing flies into
/// a surface, so nothing is lost when it stops. In each step the layer's displacements u and the contact
/// forces C follow from
///     K u - G^T C = f_ext - f_int,   gap + G u >= 0,  C >= 0,  C . (gap + G u) = 0,
/// K the elastic stiffness of the elements behind the surfaces, f_int their forces at x_n and by K for the
/// motion that is known. One quasidefinite matrix, solved by the active set; for elements that are not
/// elastic, or turn, what does not balance is in f_int of the next step, and is meanwhile taken by the nodes
/// that carry the layer's mass: linear momentum is exact. Energy: no loss at an impact, and none comes in but
/// what does not balance, and half of force times opening where a face parts within a step
/// (tests/verification/CONTACT.md); the first peak of a blow is some 30 % too high, for the front of the wave
/// is steeper. Masses move inwards by half an element. The critical step is that of the nodes with mass, no
/// smaller. A step costs the factorisation of the whole layer, in touch or not. The forces of a step balance
/// the elements' at x_n: they were found in the step before. No friction: a node without mass has no slip to
/// stop.
class MasslessContact final : public RowContact {
  public:
    MasslessContact(const Scene& scene, const Mesh& mesh);

    void resolve(PredictedMotion& motion, RunStatistics& statistics) override;
    [[nodiscard]] RowSpan rows(std::size_t pair) const override {
        return acting_.part(acting_of_[pair][0], acting_of_[pair][1]);
    }
    [[nodiscard]] std::unique_ptr<ContactMethod> copy() const override {
        return std::make_unique<MasslessContact>(*this);
    }
    void become(const ContactMethod& other) override { *this = dynamic_cast<const MasslessContact&>(other); }
    void restart(const std::vector<std::vector<std::int32_t>>& active) override;

  protected:
    [[nodiscard]] bool solves_without_rows() const override { return true; }
    void solve(PredictedMotion& motion, ContactSolverStatistics& statistics) override;
    [[nodiscard]] double opening(std::span<const RowTerm> terms,
                                 const PredictedMotion& motion) const override;
    [[nodiscard]] double deepest_penetration() const override { return deepest_; }
    double correct(PredictedMotion& motion) override;

  private:
    void let_forces_act(PredictedMotion& motion);
    void find_imbalance(const PredictedMotion& motion);

    MasslessLayer layer_;
    MasslessSystem system_;
    ContactRows acting_;                                 ///< that the last step found, with their forces
    std::vector<std::array<std::size_t, 2>> acting_of_;  ///< per pair: first and last + 1
    std::vector<double> contact_;                        ///< per unknown: contact force that acts at x_n
    std::vector<double> imbalance_;  ///< per unknown: f_int - f_ext with the motion that is known
    double deepest_ = 0;             ///< penetration in the problem [length]
};

}  // namespace percuss
