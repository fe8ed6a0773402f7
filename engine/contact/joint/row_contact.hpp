#pragma once

#include <span>
#include <vector>

#include "contact/contact_method.hpp"
#include "contact/joint/row_builder.hpp"
#include "contact/surface.hpp"

namespace percuss {

/// What all methods share that find rows for all pairs at x_n and solve for the forces of some of them: which
/// rows there are, which to begin with, which to add, and what to remember of them. How forces are found and
/// what they move is the matter of each.
class RowContact : public ContactMethod {
  public:
    void resolve(PredictedMotion& motion, RunStatistics& statistics) override;
    [[nodiscard]] RowSpan rows(std::size_t pair) const override;
    [[nodiscard]] double penetration(std::size_t pair, const Node*) const override {
        return pairs_[pair].builder->deepest();
    }
    [[nodiscard]] int negative_forces(std::size_t) const override { return 0; }
    void restart(const std::vector<std::vector<std::int32_t>>& active) override;
    void change(const std::vector<double>& friction, const ContactSolver& solver) override;

  protected:
    /// @param condition of all rows; null: each pair's own.
    RowContact(const Scene& scene, const Mesh& mesh, ConditionOf condition);

    /// The problem begins with the rows that had force in the last step and those that the prediction closes.
    virtual void choose_rows();
    /// Solves for the forces of the chosen rows.
    virtual void solve(PredictedMotion& motion, ContactSolverStatistics& statistics) = 0;
    /// Adds the rows that the forces found so far would close too far. @returns whether there were any.
    [[nodiscard]] virtual bool add_violated(const PredictedMotion& motion);
    /// By how much the forces found so far open a row within the step [length].
    [[nodiscard]] virtual double opening(std::span<const RowTerm> terms,
                                         const PredictedMotion& motion) const = 0;
    /// The largest of the penetrations that the forces found so far have prevented; 0 when there is none
    /// [length].
    [[nodiscard]] virtual double deepest_penetration() const = 0;
    /// Moves the nodes by what was found. @returns the largest change of a velocity.
    virtual double correct(PredictedMotion& motion) = 0;
    /// Whether contact moves nodes when nothing can touch, too.
    [[nodiscard]] virtual bool solves_without_rows() const { return false; }

    void empty_problem();
    void put_in_problem(std::size_t row);  ///< rows in ascending order
    /// Of a row in the problem: where its force will stand, or stands (BoundedSolver).
    [[nodiscard]] char& expected(std::size_t row) { return expected_[row]; }
    [[nodiscard]] std::span<const char> all_expected() const { return expected_; }
    [[nodiscard]] std::size_t rows_begin(std::size_t pair) const { return pairs_[pair].rows_begin; }
    [[nodiscard]] std::size_t rows_end(std::size_t pair) const { return pairs_[pair].rows_end; }
    [[nodiscard]] RowBuilder::Size size_of(std::size_t pair) const { return pairs_[pair].builder->size(); }
    [[nodiscard]] const RowBuilder::Size& room() const { return room_; }  ///< of all pairs

    double reach_ = 0;  ///< rows are found for as much more motion as this [length]
    /// Rows are found for the fastest motion so far in a step as long as this, too [time].
    double longest_step_ = 0;
    ContactRows rows_;                  ///< all that could close in the step, pair by pair
    std::vector<std::int32_t> chosen_;  ///< rows in the problem, ascending

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
        double fastest = 0;                                        ///< relative motion so far [velocity]
        double relative = 0, master_motion = 0, slave_motion = 0;  ///< bounds within this step [length]
    };

    std::size_t add_surface(const Surface& surface);
    void find(const PredictedMotion& motion);
    void remember();
    void hold_gaps(Pair& pair);

    double recovery_speed_;
    std::vector<Moving> surfaces_;
    std::vector<Pair> pairs_;
    std::vector<char> in_problem_;   ///< per row
    std::vector<char> expected_;     ///< per row in the problem: where its force will stand
    std::vector<double> next_held_;  ///< per key of a pair
    RowBuilder::Size room_{0, 0, 0};
};

}  // namespace percuss
