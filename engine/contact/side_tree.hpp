#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "contact/surface.hpp"
#include "dynamics/node.hpp"

namespace percuss {

/// A balanced tree of boxes over sides in chain order: neighbours along the chain are neighbours in the tree,
/// so the tree needs no sorting and keeps its shape for the whole run; only its boxes are fitted anew.
class SideTree {
  public:
    struct Nearest {
        std::int32_t side = -1;
        double distance = 0;  ///< [length]
    };

    explicit SideTree(std::size_t sides);
    void fit(const Node* nodes, const std::vector<Side>& sides);
    /// The side nearest to (x, y) that is none of `except`, at the present positions of the nodes; the boxes
    /// may be out of date by a motion of at most `slack`. side = -1 when there is none.
    [[nodiscard]] Nearest nearest(const Node* nodes, const std::vector<Side>& sides, double x, double y,
                                  double slack, std::array<std::int32_t, 3> except = {-1, -1, -1}) const;

  private:
    struct Box {
        double min_x, min_y, max_x, max_y;
    };
    std::size_t side_count_, leaves_;
    std::vector<Box> boxes_;  // heap order: children of k at 2k, 2k + 1; leaves from leaves_ on
};

}  // namespace percuss
