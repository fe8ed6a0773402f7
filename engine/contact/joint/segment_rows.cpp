#include "contact/joint/segment_rows.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "contact/tolerances.hpp"

namespace percuss {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
/// Sides face each other when their outward normals are more than 120 degrees apart.
constexpr double facing = -0.5;
/// Overlaps whose gap is wider than this part of the fine side belong to other places of the outline.
constexpr double widest_gap = 0.5;

using Point = std::array<double, 2>;

Point at_start(const StepMotion& motion, std::int32_t node) {
    const Node& n = motion.nodes[node];
    return {n.x[0] - motion.dt * n.v[0], n.x[1] - motion.dt * n.v[1]};
}

}  // namespace

SegmentRows::SegmentRows(NearSearch fine, NearSearch coarse, bool axisymmetric)
    : fine_(std::move(fine)), coarse_(std::move(coarse)), axisymmetric_(axisymmetric) {
    beside_fine_ = sides_beside(fine_.master());
    beside_coarse_ = sides_beside(coarse_.master());
    ends_.resize(fine_.master().sides.size());
    for (std::size_t n = 0; n < beside_fine_.size(); ++n) {
        const auto [before, after] = beside_fine_[n];
        if (before >= 0) ends_[static_cast<std::size_t>(before)][1] = static_cast<std::int32_t>(n);
        if (after >= 0) ends_[static_cast<std::size_t>(after)][0] = static_cast<std::int32_t>(n);
    }
    const std::size_t nodes = fine_.master().nodes.size(), others = coarse_.master().nodes.size();
    visited_.assign(fine_.master().sides.size(), 0);
    visits_.reserve(visited_.size());
    place_.assign(nodes, -1);
    weighted_.reserve(nodes);
    parts_.reserve(6 * nodes + 4 * others);
    near_.assign(nodes, 0);
    allow_overlap();
}

void SegmentRows::allow_overlap() {
    const bool any = fine_.any_overlap() || coarse_.any_overlap();
    allowance_.assign(fine_.master().nodes.size(), any ? OverlapAllowance::as_found() : OverlapAllowance{});
}

RowBuilder::Size SegmentRows::size() const {
    const std::size_t nodes = fine_.master().nodes.size(), others = coarse_.master().nodes.size();
    return {2 * (nodes + others), 2 * nodes + others, 9 * nodes + 7 * others};
}

void SegmentRows::advance(const MotionBounds& moved) {
    fine_.advance(moved.relative, fine_.of_master() ? moved.slave : moved.master);
    coarse_.advance(moved.relative, coarse_.of_master() ? moved.slave : moved.master);
}

double SegmentRows::deepest() const { return std::max(fine_.deepest(), coarse_.deepest()); }

void SegmentRows::restart(const std::vector<std::int32_t>& active) {
    fine_.restart(active);
    coarse_.restart(active);
    std::fill(near_.begin(), near_.end(), char{0});
    allow_overlap();
    for (const std::int32_t owner : active) {
        const std::int32_t node = owner - fine_.first_owner();
        if (node >= 0 && static_cast<std::size_t>(node) < near_.size())
            near_[static_cast<std::size_t>(node)] = 1;
    }
}

void SegmentRows::find(const StepMotion& motion, ContactRows& rows) {
    fine_.find(motion, rows);
    coarse_.find(motion, rows);
    gather(motion);
    for (const Weighted& row : weighted_) emit(motion, row, rows);
    for (std::size_t n = 0; n < near_.size(); ++n) {
        // A node out of reach has nothing left to be allowed.
        if (place_[n] < 0) near_[n] = 0, allowance_[n].end();
    }
    for (const Weighted& row : weighted_) place_[static_cast<std::size_t>(row.node)] = -1;
}

