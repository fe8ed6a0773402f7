#pragma once

#include <array>
#include <cassert>
#include <span>
#include <typeinfo>
#include <vector>

#include "contact/contact_method.hpp"
#include "contact/joint/coupling.hpp"
#include "contact/joint/row_builder.hpp"
#include "contact/solvers/bounded.hpp"
#include "contact/surface.hpp"

namespace percuss {

/// All pairs at once: for each group of rows that share nodes, forces C >= 0 with
///     dt kick (G M^-1 G^T) C - P >= 0,  C . (dt kick (G M^-1 G^T) C - P) = 0,
/// G the gap rates of the rows at x_n by nodal velocities, P how deep the predicted motion would go
/// (row_builder.hpp). No row closes further than its gap within the step, no force pulls, and where a gap
/// stays open there is no force. The answer does not depend on the order of pairs. At the rim of a hole,
/// where one node belongs to several pairs and rows depend on each other, the rows conflict as equations but
/// not as inequalities.
class JointContact : public ContactMethod {
  public:
    JointContact(const Scene& scene, const Mesh& mesh) : JointContact(scene, mesh, nullptr) {}

    void resolve(PredictedMotion& motion, RunStatistics& statistics) override;
    [[nodiscard]] RowSpan rows(std::size_t pair) const override;
    [[nodiscard]] double penetration(std::size_t pair, const Node*) const override {
        return pairs_[pair].builder->deepest();
    }
    [[nodiscard]] int negative_forces(std::size_t) const override { return 0; }
    [[nodiscard]] std::unique_ptr<ContactMethod> copy() const override {
        assert(typeid(*this) == typeid(JointContact));  // a kind of it that has no copy() would be cut short
        return std::make_unique<JointContact>(*this);
    }
    void become(const ContactMethod& other) override { *this = dynamic_cast<const JointContact&>(other); }
    void restart(const std::vector<std::vector<std::int32_t>>& active) override;
    void change(const std::vector<double>& friction, const ContactSolver& solver) override;

  protected:
    /// @param condition of all rows; null: each pair's own.
    JointContact(const Scene& scene, const Mesh& mesh, ConditionOf condition);

    /// The problem begins with the rows that had force in the last step and those that the prediction closes.
    virtual void choose_rows();
    /// Adds the rows that the forces found so far would close too far. @returns whether there were any.
    [[nodiscard]] virtual bool add_violated(const PredictedMotion& motion);
    /// Solves for the forces of the chosen rows and puts their impulses on the nodes.
    virtual void solve(PredictedMotion& motion, ContactSolverStatistics& statistics);

    // What a choice and a solution are made of.
    void empty_problem();
    void put_in_problem(std::size_t row);  ///< rows in ascending order
    virtual void assemble(const PredictedMotion& motion);
    /// Contact forces for the present penetration_, from the present standing_ of the forces.
    virtual void solve_forces(ContactSolverStatistics& statistics);
    static void clear_impulses(const PredictedMotion& motion);
    void add_impulses(const PredictedMotion& motion);
    void add_impulse(const RowSpan& rows, const ContactRow& row, const PredictedMotion& motion);
    [[nodiscard]] static double opening(std::span<const RowTerm> terms, const PredictedMotion& motion);
    /// The largest of the predicted penetrations in the problem; 0 when there is none [length].
    [[nodiscard]] double deepest_penetration() const;
    [[nodiscard]] bool has_row(std::size_t place) const { return coupling_.has_row(place); }
    [[nodiscard]] std::size_t row_index(std::size_t place) const;  ///< place in the matrix, that has one
    [[nodiscard]] std::size_t rows_end(std::size_t pair) const { return pairs_[pair].rows_end; }
    [[nodiscard]] RowBuilder::Size size_of(std::size_t pair) const { return pairs_[pair].builder->size(); }

    double longest_step_ = 0;           ///< rows are found as if the step could be as long as this [time]
    ContactRows rows_;                  ///< all that could close in the step, pair by pair
    std::vector<std::int32_t> chosen_;  ///< rows in the problem, ascending
    Coupling coupling_;                 ///< of the chosen rows
    std::vector<double> penetration_;   ///< per place in the matrix: what the forces have to prevent

  private:
    /// A surface that pairs share, and the velocities of its nodes in this step.
    struct Moving {
        std::vector<std::int32_t> nodes;
        std::array<double, 2> lowest, highest;  ///< [velocity]
    };
    /// Where a row stood in the last step.
    enum class Last : char { not_in_problem, open, pressed };
    struct Pair {
        AnyRowBuilder builder;
        ConditionOf condition;
        std::size_t master, slave;      ///< among the surfaces
        std::vector<Last> last = {};    ///< per key
        bool remembers = false;         ///< some row was in the last step
        std::vector<double> held = {};  ///< at the velocity level, per key: StepMotion::held
        std::size_t rows_begin = 0, rows_end = 0;
        double left_open = 0;                                      ///< the widest of the gaps held [length]
        double relative = 0, master_motion = 0, slave_motion = 0;  ///< bounds within this step [length]
    };

    std::size_t add_surface(const Surface& surface);
    void find(const PredictedMotion& motion);
    void correct(const PredictedMotion& motion);
    void remember();
    void hold_gaps(Pair& pair);

    double recovery_speed_;
    std::vector<Moving> surfaces_;
    std::vector<Pair> pairs_;
    std::vector<char> in_problem_;  ///< per row
    std::vector<char> expected_;    ///< per row in the problem: where its force will stand
    std::vector<char> listed_;      ///< per node of the mesh: among the touched ones of this step
    AnyNonnegativeSolver solver_;
    ForceSolver solver_kind_;
    std::vector<double> next_held_;  ///< per key of a pair
    std::vector<double> force_;      ///< per place in the matrix
    std::vector<char> standing_;
    double largest_correction_ = 0;  ///< change of velocity by contact in this step [velocity]
};

}  // namespace percuss
