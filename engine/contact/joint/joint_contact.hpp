#pragma once

#include <cassert>
#include <span>
#include <typeinfo>
#include <vector>

#include "contact/joint/coupling.hpp"
#include "contact/joint/row_contact.hpp"
#include "contact/solvers/bounded.hpp"

namespace percuss {

/// All pairs at once: for each group of rows that share nodes, forces C >= 0 with
///     dt kick (G M^-1 G^T) C - P >= 0,  C . (dt kick (G M^-1 G^T) C - P) = 0,
/// G the gap rates of the rows at x_n by nodal velocities, P how deep the predicted motion would go
/// (row_builder.hpp). No row closes further than its gap within the step, no force pulls, and where a gap
/// stays open there is no force. The answer does not depend on the order of pairs. At the rim of a hole,
/// where one node belongs to several pairs and rows depend on each other, the rows conflict as equations but
/// not as inequalities.
class JointContact : public RowContact {
  public:
    JointContact(const Scene& scene, const Mesh& mesh) : JointContact(scene, mesh, nullptr) {}

    [[nodiscard]] std::unique_ptr<ContactMethod> copy() const override {
        assert(typeid(*this) == typeid(JointContact));  // a kind of it that has no copy() would be cut short
        return std::make_unique<JointContact>(*this);
    }
    void become(const ContactMethod& other) override { *this = dynamic_cast<const JointContact&>(other); }
    void change(const std::vector<double>& friction, const ContactSolver& solver) override;

  protected:
    /// @param condition of all rows; null: each pair's own.
    JointContact(const Scene& scene, const Mesh& mesh, ConditionOf condition);

    /// Solves for the forces of the chosen rows and puts their impulses on the nodes.
    void solve(PredictedMotion& motion, ContactSolverStatistics& statistics) override;

    // What a solution is made of.
    virtual void assemble(const PredictedMotion& motion);
    /// Contact forces for the present penetration_, from the present standing_ of the forces.
    virtual void solve_forces(ContactSolverStatistics& statistics);
    static void clear_impulses(const PredictedMotion& motion);
    void add_impulses(const PredictedMotion& motion);
    void add_impulse(const RowSpan& rows, const ContactRow& row, const PredictedMotion& motion);
    [[nodiscard]] double opening(std::span<const RowTerm> terms,
                                 const PredictedMotion& motion) const override;
    [[nodiscard]] double deepest_penetration() const override;
    double correct(PredictedMotion& motion) override;
    [[nodiscard]] bool has_row(std::size_t place) const { return coupling_.has_row(place); }
    [[nodiscard]] std::size_t row_index(std::size_t place) const;  ///< place in the matrix, that has one

    Coupling coupling_;                ///< of the chosen rows
    std::vector<double> penetration_;  ///< per place in the matrix: what the forces have to prevent

  private:
    std::vector<char> listed_;  ///< per node of the mesh: among the touched ones of this step
    AnyNonnegativeSolver solver_;
    ForceSolver solver_kind_;
    std::vector<double> force_;  ///< per place in the matrix
    std::vector<char> standing_;
};

}  // namespace percuss