/// Where sides overlap, an end of one faces the other: the nodes that are awake lead to all places of
/// contact.
void SegmentRows::gather(const StepMotion& motion) {
    weighted_.clear();
    parts_.clear();
    for (const std::int32_t node : fine_.awake()) {
        const std::int32_t facing_side = fine_.closest(node);
        if (facing_side < 0) continue;
        for (const std::int32_t side : beside_fine_[static_cast<std::size_t>(node)])
            if (side >= 0) gather_side(motion, side, facing_side);
    }
    for (const std::int32_t node : coarse_.awake()) {
        const std::int32_t side = coarse_.closest(node);
        const auto [before, after] = beside_coarse_[static_cast<std::size_t>(node)];
        if (side >= 0) gather_side(motion, side, after >= 0 ? after : before);
    }
    for (const std::int32_t side : visits_) visited_[static_cast<std::size_t>(side)] = 0;
    visits_.clear();
}

/// All overlaps of a fine side with coarse ones, from one of them on along the coarse surface both ways.
void SegmentRows::gather_side(const StepMotion& motion, std::int32_t fine, std::int32_t start) {
    char& visited = visited_[static_cast<std::size_t>(fine)];
    if (visited || start < 0) return;
    const std::vector<Side>& sides = coarse_.master().sides;
    const bool first = gather_overlap(motion, fine, start);
    bool any = first;
    for (const bool forward : {true, false}) {
        int misses = first ? 1 : 0;  // past the closest side, its neighbour may be the one
        for (std::int32_t at = start;;) {
            const Side& side = sides[static_cast<std::size_t>(at)];
            at = forward ? side.next : side.previous;
            if (at < 0 || at == start) break;
            if (gather_overlap(motion, fine, at))
                any = true;
            else if (++misses > 1)
                break;
        }
    }
    if (!any) return;
    visited = 1;
    visits_.push_back(fine);
}

bool SegmentRows::gather_overlap(const StepMotion& motion, std::int32_t fine, std::int32_t coarse) {
    const Side &s = fine_.master().sides[static_cast<std::size_t>(fine)],
               &c = coarse_.master().sides[static_cast<std::size_t>(coarse)];
    const Point a = at_start(motion, s.i), b = at_start(motion, s.j), i = at_start(motion, c.i),
                j = at_start(motion, c.j);
    const double sx = b[0] - a[0], sy = b[1] - a[1], tx = j[0] - i[0], ty = j[1] - i[1];
    const double square = sx * sx + sy * sy, coarse_square = tx * tx + ty * ty;
    const double along = sx * tx + sy * ty, lengths = std::sqrt(square * coarse_square);
    if (!(along < facing * lengths)) return false;
    // The coarse chain, projected along the fine side's normal, parts the fine side without gaps.
    const double from = std::max(0.0, ((j[0] - a[0]) * sx + (j[1] - a[1]) * sy) / square),
                 to = std::min(1.0, ((i[0] - a[0]) * sx + (i[1] - a[1]) * sy) / square);
    if (!(to > from)) return false;

    const double length = std::sqrt(square), coarse_length = lengths / length;
    const double nx = ty / coarse_length, ny = -tx / coarse_length;
    constexpr double gauss = 0.57735026918962576;
    const double middle = 0.5 * (from + to), half = 0.5 * (to - from);
    double weight[2] = {0, 0}, mean_gap[2] = {0, 0}, on_fine[2][2] = {}, on_coarse[2][2] = {};
    for (const double place : {-gauss, gauss}) {
        const double xi = middle + half * place;
        const double x = a[0] + xi * sx, y = a[1] + xi * sy;
        const double gap = (x - i[0]) * nx + (y - i[1]) * ny;
        if (gap > widest_gap * length + 2 * motion.range ||
            -gap > depth_limit * std::min(length, coarse_length))
            return false;
        const double foot = std::clamp(((x - i[0]) * tx + (y - i[1]) * ty) / coarse_square, 0.0, 1.0);
        const double w = half * length * (axisymmetric_ ? x : 1);
        const double shape[2] = {1 - xi, xi}, coarse_shape[2] = {1 - foot, foot};
        for (std::size_t k = 0; k < 2; ++k) {
            const double wk = w * shape[k];
            weight[k] += wk;
            mean_gap[k] += wk * gap;
            for (std::size_t l = 0; l < 2; ++l) {
                on_fine[k][l] += wk * shape[l];
                on_coarse[k][l] += wk * coarse_shape[l];
            }
        }
    }
    const auto& ends = ends_[static_cast<std::size_t>(fine)];
    for (std::size_t k = 0; k < 2; ++k) {
        Weighted& row = row_of(ends[k]);
        row.weight += weight[k];
        row.gap += mean_gap[k];
        add(row, s.i, true, on_fine[k][0] * nx, on_fine[k][0] * ny);
        add(row, s.j, true, on_fine[k][1] * nx, on_fine[k][1] * ny);
        add(row, c.i, false, -on_coarse[k][0] * nx, -on_coarse[k][0] * ny);
        add(row, c.j, false, -on_coarse[k][1] * nx, -on_coarse[k][1] * ny);
    }
    return true;
}

