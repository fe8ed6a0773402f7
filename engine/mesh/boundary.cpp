#include "mesh/boundary.hpp"

#include <algorithm>
#include <stdexcept>
#include <unordered_set>

#include <fmt/format.h>

#include "mesh/segment_tree.hpp"

namespace percuss {
namespace {

std::uint64_t directed(std::int32_t from, std::int32_t to) {
    return static_cast<std::uint64_t>(static_cast<std::uint32_t>(from)) << 32 |
           static_cast<std::uint32_t>(to);
}

template <class Use>
void for_segments(const std::vector<SideChain>& sides, const Use& use) {
    for (const auto& side : sides)
        for (std::size_t i = 1; i < side.nodes.size(); ++i) use(side.nodes[i - 1], side.nodes[i], side.block);
}

double enclosed_area(const Edge& loop, const std::vector<Vec2>& nodes) {
    double twice = 0;
    for (std::size_t i = 0; i < loop.nodes.size(); ++i) {
        const Vec2 a = nodes[static_cast<std::size_t>(loop.nodes[i])];
        const Vec2 b = nodes[static_cast<std::size_t>(loop.nodes[(i + 1) % loop.nodes.size()])];
        twice += a.x() * b.y() - a.y() * b.x();
    }
    return twice / 2;
}

}  // namespace

Boundary::Boundary(const std::vector<SideChain>& sides, const std::vector<Vec2>& nodes)
    : sides_(&sides), nodes_(&nodes) {
    std::unordered_set<std::uint64_t> all;
    for_segments(sides, [&](std::int32_t a, std::int32_t b, std::size_t) {
        if (!all.insert(directed(a, b)).second)
            throw std::invalid_argument("two blocks cover the same side at " + at(a) +
                                        "; blocks may touch but not overlap");
    });
    for_segments(sides, [&](std::int32_t a, std::int32_t b, std::size_t block) {
        if (all.contains(directed(b, a))) return;
        steps_.push_back({a, b, block});
        if (!next_.emplace(a, b).second) pinched_ = a;
    });
}

std::optional<std::pair<std::size_t, Vec2>> Boundary::hanging_node(double tolerance) const {
    std::vector<Segment> segments;
    for (const auto& step : steps_) segments.push_back({point(step.from), point(step.to)});
    const SegmentTree tree(std::move(segments));
    for (const auto& step : steps_) {
        const auto apart = [&](std::size_t i) {
            return steps_[i].from != step.from && steps_[i].to != step.from;
        };
        const auto nearest = tree.nearest(point(step.from), apart);
        if (nearest && nearest->distance <= tolerance) return std::pair(step.block, point(step.from));
    }
    return std::nullopt;
}

void Boundary::require_loops() const {
    if (pinched_)
        throw std::invalid_argument("blocks meet in a single node at " + at(*pinched_) +
                                    "; let them share a whole side, or part them");
}

Vec2 Boundary::point(std::int32_t node) const { return (*nodes_)[static_cast<std::size_t>(node)]; }

std::string Boundary::at(std::int32_t node) const {
    return fmt::format("({:.6g}, {:.6g})", point(node).x(), point(node).y());
}

std::optional<std::int32_t> Boundary::next(std::int32_t node) const {
    const auto found = next_.find(node);
    return found == next_.end() ? std::nullopt : std::optional(found->second);
}

std::vector<Edge> Boundary::outlines() const {
    std::vector<Edge> loops;
    std::unordered_set<std::int32_t> walked;
    for (const auto& [start, to, block] : steps_) {
        if (walked.contains(start)) continue;
        Edge loop{"", {}, true};
        for (auto node = start; walked.insert(node).second; node = next_.at(node)) loop.nodes.push_back(node);
        loops.push_back(std::move(loop));
    }
    std::stable_sort(loops.begin(), loops.end(), [&](const Edge& a, const Edge& b) {
        return enclosed_area(a, *nodes_) > enclosed_area(b, *nodes_);
    });
    for (std::size_t i = 0; i < loops.size(); ++i)
        loops[i].name = i == 0 ? "outline" : fmt::format("outline {}", i + 1);
    return loops;
}

Edge Boundary::named_edge(const std::string& name, const std::vector<std::string>& side_names) const {
    std::unordered_map<std::int32_t, std::int32_t> following;
    std::unordered_set<std::int32_t> ends;
    std::vector<std::int32_t> begins;
    for (const auto& side : *sides_) {
        if (std::find(side_names.begin(), side_names.end(), side.name) == side_names.end()) continue;
        for (std::size_t i = 1; i < side.nodes.size(); ++i) {
            const auto a = side.nodes[i - 1], b = side.nodes[i];
            if (next(a) != b)
                throw std::invalid_argument(
                    fmt::format("edge '{}' lies between two blocks at {}; name sides of the "
                                "boundary only",
                                name, at(a)));
            following.emplace(a, b);
            begins.push_back(a);
            ends.insert(b);
        }
    }
    const auto open =
        std::find_if(begins.begin(), begins.end(), [&](auto node) { return !ends.contains(node); });
    Edge edge{name, {}, open == begins.end()};
    auto node = edge.closed ? begins.front() : *open;
    edge.nodes.push_back(node);
    for (auto step = following.find(node); step != following.end(); step = following.find(node)) {
        node = step->second;
        following.erase(step);
        if (!edge.closed || node != edge.nodes.front()) edge.nodes.push_back(node);
    }
    if (!following.empty())
        throw std::invalid_argument(fmt::format(
            "the sides named '{}' do not connect at {}; give the parts different names", name, at(node)));
    return edge;
}

}  // namespace percuss
