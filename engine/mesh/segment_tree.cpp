#include "mesh/segment_tree.hpp"

#include <algorithm>
#include <numeric>

namespace percuss {
namespace {

constexpr std::size_t leaf_size = 8;

double distance(const Segment& segment, const Vec2& point) {
    const Vec2 along = segment.to - segment.from;
    const double squared = along.squaredNorm();
    const double s = squared > 0 ? std::clamp((point - segment.from).dot(along) / squared, 0.0, 1.0) : 0.0;
    return (segment.from + s * along - point).norm();
}

/// +1 or -1 where the ray from the point along the first axis crosses the segment upwards or downwards, else
/// 0.
int crossing(const Segment& segment, const Vec2& p) {
    const bool from_below = segment.from.y() <= p.y(), to_below = segment.to.y() <= p.y();
    if (from_below == to_below) return 0;
    const Vec2 along = segment.to - segment.from, to_point = p - segment.from;
    const double side = along.x() * to_point.y() - along.y() * to_point.x();
    if (from_below) return side > 0 ? 1 : 0;
    return side < 0 ? -1 : 0;
}

}  // namespace

SegmentTree::SegmentTree(std::vector<Segment> segments)
    : segments_(std::move(segments)), order_(segments_.size()) {
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    if (!segments_.empty()) build(0, segments_.size());
}

std::size_t SegmentTree::build(std::size_t begin, std::size_t end) {
    Node node{segments_[order_[begin]].from, segments_[order_[begin]].from, begin, end, 0, 0};
    for (std::size_t i = begin; i < end; ++i) {
        const auto& [from, to] = segments_[order_[i]];
        node.low = node.low.cwiseMin(from).cwiseMin(to);
        node.high = node.high.cwiseMax(from).cwiseMax(to);
    }
    const std::size_t index = nodes_.size();
    nodes_.push_back(node);
    if (end - begin <= leaf_size) return index;
    const auto axis = (node.high - node.low).x() > (node.high - node.low).y() ? 0 : 1;
    const std::size_t middle = (begin + end) / 2;
    const auto at = [&](std::size_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(begin), at(middle), at(end), [&](std::size_t a, std::size_t b) {
        return segments_[a].from[axis] + segments_[a].to[axis] <
               segments_[b].from[axis] + segments_[b].to[axis];
    });
    const std::size_t left = build(begin, middle), right = build(middle, end);
    nodes_[index].left = left;
    nodes_[index].right = right;
    return index;
}

std::optional<SegmentTree::Nearest> SegmentTree::nearest(const Vec2& point, const Filter& accept) const {
    std::optional<Nearest> best;
    const auto to_box = [&](std::size_t index) {
        const Node& node = nodes_[index];
        return (point.cwiseMax(node.low).cwiseMin(node.high) - point).norm();
    };
    std::vector<std::size_t> stack;
    if (!nodes_.empty()) stack.push_back(0);
    while (!stack.empty()) {
        const std::size_t index = stack.back();
        stack.pop_back();
        if (best && to_box(index) >= best->distance) continue;
        const Node& node = nodes_[index];
        if (node.left != 0) {
            const bool left_first = to_box(node.left) < to_box(node.right);
            stack.push_back(left_first ? node.right : node.left);
            stack.push_back(left_first ? node.left : node.right);
            continue;
        }
        for (std::size_t i = node.begin; i < node.end; ++i) {
            const double d = distance(segments_[order_[i]], point);
            if ((!best || d < best->distance) && accept(order_[i])) best = Nearest{order_[i], d};
        }
    }
    return best;
}

int SegmentTree::winding(const Vec2& point) const {
    int sum = 0;
    std::vector<std::size_t> stack;
    if (!nodes_.empty()) stack.push_back(0);
    while (!stack.empty()) {
        const Node& node = nodes_[stack.back()];
        stack.pop_back();
        if (node.high.x() < point.x() || node.low.y() > point.y() || node.high.y() <= point.y()) continue;
        if (node.left != 0) {
            stack.push_back(node.left);
            stack.push_back(node.right);
            continue;
        }
        for (std::size_t i = node.begin; i < node.end; ++i) sum += crossing(segments_[order_[i]], point);
    }
    return sum;
}

}  // namespace percuss
