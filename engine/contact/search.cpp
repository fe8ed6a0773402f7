#include "contact/search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "contact/node_to_side.hpp"
#include "contact/tolerances.hpp"
#include "dynamics/double2.hpp"

namespace percuss {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

struct Range {
    Double2 lowest{infinity, infinity}, highest{-infinity, -infinity};
};

/// Displacements of some nodes since they were at `last`, which moves along.
Range displacements(const Node* nodes, const std::vector<std::int32_t>& of,
                    std::vector<std::array<double, 2>>& last) {
    Range range;
    for (std::size_t k = 0; k < of.size(); ++k) {
        const Double2 x = load_pair(nodes[of[k]].x), u = x - load_pair(last[k].data());
        range.lowest = smaller(range.lowest, u);
        range.highest = larger(range.highest, u);
        store_pair(last[k].data(), x);
    }
    return range;
}

double length(const Double2& v) { return std::sqrt(v[0] * v[0] + v[1] * v[1]); }

void positions_before(const Node* nodes, double dt, const std::vector<std::int32_t>& of,
                      std::vector<std::array<double, 2>>& positions) {
    positions.clear();
    for (const std::int32_t node : of) {
        const Node& n = nodes[node];
        positions.push_back({n.x[0] - dt * n.v[0], n.x[1] - dt * n.v[1]});
    }
}

}  // namespace

PenetrationSearch::PenetrationSearch(Surface master, Surface slave)
    : master_(std::move(master)),
      slave_(std::move(slave)),
      tree_(slave_.sides.size()),
      memory_(master_.nodes.size()) {
    master_at_.reserve(master_.nodes.size());
    slave_at_.reserve(slave_.nodes.size());
}

void PenetrationSearch::forget() {
    std::fill(memory_.begin(), memory_.end(), Memory{});
    master_at_.clear();
    slave_at_.clear();
    travelled_ = 0;
}

void PenetrationSearch::measure_lengths(const Node* nodes) {
    double sum = 0;
    for (const Side& side : slave_.sides) sum += view_from_side(nodes, side, 0, 0).length;
    refit_after_ = sum / static_cast<double>(slave_.sides.size());
    end_reach_ = end_tolerance * refit_after_;
    slave_travelled_ = infinity;
}

void PenetrationSearch::measure_motion(const Node* nodes, double dt) {
    if (master_at_.empty()) {
        measure_lengths(nodes);
        positions_before(nodes, dt, master_.nodes, master_at_);
        positions_before(nodes, dt, slave_.nodes, slave_at_);
    }
    const Range m = displacements(nodes, master_.nodes, master_at_),
                s = displacements(nodes, slave_.nodes, slave_at_);
    step_motion_ = length(larger(m.highest - s.lowest, s.highest - m.lowest));
    travelled_ += step_motion_;
    slave_travelled_ += length(larger(s.highest, -s.lowest));
}

void PenetrationSearch::find(const Node* nodes, double dt, ContactRows& rows) {
    rows.clear();
    measure_motion(nodes, dt);
    for (std::size_t m = 0; m < memory_.size(); ++m) {
        Memory& memory = memory_[m];
        if (memory.free_until > travelled_) continue;
        const Closest closest = closest_side(nodes, nodes[master_.nodes[m]].x, memory);
        if (!std::isfinite(closest.distance)) continue;  // a diverged state has no closest side
        if (const auto entered = enter(nodes, dt, static_cast<std::int32_t>(m), closest, memory.held)) {
            const SideView& view = entered->view;
            ContactRow& row = add_node_to_side(rows, master_.nodes[m],
                                               slave_.sides[static_cast<std::size_t>(entered->side)],
                                               std::clamp(view.a, 0.0, 1.0), view.nx, view.ny);
            row.penetration = -view.gap;
            row.side = entered->side;
            row.owner = static_cast<std::int32_t>(m);
            memory.held = entered->side;
            memory.free_until = travelled_;  // looked at in every step
        } else {
            memory.held = -1;
            memory.free_until = travelled_ + free_distance(nodes, nodes[master_.nodes[m]].x, closest, memory);
        }
    }
}

