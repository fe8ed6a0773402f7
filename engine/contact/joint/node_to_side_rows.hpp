#pragma once

#include <cstddef>
#include <utility>

#include "contact/joint/near_search.hpp"
#include "contact/joint/row_builder.hpp"

namespace percuss {

/// "node-to-side": master nodes are kept out of slave sides, one pass, as in the paper. Passes linear
/// momentum and, at x_n, angular momentum exactly. Fails the contact patch where the master side is the
/// coarser one, and a corner of the slave goes in between master nodes.
class NodeToSideRows final : public RowBuilder {
  public:
    /// @param search its nodes are the master's.
    explicit NodeToSideRows(NearSearch search) : search_(std::move(search)) {}

    void find(const StepMotion& motion, ContactRows& rows) override { search_.find(motion, rows); }
    void advance(const MotionBounds& moved) override {
        search_.advance(moved.relative, search_.of_master() ? moved.slave : moved.master);
    }
    [[nodiscard]] double deepest() const override { return search_.deepest(); }
    void restart(const std::vector<std::int32_t>& active) override { search_.restart(active); }
    [[nodiscard]] std::unique_ptr<RowBuilder> copy() const override {
        return std::make_unique<NodeToSideRows>(*this);
    }
    [[nodiscard]] Size size() const override {
        const std::size_t nodes = search_.master().nodes.size();
        return {static_cast<std::size_t>(search_.first_owner()) + nodes, nodes, 3 * nodes};
    }

  private:
    NearSearch search_;
};

}  // namespace percuss
