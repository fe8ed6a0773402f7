#pragma once

#include <vector>

#include "contact/assembly.hpp"
#include "contact/scheme.hpp"
#include "contact/solvers/bounded.hpp"

namespace percuss {

/// The nodal projection of Anderheggen, Ekchian, Heiduschke & Bartelt (1993): at the predicted positions
/// every master node that penetrates a slave side gets a force C_m normal to that side, its reaction shared
/// by the side's nodes, so large that all penetrations vanish at the end of the step (dt^2 is dt * kick where
/// the step changes):
///     dt^2 (M_m^-1 + E^T M_s^-1 E) C_m = P            (6)
/// Displacements and velocities are corrected by the accelerations due to C. No iteration, no damping, no
/// stiffness. Conserves linear momentum exactly; takes the energy of the plastic stop of the contact nodes,
/// never adds any. Restricted (the default): C >= 0 by active set. Unrestricted: C as the equations give it,
/// as in the paper.
class Projection final : public PairScheme {
  public:
    Projection(PenetrationSearch search, ContactSign sign, std::int32_t node_count);

    void find(const PredictedMotion& motion) override;
    void resolve(PredictedMotion& motion) override;
    [[nodiscard]] RowSpan rows() const override { return rows_.all(); }
    [[nodiscard]] double penetration_left(const Node* nodes) const override;
    [[nodiscard]] int negative_forces() const override { return negative_; }
    [[nodiscard]] std::unique_ptr<PairScheme> copy() const override {
        return std::make_unique<Projection>(*this);
    }
    void become(const PairScheme& other) override { *this = dynamic_cast<const Projection&>(other); }
    void forget() override;

  private:
    void solve_forces(const PredictedMotion& motion);
    void correct(const ContactRow& row, PredictedMotion& motion) const;

    PenetrationSearch search_;
    ContactSign sign_;
    ContactAssembly assembly_;
    BoundedSolver bounded_;
    ProfileCholesky cholesky_;
    ContactRows rows_;
    ProfileMatrix matrix_;
    std::vector<double> penetration_, force_;
    std::vector<char> active_;
    int negative_ = 0;
};

}  // namespace percuss