PenetrationSearch::Closest PenetrationSearch::closest_of_neighbours(const Node* nodes, const double* x,
                                                                    std::int32_t side) const {
    const Side& middle = slave_.sides[static_cast<std::size_t>(side)];
    Closest best{side, squared_distance(nodes, middle, x[0], x[1])};
    for (const std::int32_t neighbour : {middle.previous, middle.next}) {
        if (neighbour < 0) continue;
        const double square =
            squared_distance(nodes, slave_.sides[static_cast<std::size_t>(neighbour)], x[0], x[1]);
        // Two sides are equally near at their common vertex: what is taken must not depend on the past.
        if (square < best.distance || (square == best.distance && neighbour < best.side))
            best = {neighbour, square};
    }
    best.distance = std::sqrt(best.distance);
    return best;
}

PenetrationSearch::Closest PenetrationSearch::closest_side(const Node* nodes, const double* x,
                                                           Memory& memory) {
    if (memory.side >= 0) {
        const Closest local = closest_of_neighbours(nodes, x, memory.side);
        if (local.distance <= memory.others_from - travelled_) return local;
    }
    if (slave_travelled_ > refit_after_) {
        tree_.fit(nodes, slave_.sides);
        slave_travelled_ = 0;
    }
    memory.side = tree_.nearest(nodes, slave_.sides, x[0], x[1], slave_travelled_).side;
    if (memory.side < 0) return {-1, infinity};
    const Side& middle = slave_.sides[static_cast<std::size_t>(memory.side)];
    const auto other = tree_.nearest(nodes, slave_.sides, x[0], x[1], slave_travelled_,
                                     SidesOtherThan{{middle.previous, memory.side, middle.next}});
    memory.others_from = travelled_ + other.distance;
    return closest_of_neighbours(nodes, x, memory.side);
}

/// How far the surfaces may move before the node can touch: up to the closest side, or up to where a face
/// reaches past its end (an open one or a sharp corner).
double PenetrationSearch::free_distance(const Node* nodes, const double* x, const Closest& closest,
                                        const Memory& memory) const {
    const auto distance = [&](std::int32_t node) {
        return std::hypot(nodes[node].x[0] - x[0], nodes[node].x[1] - x[1]);
    };
    const auto is_end = [&](std::int32_t first, std::int32_t second) {
        return first < 0 || second < 0 || sharp_corner(nodes, first, second);
    };
    double nearest_end = memory.others_from - travelled_;
    const Side& middle = slave_.sides[static_cast<std::size_t>(memory.side)];
    for (const std::int32_t index : {middle.previous, memory.side, middle.next}) {
        if (index < 0) continue;
        const Side& side = slave_.sides[static_cast<std::size_t>(index)];
        if (is_end(side.previous, index)) nearest_end = std::min(nearest_end, distance(side.i));
        if (is_end(index, side.next)) nearest_end = std::min(nearest_end, distance(side.j));
    }
    return std::max(0.0, std::min(closest.distance, nearest_end - end_reach_));
}

double PenetrationSearch::gap_before(const Node* nodes, double dt, std::int32_t node,
                                     const Side& side) const {
    Node pair[2];
    const std::int32_t ends[2] = {side.i, side.j};
    for (int k = 0; k < 2; ++k)
        for (int d = 0; d < 2; ++d) pair[k].x[d] = nodes[ends[k]].x[d] - dt * nodes[ends[k]].v[d];
    const Node& n = nodes[node];
    return view_from_side(pair, Side{0, 1, -1, -1}, n.x[0] - dt * n.v[0], n.x[1] - dt * n.v[1]).gap;
}

/// Whether the body's outline turns by more than 45 degrees, outwards, from one side to the next; flatter
/// corners approximate a curve.
bool PenetrationSearch::sharp_corner(const Node* nodes, std::int32_t first, std::int32_t second) const {
    const Side &from = slave_.sides[static_cast<std::size_t>(first)],
               &to = slave_.sides[static_cast<std::size_t>(second)];
    const double *a = nodes[from.i].x, *b = nodes[from.j].x, *c = nodes[to.j].x;
    const double sx = b[0] - a[0], sy = b[1] - a[1], tx = c[0] - b[0], ty = c[1] - b[1];
    const double turn = sx * ty - sy * tx, along = sx * tx + sy * ty;
    return turn > 0 && turn > along;
}

