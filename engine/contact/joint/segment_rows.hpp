#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "contact/joint/near_search.hpp"
#include "contact/joint/row_builder.hpp"

namespace percuss {

/// "segment-to-segment" (mortar): a row for each node A of one surface, the fine one, says that its weighted
/// gap
///     g_A = integral N_A n . (x_fine - x_coarse) / integral N_A
/// does not become negative: the mean of the gap with A's shape function over the parts of the fine sides
/// beside A that coarse sides face (Puso & Laursen 2004, doi:10.1016/j.cma.2003.10.010). Two Gauss points a
/// part, where a pair of sides overlaps, are exact for straight sides; integrals are per radian when
/// axisymmetric. The normal is that of the coarse side: a fine node that slides along it does no false work.
/// Built at x_n, linear in the motion from there. Passes the contact patch on faces that do not match, and
/// momenta as a pass node to side does. A mean gap lets single nodes go in, and a corner all the way: guard
/// rows keep the nodes of both surfaces from going into the other by more than a hundredth of a side.
class SegmentRows final : public RowBuilder {
  public:
    /// @param fine nodes of the fine surface against coarse sides, @param coarse the reverse: the guards.
    SegmentRows(NearSearch fine, NearSearch coarse, bool axisymmetric);

    void find(const StepMotion& motion, ContactRows& rows) override;
    void advance(const MotionBounds& moved) override;
    [[nodiscard]] double deepest() const override;
    void restart(const std::vector<std::int32_t>& active) override;
    [[nodiscard]] std::unique_ptr<RowBuilder> copy() const override {
        return std::make_unique<SegmentRows>(*this);
    }
    [[nodiscard]] Size size() const override;

    /// How far guards let nodes go in, as a part of a mean side.
    static constexpr double guard_slack = 0.01;

  private:
    /// What a node's row has gathered so far.
    struct Weighted {
        std::int32_t node;   ///< index in the fine surface
        double weight, gap;  ///< integrals of N and of N gap
        std::int32_t first;  ///< of its chain of parts
    };
    struct Part {
        RowTerm term;
        bool fine;
        std::int32_t next;
    };

    void allow_overlap();
    void gather(const StepMotion& motion);
    void gather_side(const StepMotion& motion, std::int32_t fine, std::int32_t start);
    bool gather_overlap(const StepMotion& motion, std::int32_t fine, std::int32_t coarse);
    Weighted& row_of(std::int32_t fine_node);
    void add(Weighted& row, std::int32_t node, bool fine, double gx, double gy);
    void emit(const StepMotion& motion, const Weighted& row, ContactRows& rows);

    NearSearch fine_, coarse_;
    bool axisymmetric_;
    std::vector<std::array<std::int32_t, 2>> beside_fine_, beside_coarse_;  ///< per node: sides_beside
    std::vector<std::array<std::int32_t, 2>> ends_;  ///< per fine side: its nodes, as indices in the surface
    std::vector<char> visited_;                      ///< per fine side, 0 between finds
    std::vector<std::int32_t> visits_;
    std::vector<std::int32_t> place_;  ///< per fine node: its row in the making, -1 between finds
    std::vector<Weighted> weighted_;
    std::vector<Part> parts_;
    std::vector<OverlapAllowance> allowance_;  ///< per fine node: of its mean gap
    std::vector<char> near_;  ///< per fine node: had a mean gap within reach in the last step
};

}  // namespace percuss
