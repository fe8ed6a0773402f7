#pragma once

#include <memory>
#include <vector>

#include "contact/joint/joint_contact.hpp"
#include "contact/joint/penalty_stiffness.hpp"

namespace percuss {

/// "penalty": springs against penetration, on the rows of the joint problem,
///     C = k max(0, -gap at x_n),  k = f K A^2 / V (penalty_stiffness.hpp),
/// f 0.1 by default: the usual explicit contact (Hallquist, Goudreau & Benson 1985,
/// Comput. Methods Appl. Mech. Engrg. 51, 107-137). No problem is solved; a row costs some 20 flops. Surfaces
/// go into each other as far as it takes; a node that is deeper than half a side is let go, as everywhere.
/// Conserves linear momentum exactly and angular momentum at x_n; energy, with that of the springs, as the
/// leapfrog conserves that of the elements: nothing is lost at an impact, contact nodes swing instead. Fails
/// the patch where faces do not match, as far as springs differ.
///
/// Springs raise the highest frequency of the mesh. For any forces k_r along rows g_r
///     w^2 <= max over nodes n of 1/m_n sum_r k_r |g_rn| sum_m |g_rm|
/// (block Gershgorin on M^-1 G' k G; m over nodes that move), and the squares of both together are at most
/// their sum; springs alone must not swing faster than 1/dt either, lest nodes that come and go gain energy
/// (step.cpp). All rows within reach of the longest step so far count, in touch or not: the next step takes
/// it up, before they can touch. With `step_of_elements` nothing is said, as where a user trusts a factor of
/// safety: a stiff spring then blows up.
class PenaltyContact : public JointContact {
  public:
    PenaltyContact(const Scene& scene, const Mesh& mesh);

    void resolve(PredictedMotion& motion, RunStatistics& statistics) override;
    [[nodiscard]] std::unique_ptr<ContactMethod> copy() const override {
        assert(typeid(*this) == typeid(PenaltyContact));
        return std::make_unique<PenaltyContact>(*this);
    }
    void become(const ContactMethod& other) override { *this = dynamic_cast<const PenaltyContact&>(other); }
    void change(const std::vector<double>& friction, const ContactSolver& solver) override;

  protected:
    /// Those inside at x_n.
    void choose_rows() override;
    void assemble(const PredictedMotion&) override {}
    void solve_forces(ContactSolverStatistics& statistics) override;
    [[nodiscard]] bool add_violated(const PredictedMotion&) override { return false; }

    [[nodiscard]] double stiffness(const ContactRow& row) const {
        return penalty_ * stiffness_.of(rows_.terms(row), row.master_terms);
    }
    bool bounds_step_;

  private:
    [[nodiscard]] double squared_frequency(const double* inverse_mass);

    PenaltyStiffness stiffness_;
    double penalty_;
    double longest_seen_ = 0;   ///< of the steps so far [time]
    double stored_ = 0;         ///< in the springs at x_n
    std::vector<double> pull_;  ///< per node of the mesh: its sum of the bound; zero between steps
};

}  // namespace percuss