/// Of two faces of a sharp corner, both reached by the node, whether it came through the neighbour of the
/// closer one.
bool PenetrationSearch::entered_neighbour(const Node* nodes, double dt, std::int32_t node, std::int32_t side,
                                          const SideView& view, std::int32_t held,
                                          const SideView& neighbour) const {
    const std::int32_t around = view.a < 0.5 ? slave_.sides[static_cast<std::size_t>(side)].previous
                                             : slave_.sides[static_cast<std::size_t>(side)].next;
    if (held == around) return true;
    const double before_neighbour =
        gap_before(nodes, dt, node, slave_.sides[static_cast<std::size_t>(around)]);
    const bool through_neighbour = before_neighbour >= -entry_tolerance * neighbour.length;
    if (held == side) return false;
    const double before = gap_before(nodes, dt, node, slave_.sides[static_cast<std::size_t>(side)]);
    const bool through = before >= -entry_tolerance * view.length;
    if (through != through_neighbour) return through_neighbour;
    // Past the end of one face or both at once: the face that it moves into faster.
    return before_neighbour - neighbour.gap > before - view.gap;
}

/// Whether a node, (dx, dy) away from a vertex, is behind the average of the normals of the two sides there.
bool PenetrationSearch::behind_vertex(const Node* nodes, const Side& around, const SideView& view, double dx,
                                      double dy) {
    const double tx = nodes[around.j].x[0] - nodes[around.i].x[0],
                 ty = nodes[around.j].x[1] - nodes[around.i].x[1];
    const double own = view.nx * dx + view.ny * dy, other = ty * dx - tx * dy;
    if ((own > 0) == (other > 0)) return own > 0;  // no root needed: behind both, or before both
    return own + other / std::sqrt(tx * tx + ty * ty) > 0;
}

std::optional<PenetrationSearch::Entered> PenetrationSearch::enter(const Node* nodes, double dt,
                                                                   std::int32_t master,
                                                                   const Closest& closest,
                                                                   std::int32_t held) const {
    const std::int32_t node = master_.nodes[static_cast<std::size_t>(master)];
    const double* x = nodes[node].x;
    std::int32_t index = closest.side;
    const Side* side = &slave_.sides[static_cast<std::size_t>(index)];
    SideView view = view_from_side(nodes, *side, x[0], x[1]);
    const auto past_end = [](const SideView& v) { return std::max(-v.a, v.a - 1) * v.length; };
    const bool first_half = view.a < 0.5;
    const std::int32_t around = first_half ? side->previous : side->next;

    if (around < 0) {
        if (past_end(view) > end_reach_) return std::nullopt;
    } else if (past_end(view) > 0) {
        // The nearest point is a vertex. Outside a convex one there is no contact; inside a concave one the
        // node is pushed along the line to the vertex. The averaged normal tells the two apart.
        const double* vertex = nodes[first_half ? side->i : side->j].x;
        const double dx = vertex[0] - x[0], dy = vertex[1] - x[1];
        if (!behind_vertex(nodes, slave_.sides[static_cast<std::size_t>(around)], view, dx, dy))
            return std::nullopt;
        view.nx = dx / closest.distance;
        view.ny = dy / closest.distance;
        view.gap = -closest.distance;
    } else if (view.gap <= end_reach_ &&
               sharp_corner(nodes, first_half ? around : index, first_half ? index : around)) {
        const SideView other =
            view_from_side(nodes, slave_.sides[static_cast<std::size_t>(around)], x[0], x[1]);
        if (other.gap < 0 && past_end(other) <= end_reach_ &&
            entered_neighbour(nodes, dt, node, index, view, held, other)) {
            index = around;
            side = &slave_.sides[static_cast<std::size_t>(index)];
            view = other;
        }
    }
    if (view.gap >= 0) return std::nullopt;
    if (-view.gap > std::max((held >= 0 ? depth_limit : entry_tolerance) * view.length, step_motion_))
        return std::nullopt;
    return Entered{index, view};
}

double PenetrationSearch::penetration(const Node* nodes, const ContactRow& row) const {
    const double* x = nodes[master_.nodes[static_cast<std::size_t>(row.owner)]].x;
    return -view_from_side(nodes, slave_.sides[static_cast<std::size_t>(row.side)], x[0], x[1]).gap;
}

}  // namespace percuss
