#pragma once

#include <array>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include "mesh/mesh.hpp"

namespace percuss {

struct Segment {
    Vec2 from, to;
};

/// A static bounding-box tree over segments: nearest segment and winding number in O(log n).
class SegmentTree {
  public:
    explicit SegmentTree(std::vector<Segment> segments);

    struct Nearest {
        std::size_t segment = 0;
        double distance = std::numeric_limits<double>::infinity();
    };
    using Filter = std::function<bool(std::size_t segment)>;
    /// The nearest of the segments that pass the filter; nothing when none passes.
    [[nodiscard]] std::optional<Nearest> nearest(const Vec2& point, const Filter& accept) const;
    /// How often the segments, taken as closed loops, run left-about around the point: 1 inside a body.
    [[nodiscard]] int winding(const Vec2& point) const;

    [[nodiscard]] const std::vector<Segment>& segments() const { return segments_; }

  private:
    struct Node {
        Vec2 low, high;
        std::size_t begin = 0, end = 0;   // segments in order_
        std::size_t left = 0, right = 0;  // 0: leaf
    };
    std::size_t build(std::size_t begin, std::size_t end);

    std::vector<Segment> segments_;
    std::vector<std::size_t> order_;
    std::vector<Node> nodes_;
};

}  // namespace percuss
