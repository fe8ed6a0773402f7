#include "contact/side_tree.hpp"

#include <algorithm>
#include <bit>
#include <limits>

namespace percuss {

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

}  // namespace percuss
