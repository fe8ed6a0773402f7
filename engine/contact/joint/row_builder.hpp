#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "contact/joint/condition.hpp"
#include "contact/row.hpp"
#include "dynamics/node.hpp"

namespace percuss {

/// What builders of rows need to know of a step.
struct StepMotion {
    const Node* nodes = nullptr;  ///< predicted positions, and the velocities that led there
    double dt = 0;                ///< of the step: positions x_n before it were dt * velocity back [time]
    double range = 0;     ///< bound of the relative motion of the two surfaces within the step [length]
    double recovery = 0;  ///< a penetration is taken back by no more than this in the step [length]
    ConditionOf condition = &position_level;
    /// At the velocity level, per key: the gap that a row was met at, negative for one that was not; null:
    /// another level [length].
    const double* held = nullptr;

    /// Whether what rows ask follows from where the nodes are, not from where they go.
    [[nodiscard]] bool springs() const { return condition == &depth_level; }

    /// What a row of a gap, positive when open, and of its rate has to keep. @pre row.key is set
    void set_condition(ContactRow& row, double gap, double rate) const {
        const double at = held ? held[row.key] : 0;
        if (at < 0)
            velocity_level(row, gap, dt * rate, recovery);
        else
            condition(row, gap - at, dt * rate, recovery);
    }
};

/// How far a step has moved the surfaces of a pair in the end, bounds [length].
struct MotionBounds {
    double relative = 0, master = 0, slave = 0;
};

/// Makes the rows of one pair for the joint problem: its contact scheme. Conditions are built at x_n, where
/// the forces of the step act. What a row says of its gap, linear in the motion, is its condition
/// (condition.hpp), whatever the builder.
///
/// Rows are owned by nodes of the pair: those of the master surface count from 0, in the order of the
/// surface, then those of the slave surface. An overlap at the start is
/// kept as an offset of the gaps: see OverlapAllowance.
class RowBuilder {
  public:
    virtual ~RowBuilder() = default;
    /// Appends the rows of this step.
    virtual void find(const StepMotion& motion, ContactRows& rows) = 0;
    /// The step is done.
    virtual void advance(const MotionBounds& moved) = 0;
    /// Largest penetration of a node into the other surface at x_n, as the last find saw it, beyond the
    /// allowances [length].
    [[nodiscard]] virtual double deepest() const = 0;
    /// Forgets positions. @param active owners that count as having been in contact.
    virtual void restart(const std::vector<std::int32_t>& active) = 0;
    [[nodiscard]] virtual std::unique_ptr<RowBuilder> copy() const = 0;

    struct Size {
        std::size_t keys;         ///< every row's key is below
        std::size_t rows, terms;  ///< usual most of a step, to make room for
    };
    [[nodiscard]] virtual Size size() const = 0;
};

/// Owns a builder and is copied with it.
class AnyRowBuilder {
  public:
    explicit AnyRowBuilder(std::unique_ptr<RowBuilder> builder) : builder_(std::move(builder)) {}
    AnyRowBuilder(const AnyRowBuilder& other) : builder_(other.builder_->copy()) {}
    AnyRowBuilder(AnyRowBuilder&&) noexcept = default;
    AnyRowBuilder& operator=(const AnyRowBuilder& other) {
        builder_ = other.builder_->copy();
        return *this;
    }
    AnyRowBuilder& operator=(AnyRowBuilder&&) noexcept = default;
    ~AnyRowBuilder() = default;
    RowBuilder* operator->() { return builder_.get(); }
    const RowBuilder* operator->() const { return builder_.get(); }

  private:
    std::unique_ptr<RowBuilder> builder_;
};

}  // namespace percuss
