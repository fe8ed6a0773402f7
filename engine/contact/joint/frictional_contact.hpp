#pragma once

#include <memory>
#include <vector>

#include "contact/joint/bipenalty_contact.hpp"
#include "contact/joint/joint_contact.hpp"
#include "contact/joint/penalty_contact.hpp"

namespace percuss {

/// The joint problem with Coulomb friction in the pairs that call for it. Besides the contact force C each of
/// their rows has a friction force T along the tangent of the slave side, with
///     |T| <= friction C;  the node slides only where |T| is at that limit, and against T,
/// at the level of impulses: what slides or sticks is the motion away from x_n, after all impulses of the
/// step. A sticking node keeps no tangential velocity (but for the regularisation of coupling.cpp): it does
/// not creep.
///
/// Contact forces (for given friction) and friction forces (for given limits) are solved in turn, each
/// exactly, until the friction no longer changes what the contact forces have to prevent (Panagiotopoulos
/// 1975, Ingenieur-Archiv 44, 421-432). Rows on one flat face come to that in one round, for friction does
/// not move their nodes along the normal.
///
/// @tparam Normal makes the contact forces: JointContact, or a kind of it whose springs they are. Those
/// know the contact forces beforehand or solve for them; friction is the same: the impulse that stops the
/// slip, up to its limit, without a tangential spring.
template <class Normal>
class FrictionalContact final : public Normal {
  public:
    FrictionalContact(const Scene& scene, const Mesh& mesh);

    [[nodiscard]] RowSpan friction_rows(std::size_t pair) const override;
    [[nodiscard]] int sticking(std::size_t pair) const override { return pairs_[pair].sticking; }
    [[nodiscard]] std::unique_ptr<ContactMethod> copy() const override {
        return std::make_unique<FrictionalContact>(*this);
    }
    void become(const ContactMethod& other) override {
        *this = dynamic_cast<const FrictionalContact&>(other);
    }
    void restart(const std::vector<std::vector<std::int32_t>>& active) override;
    void change(const std::vector<double>& friction, const ContactSolver& solver) override;

  private:
    using Normal::chosen_;
    using Normal::opening;
    using Normal::penetration_;
    using Normal::rows_;

    struct Pair {
        double friction = 0;  ///< coefficient
        std::size_t tangents_begin = 0, tangents_end = 0;
        int sticking = 0;
    };
    /// What limits the friction force of a tangent.
    struct Grip {
        double friction;   ///< coefficient
        std::int32_t row;  ///< the contact row
        bool sticks;
    };

    void choose_rows() override {
        clear_tangents();  // those of the last step, should there be nothing to solve in this one
        Normal::choose_rows();
    }
    void solve(PredictedMotion& motion, ContactSolverStatistics& statistics) override;
    void clear_tangents();
    void choose_tangents(const PredictedMotion& motion);
    void solve_friction(const PredictedMotion& motion);
    [[nodiscard]] double meet_friction(const PredictedMotion& motion, double share);
    void count_sticking();

    std::vector<Pair> pairs_;
    ContactRows tangents_;           ///< of the chosen rows with friction, pair by pair
    std::vector<Grip> grips_;        ///< per tangent
    std::vector<std::int32_t> all_;  ///< 0, 1, 2 ... as many as there are tangents
    Coupling tangential_;
    BoundedSolver bounded_;
    std::vector<double> slip_, limit_, friction_;  ///< per place in the tangential matrix
    std::vector<char> standing_;
};

extern template class FrictionalContact<JointContact>;
extern template class FrictionalContact<PenaltyContact>;
extern template class FrictionalContact<BipenaltyContact>;

}  // namespace percuss
