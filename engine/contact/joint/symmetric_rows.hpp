#pragma once

#include <algorithm>
#include <utility>

#include "contact/joint/near_search.hpp"
#include "contact/joint/row_builder.hpp"

namespace percuss {

/// "symmetric": the nodes of each surface are kept out of the sides of the other, both ways in the one
/// problem: the exact condition that two polygons do not overlap, up to first order of the motion. (Two
/// passes one after the other, averaged, fail the patch: Papadopoulos & Taylor 1992,
/// Comput. Methods Appl. Mech. Engrg. 94, 373; as inequalities of one problem they pass it.) Knows no roles;
/// conserves what a one-way pass conserves. Where faces are flat its rows depend on each other, and which of
/// them bear the force is a matter of the solver.
class SymmetricRows final : public RowBuilder {
  public:
    /// @param one the master's nodes, @param other the slave's.
    SymmetricRows(NearSearch one, NearSearch other) : one_(std::move(one)), other_(std::move(other)) {}

    void find(const StepMotion& motion, ContactRows& rows) override {
        one_.find(motion, rows);
        other_.find(motion, rows);
    }
    void advance(const MotionBounds& moved) override {
        one_.advance(moved.relative, moved.slave);
        other_.advance(moved.relative, moved.master);
    }
    [[nodiscard]] double deepest() const override { return std::max(one_.deepest(), other_.deepest()); }
    void restart(const std::vector<std::int32_t>& active) override {
        one_.restart(active);
        other_.restart(active);
    }
    [[nodiscard]] std::unique_ptr<RowBuilder> copy() const override {
        return std::make_unique<SymmetricRows>(*this);
    }
    [[nodiscard]] Size size() const override {
        const std::size_t nodes = one_.master().nodes.size() + other_.master().nodes.size();
        return {nodes, nodes, 3 * nodes};
    }

  private:
    NearSearch one_, other_;
};

}  // namespace percuss
