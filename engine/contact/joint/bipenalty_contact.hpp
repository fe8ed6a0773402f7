#pragma once

#include <memory>

#include "contact/joint/penalty_contact.hpp"

namespace percuss {

/// "bipenalty": the springs of "penalty" with an inertia m_p against the acceleration of the gap (Askes,
/// Carames-Saddler & Rodriguez-Ferran 2010, doi:10.1098/rspa.2009.0350), in rows that are inside at x_n:
///     C = k depth + m_p d2(depth)/dt2, C >= 0.
/// The acceleration is that of all forces, C included: with kick a the change of velocity in the prediction
/// and A = dt kick G M^-1 G',
///     (A + dt kick / m_p) C = dt kick (k / m_p) depth - dt G (kick a),
/// the joint problem with a softer diagonal. m_p = k dt^2 / 4 is the least inertia with which, by Rayleigh's
/// quotient, no frequency of elements and springs together is above 2/dt as long as those of the elements are
/// below, however stiff the springs. Conserves momenta as "penalty". Not energy: a row that comes in takes up
/// inertia at one speed and gives it back at another, and one that comes in between two steps can leave up to
/// three times as fast. Rows that are in and out again then add energy, the more the stiffer the springs:
/// little at a factor of 0.1, percents at 1, and at 10 runs near the critical step blow up, though each row
/// while it is in is stable (tests/verification/CONTACT.md). Costs what the joint problem costs.
class BipenaltyContact : public PenaltyContact {
  public:
    BipenaltyContact(const Scene& scene, const Mesh& mesh);

    [[nodiscard]] std::unique_ptr<ContactMethod> copy() const override {
        assert(typeid(*this) == typeid(BipenaltyContact));
        return std::make_unique<BipenaltyContact>(*this);
    }
    void become(const ContactMethod& other) override { *this = dynamic_cast<const BipenaltyContact&>(other); }
    void change(const std::vector<double>& friction, const ContactSolver& solver) override;

  protected:
    void assemble(const PredictedMotion& motion) override;
    void solve_forces(ContactSolverStatistics& statistics) override {
        JointContact::solve_forces(statistics);
    }
};

}  // namespace percuss