SegmentRows::Weighted& SegmentRows::row_of(std::int32_t fine_node) {
    std::int32_t& place = place_[static_cast<std::size_t>(fine_node)];
    if (place < 0) {
        place = static_cast<std::int32_t>(weighted_.size());
        weighted_.push_back({fine_node, 0, 0, -1});
    }
    return weighted_[static_cast<std::size_t>(place)];
}

void SegmentRows::add(Weighted& row, std::int32_t node, bool fine, double gx, double gy) {
    // A row of many coarse sides meets a node of them in two that follow each other only.
    int looked = 0;
    for (std::int32_t p = row.first; p >= 0 && looked < 8;
         p = parts_[static_cast<std::size_t>(p)].next, ++looked) {
        RowTerm& term = parts_[static_cast<std::size_t>(p)].term;
        if (term.node != node) continue;
        term.g[0] += gx;
        term.g[1] += gy;
        return;
    }
    parts_.push_back({{node, {gx, gy}}, fine, row.first});  // newest first
    row.first = static_cast<std::int32_t>(parts_.size()) - 1;
}

void SegmentRows::emit(const StepMotion& motion, const Weighted& row, ContactRows& rows) {
    const auto n = static_cast<std::size_t>(row.node);
    const double raw = row.gap / row.weight;
    allowance_[n].see(raw, 2 * motion.range);
    const bool was_near = near_[n] || allowance_[n].any();
    const double gap = allowance_[n].counted(raw);
    near_[n] = 0;
    if (gap > 2 * motion.range) return;
    // As for nodes: what appears inside, and did not come in within a step, slid under an open end.
    const auto [before, after] = beside_fine_[n];
    const Side& side = fine_.master().sides[static_cast<std::size_t>(after >= 0 ? after : before)];
    const Point i = at_start(motion, side.i), j = at_start(motion, side.j);
    const double length = std::hypot(j[0] - i[0], j[1] - i[1]);
    if (-gap > std::max((was_near ? depth_limit : 2 * guard_slack) * length, motion.range)) return;
    near_[n] = 1;

    ContactRow& made = rows.add_row();
    const double inverse = 1 / row.weight;
    double rate = 0;
    for (const bool fine : {fine_.of_master(), !fine_.of_master()}) {
        for (std::int32_t p = row.first; p >= 0; p = parts_[static_cast<std::size_t>(p)].next) {
            const Part& part = parts_[static_cast<std::size_t>(p)];
            if (part.fine != fine) continue;
            const double gx = inverse * part.term.g[0], gy = inverse * part.term.g[1];
            const double* v = motion.nodes[part.term.node].v;
            rows.add_term(made, part.term.node, gx, gy);
            rate += gx * v[0] + gy * v[1];
        }
        if (fine == fine_.of_master()) made.master_terms = made.terms;
    }
    made.owner = fine_.first_owner() + row.node;
    made.key = made.owner;
    made.side = -1;
    motion.set_condition(made, gap, rate);
}

}  // namespace percuss
