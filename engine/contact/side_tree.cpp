#include "contact/side_tree.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "contact/closest.hpp"

namespace percuss {
namespace {
constexpr std::size_t leaf_size = 4;  // sides a leaf: one box test costs about as much as one side
}

SideTree::SideTree(std::size_t sides)
    : side_count_(sides), leaves_(std::bit_ceil((sides + leaf_size - 1) / leaf_size)), boxes_(2 * leaves_) {}

void SideTree::fit(const Node* nodes, const std::vector<Side>& sides) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    for (std::size_t leaf = 0; leaf < leaves_; ++leaf) {
        Box box{infinity, infinity, -infinity, -infinity};
        for (std::size_t s = leaf * leaf_size; s < std::min(side_count_, (leaf + 1) * leaf_size); ++s) {
            for (const std::int32_t node : {sides[s].i, sides[s].j}) {
                const double* x = nodes[node].x;
                box = {std::min(box.min_x, x[0]), std::min(box.min_y, x[1]), std::max(box.max_x, x[0]),
                       std::max(box.max_y, x[1])};
            }
        }
        boxes_[leaves_ + leaf] = box;
    }
    for (std::size_t k = leaves_ - 1; k >= 1; --k) {
        const Box &a = boxes_[2 * k], &b = boxes_[2 * k + 1];
        boxes_[k] = {std::min(a.min_x, b.min_x), std::min(a.min_y, b.min_y), std::max(a.max_x, b.max_x),
                     std::max(a.max_y, b.max_y)};
    }
}

SideTree::Nearest SideTree::nearest(const Node* nodes, const std::vector<Side>& sides, double x, double y,
                                    double slack, std::array<std::int32_t, 3> except) const {
    Nearest best{-1, std::numeric_limits<double>::infinity()};
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
                const auto index = static_cast<std::int32_t>(s);
                if (std::find(except.begin(), except.end(), index) != except.end()) continue;
                const double distance = std::sqrt(squared_distance(nodes, sides[s], x, y));
                if (distance < best.distance) best = {index, distance};
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
