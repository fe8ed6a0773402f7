#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "contact/closest.hpp"
#include "contact/surface.hpp"
#include "dynamics/node.hpp"

namespace percuss {

/// Sides that count in a search for the nearest.
struct AllSides {
    bool operator()(std::int32_t) const { return true; }
};
struct SidesOtherThan {
    std::array<std::int32_t, 3> sides;
    bool operator()(std::int32_t side) const {
        return std::find(sides.begin(), sides.end(), side) == sides.end();
    }
};

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
    /// The side nearest to (x, y) of those that count, at the present positions of the nodes; the boxes may
    /// be out of date by a motion of at most `slack`. side = -1 when there is none.
    /// @param counts whether the side of an index does; asked of the nearer ones only
    /// @param within only sides nearer than this are looked for; the distance where there is none [length]
    template <class Counts = AllSides>
    [[nodiscard]] Nearest nearest(const Node* nodes, const std::vector<Side>& sides, double x, double y,
                                  double slack, const Counts& counts = {},
                                  double within = std::numeric_limits<double>::infinity()) const;

  private:
    struct Box {
        double min_x, min_y, max_x, max_y;
    };
    static constexpr std::size_t leaf_size = 4;  // sides a leaf: one box test costs about as much as one side

    std::size_t side_count_, leaves_;
    std::vector<Box> boxes_;  // heap order: children of k at 2k, 2k + 1; leaves from leaves_ on
};

template <class Counts>
SideTree::Nearest SideTree::nearest(const Node* nodes, const std::vector<Side>& sides, double x, double y,
                                    double slack, const Counts& counts, double within) const {
    Nearest best{-1, within};
    const auto lower_bound = [&](std::size_t k) {
        const Box& box = boxes_[k];
        const double dx = std::max({box.min_x - x, x - box.max_x, 0.0});
        const double dy = std::max({box.min_y - y, y - box.max_y, 0.0});
        return std::sqrt(dx * dx + dy * dy) - slack;
    };
    std::array<std::size_t, 128> stack;  // depth of the tree times two is far below this
    std::size_t top = 0;
    stack[top++] = 1;
    while (top > 0) {
        const std::size_t k = stack[--top];
        if (lower_bound(k) >= best.distance) continue;
        if (k >= leaves_) {
            const std::size_t first = (k - leaves_) * leaf_size;
            for (std::size_t s = first; s < std::min(side_count_, first + leaf_size); ++s) {
                const double distance = std::sqrt(squared_distance(nodes, sides[s], x, y));
                const auto index = static_cast<std::int32_t>(s);
                if (distance < best.distance && counts(index)) best = {index, distance};
            }
            continue;
        }
        const double left = lower_bound(2 * k), right = lower_bound(2 * k + 1);
        stack[top++] = left < right ? 2 * k + 1 : 2 * k;  // the nearer child is looked at first
        stack[top++] = left < right ? 2 * k : 2 * k + 1;
    }
    return best;
}

}  // namespace percuss
