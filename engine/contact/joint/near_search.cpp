#include "contact/joint/near_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "contact/node_to_side.hpp"
#include "contact/tolerances.hpp"

namespace percuss {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Sides that turn by less than this are one straight line: with rounding, it would be a valley here and
/// there.
constexpr double straight = 1e-9;

/// A side faces a node of its own surface when their normals are further apart than a right angle by this
/// (its sine).
constexpr double faces_by = 0.1;

/// Which sides of its own surface a node faces can change once it has moved by this part of a mean side.
constexpr double faces_anew_after = 0.1;

/// Nodes nearer than this part of a mean side stay awake.
constexpr double awake_within = 0.02;

std::array<double, 2> at_start(const Node* nodes, std::int32_t node, double dt) {
    const Node& n = nodes[node];
    return {n.x[0] - dt * n.v[0], n.x[1] - dt * n.v[1]};
}

double distance_of(const SideView& v) {
    const double past = std::max({-v.a, v.a - 1, 0.0}) * v.length;
    return past > 0 ? std::sqrt(past * past + v.gap * v.gap) : std::abs(v.gap);
}

double past_end(const SideView& v) { return std::max(-v.a, v.a - 1) * v.length; }

double mean_length(const Node* nodes, const std::vector<Side>& sides) {
    double sum = 0;
    for (const Side& side : sides) sum += view_from_side(nodes, side, 0, 0).length;
    return sides.empty() ? infinity : sum / static_cast<double>(sides.size());
}

}  // namespace

NearSearch::NearSearch(Surface master, Surface slave, NearRole role)
    : master_(std::move(master)),
      slave_(std::move(slave)),
      role_(std::move(role)),
      tree_(slave_.sides.size()),
      memory_(master_.nodes.size()) {
    awake_.reserve(memory_.size());
    allow_overlap();
    if (role_.by_facing || role_.self) own_sides_ = sides_beside(master_);
}

void NearSearch::allow_overlap() {
    for (const std::int32_t master : role_.overlapping)
        memory_[static_cast<std::size_t>(master)].allowance = OverlapAllowance::as_found();
}

void NearSearch::restart(const std::vector<std::int32_t>& active) {
    std::fill(memory_.begin(), memory_.end(), Memory{});
    allow_overlap();
    for (const std::int32_t owner : active) {
        const std::int32_t master = owner - role_.first_owner;
        if (master >= 0 && static_cast<std::size_t>(master) < memory_.size())
            memory_[static_cast<std::size_t>(master)].near = true;
    }
    awake_.clear();
    mean_side_ = travelled_ = wake_at_ = 0;
}

void NearSearch::measure(const Node* nodes) {
    // A wall's one side is endless: then the master's sides are the measure.
    mean_side_ = std::min(mean_length(nodes, slave_.sides), mean_length(nodes, master_.sides));
    slave_travelled_ = infinity;
}

void NearSearch::advance(double relative, double slave) {
    travelled_ += relative;
    slave_travelled_ += slave;
}

inline SideView NearSearch::view(const StepMotion& motion, std::int32_t side, const Point& x) const {
    const Side& s = slave_.sides[static_cast<std::size_t>(side)];
    const Point i = at_start(motion.nodes, s.i, motion.dt), j = at_start(motion.nodes, s.j, motion.dt);
    return view_of_segment(i.data(), j.data(), x[0], x[1]);
}

/// Whether a node over a facet, well away from the facet's ends, has no other side nearer.
inline bool NearSearch::alone_on(const SideView& v, const Memory& memory) const {
    const double distance = std::abs(v.gap);
    return distance <= 0.1 * std::min(v.a, 1 - v.a) * v.length && distance <= memory.others_from - travelled_;
}

inline bool NearSearch::add_row(const StepMotion& motion, std::int32_t master, const Face& face,
                                const Memory& memory, ContactRows& rows) {
    const SideView& v = face.view;
    if (face.side < 0) return false;
    const double gap = memory.allowance.counted(v.gap);
    if (-gap > std::max((memory.near ? depth_limit : entry_tolerance) * v.length, motion.range)) return false;
    deepest_ = std::max(deepest_, -gap);
    const bool near = gap <= 2 * motion.range;
    const double counted = gap + role_.slack * mean_side_;
    if (counted > 2 * motion.range) return near;
    const Side& side = slave_.sides[static_cast<std::size_t>(face.side)];
    const double a = std::clamp(v.a, 0.0, 1.0);
    const std::int32_t node = master_.nodes[static_cast<std::size_t>(master)];
    ContactRow& row = add_node_to_side(rows, node, side, a, v.nx, v.ny, role_.of_master);
    row.side = face.side;
    row.owner = role_.first_owner + master;
    row.key = role_.first_key + master;
    const double *n = motion.nodes[node].v, *i = motion.nodes[side.i].v, *j = motion.nodes[side.j].v;
    const double rate =
        v.nx * (n[0] + (a - 1) * i[0] + -a * j[0]) + v.ny * (n[1] + (a - 1) * i[1] + -a * j[1]);
    motion.set_condition(row, counted, rate);
    return near;
}

void NearSearch::find(const StepMotion& motion, ContactRows& rows) {
    deepest_ = 0;
    if (mean_side_ == 0) measure(motion.nodes);
    if (travelled_ + 2 * motion.range >= wake_at_) wake(motion);
    for (const std::int32_t m : awake_) {
        Memory& memory = memory_[static_cast<std::size_t>(m)];
        const std::int32_t node = master_.nodes[static_cast<std::size_t>(m)];
        const Point x = at_start(motion.nodes, node, motion.dt);
        if (memory.closest >= 0 && (memory.face < 0 || memory.face == memory.closest)) {
            const SideView v = view(motion, memory.closest, x);
            const double clear =
                role_.by_facing ? std::max(2 * motion.range, end_tolerance * mean_side_) : 2 * motion.range;
            if (alone_on(v, memory) && std::min(v.a, 1 - v.a) * v.length > clear) {
                memory.allowance.see(v.gap, 2 * motion.range);
                memory.near = add_row(motion, m, {v, memory.closest}, memory, rows);
                memory.face = memory.near ? memory.closest : -1;
                continue;
            }
        }
        const Closest closest = look(motion, m, x);
        if (!(closest.distance < infinity)) {  // faces nothing of its own surface, or the state diverged
            memory.near = false;
            memory.face = -1;
            continue;
        }
        const Face face = face_of(motion, m, x, closest);
        const Face across = across_valley(motion, m, x, face);
        memory.allowance.see(std::min(face.gap(), across.gap()), 2 * motion.range);
        const bool one = add_row(motion, m, face, memory, rows);
        const bool other = add_row(motion, m, across, memory, rows);
        memory.near = one || other;
        memory.face = memory.near ? face.side : -1;
    }
}

/// Chooses the nodes to look at from now on.
void NearSearch::wake(const StepMotion& motion) {
    const double within = std::max(awake_within * mean_side_, 8 * motion.range);
    wake_at_ = travelled_ + 4 * within;
    awake_.clear();
    for (std::size_t m = 0; m < memory_.size(); ++m) {
        Memory& memory = memory_[m];
        if (memory.free_until <= travelled_ + within) {
            const Point x = at_start(motion.nodes, master_.nodes[m], motion.dt);
            double distance = look(motion, static_cast<std::int32_t>(m), x).distance;
            if (role_.self) distance = std::min(distance, sight(motion));
            memory.free_until = travelled_ + distance - end_tolerance * mean_side_;
            // Touches, though it is inside.
            if (memory.allowance.any() || memory.near) memory.free_until = travelled_;
        }
        if (memory.free_until <= travelled_ + within) {
            awake_.push_back(static_cast<std::int32_t>(m));
            memory.free_until = travelled_;
        } else {
            memory.near = false;
            memory.face = -1;
            wake_at_ = std::min(wake_at_, memory.free_until);
        }
    }
}

bool NearSearch::is_own(std::int32_t master, std::int32_t side) const {
    const auto [before, behind] = own_sides_[static_cast<std::size_t>(master)];
    return side == before || side == behind;
}

std::int32_t NearSearch::beside(std::int32_t side, bool before, std::int32_t master) const {
    const Side& s = slave_.sides[static_cast<std::size_t>(side)];
    const std::int32_t around = before ? s.previous : s.next;
    return role_.self && is_own(master, around) ? -1 : around;
}

bool NearSearch::counts(const StepMotion& motion, std::int32_t master, const Point& x,
                        std::int32_t side) const {
    if (!role_.self) return true;
    if (is_own(master, side)) return false;
    const SideView v = view(motion, side, x);
    const Memory& memory = memory_[static_cast<std::size_t>(master)];
    // One in touch may be deeper in, and slide on to the next side.
    const auto touches = [&] {
        if (!memory.near || memory.closest < 0) return false;
        const Side& closest = slave_.sides[static_cast<std::size_t>(memory.closest)];
        return side == memory.closest || side == closest.previous || side == closest.next;
    };
    if (-v.gap > std::max((touches() ? depth_limit : entry_tolerance) * v.length, motion.range)) return false;
    // The middle of its two sides too: the tip of a wedge meets a face head-on.
    const auto [before, behind] = own_normals(motion, master);
    const auto turned = [&](double nx, double ny) {
        return v.nx * nx + v.ny * ny < -faces_by * std::hypot(nx, ny);
    };
    return turned(before[0], before[1]) || turned(behind[0], behind[1]) ||
           turned(before[0] + behind[0], before[1] + behind[1]);
}

/// How far a node looks for sides of its own surface: further, it looks again before it gets there.
double NearSearch::sight(const StepMotion& motion) const {
    return std::max(awake_within * mean_side_, 8 * motion.range) + faces_anew_after * mean_side_;
}

NearSearch::Closest NearSearch::look(const StepMotion& motion, std::int32_t master, const Point& x) {
    Memory& memory = memory_[static_cast<std::size_t>(master)];
    if (memory.closest >= 0) {
        const SideView v = view(motion, memory.closest, x);
        if (alone_on(v, memory)) return {v, std::abs(v.gap), memory.closest};
    }
    const auto best_of_three = [&](std::int32_t middle) {
        const SideView v = view(motion, middle, x);
        Closest best{v, counts(motion, master, x, middle) ? distance_of(v) : infinity, middle};
        const Side& side = slave_.sides[static_cast<std::size_t>(middle)];
        for (const std::int32_t neighbour : {side.previous, side.next}) {
            if (neighbour < 0 || !counts(motion, master, x, neighbour)) continue;
            const SideView other = view(motion, neighbour, x);
            const double distance = distance_of(other);
            // At a common end both are as far: the side that the node is more outside of.
            const double tie = 1e-12 * best.view.length;
            if (distance < best.distance - tie ||
                (distance < best.distance + tie && other.gap > best.view.gap))
                best = {other, distance, neighbour};
        }
        return best;
    };
    if (memory.middle >= 0) {
        const Closest local = best_of_three(memory.middle);
        if (local.distance <= memory.others_from - travelled_) {
            memory.closest = local.side;
            return local;
        }
    }
    if (slave_travelled_ > mean_side_) {
        tree_.fit(motion.nodes, slave_.sides);
        slave_travelled_ = 0;
    }
    // The tree knows the predicted positions, which are off by no more than the step's motion.
    const auto nearest = [&](const auto& counted) {
        return tree_.nearest(
            motion.nodes, slave_.sides, x[0], x[1], slave_travelled_,
            [&](std::int32_t side) { return counted(side) && counts(motion, master, x, side); },
            role_.self ? sight(motion) : infinity);
    };
    memory.middle = nearest(AllSides{}).side;
    memory.closest = memory.middle;
    if (memory.middle < 0) return {{}, infinity, -1};
    const Side& middle = slave_.sides[static_cast<std::size_t>(memory.middle)];
    double others = nearest(SidesOtherThan{{middle.previous, memory.middle, middle.next}}).distance;
    if (role_.self) others = std::min(others, faces_anew_after * mean_side_);
    memory.others_from = travelled_ + others - motion.range;
    const Closest best = best_of_three(memory.middle);
    memory.closest = best.side;
    return best;
}

/// Which way the body's outline turns from one side to the next. Flat convex corners approximate a curve.
NearSearch::Corner NearSearch::corner(const StepMotion& motion, std::int32_t first,
                                      std::int32_t second) const {
    const Side &from = slave_.sides[static_cast<std::size_t>(first)],
               &to = slave_.sides[static_cast<std::size_t>(second)];
    const Point a = at_start(motion.nodes, from.i, motion.dt), b = at_start(motion.nodes, from.j, motion.dt),
                c = at_start(motion.nodes, to.j, motion.dt);
    const double sx = b[0] - a[0], sy = b[1] - a[1], tx = c[0] - b[0], ty = c[1] - b[1];
    const double turn = sx * ty - sy * tx, along = sx * tx + sy * ty;
    if (turn < -straight * along) return along < 0 || turn < -along ? Corner::steep_valley : Corner::valley;
    return turn > along ? Corner::sharp : Corner::flat;
}

/// The face that keeps the node out, if it is in reach of one.
NearSearch::Face NearSearch::face_of(const StepMotion& motion, std::int32_t master, const Point& x,
                                     const Closest& closest) const {
    if (const auto face = kept_face(motion, x, closest, memory_[static_cast<std::size_t>(master)]))
        return *face;
    if (role_.by_facing)
        if (const auto face = opposed_face(motion, master, x, closest)) return *face;
    const double past = past_end(closest.view);
    if (past <= 0) return {closest.view, closest.side};
    const bool before = closest.view.a < 0;
    const std::int32_t around = beside(closest.side, before, master);
    const double reach = end_tolerance * mean_side_;
    if (around < 0) return {closest.view, past > reach ? -1 : closest.side};
    if (corner(motion, before ? around : closest.side, before ? closest.side : around) != Corner::sharp)
        return {closest.view, closest.side};
    // In front of a sharp corner: the face that the node is more outside of, if it is within its reach.
    const SideView other = view(motion, around, x);
    const Face face = other.gap > closest.view.gap ? Face{other, around} : Face{closest.view, closest.side};
    return {face.view, past_end(face.view) > reach ? -1 : face.side};
}

/// The face that kept a node out in the last step, where springs have let the node so deep in beside a sharp
/// corner that the side around it is closer now. Were it to change over, what the spring holds would be lost,
/// and found again where the node comes back.
std::optional<NearSearch::Face> NearSearch::kept_face(const StepMotion& motion, const Point& x,
                                                      const Closest& closest, const Memory& memory) const {
    if (memory.face < 0 || closest.side == memory.face) return std::nullopt;
    const Side& side = slave_.sides[static_cast<std::size_t>(closest.side)];
    const bool before = side.previous == memory.face;
    if (!before && side.next != memory.face) return std::nullopt;
    const double reach = end_tolerance * mean_side_;
    const SideView v = view(motion, memory.face, x);
    if (past_end(v) > reach || -v.gap <= std::max(reach, 2 * motion.range)) return std::nullopt;
    const Corner corner_of =
        corner(motion, before ? memory.face : closest.side, before ? closest.side : memory.face);
    if (corner_of != Corner::sharp) return std::nullopt;
    return Face{v, memory.face};
}

/// Unit normals of the node's own two sides; zero where there is none.
std::array<NearSearch::Point, 2> NearSearch::own_normals(const StepMotion& motion,
                                                         std::int32_t master) const {
    std::array<Point, 2> normals{};
    for (const std::size_t k : {std::size_t{0}, std::size_t{1}}) {
        const std::int32_t own = own_sides_[static_cast<std::size_t>(master)][k];
        if (own < 0) continue;
        const Side& side = master_.sides[static_cast<std::size_t>(own)];
        const Point i = at_start(motion.nodes, side.i, motion.dt),
                    j = at_start(motion.nodes, side.j, motion.dt);
        const double tx = j[0] - i[0], ty = j[1] - i[1], length = std::hypot(tx, ty);
        normals[k] = {ty / length, -tx / length};
    }
    return normals;
}

/// Whether a side of the node's own surface faces this way in, within 60 degrees.
bool NearSearch::opposes(const StepMotion& motion, std::int32_t master, const SideView& face) const {
    const auto normals = own_normals(motion, master);
    return std::any_of(normals.begin(), normals.end(),
                       [&](const Point& n) { return face.nx * n[0] + face.ny * n[1] < -0.5; });
}

/// Near a sharp corner of the sides, the one of its two faces that alone opposes the node's surface.
std::optional<NearSearch::Face> NearSearch::opposed_face(const StepMotion& motion, std::int32_t master,
                                                         const Point& x, const Closest& closest) const {
    const SideView& v = closest.view;
    const bool before = v.a < 0.5;
    const double reach = end_tolerance * mean_side_;
    const std::int32_t around = beside(closest.side, before, master);
    if (around < 0 || (before ? v.a : 1 - v.a) * v.length > std::max(reach, 2 * motion.range))
        return std::nullopt;
    if (corner(motion, before ? around : closest.side, before ? closest.side : around) != Corner::sharp)
        return std::nullopt;
    const SideView other = view(motion, around, x);
    const bool own_opposes = opposes(motion, master, v);
    if (own_opposes == opposes(motion, master, other)) return std::nullopt;
    const Face face = own_opposes ? Face{v, closest.side} : Face{other, around};
    return Face{face.view, past_end(face.view) > reach ? -1 : face.side};
}

/// A node at the bottom of a valley between two sides is kept out by both: were it by the closer one only, it
/// would leave each of them in turn through the other. Springs let it: a second one in a shallow valley would
/// come and go with the node inside both sides, and bring energy along.
NearSearch::Face NearSearch::across_valley(const StepMotion& motion, std::int32_t master, const Point& x,
                                           const Face& face) const {
    const SideView& v = face.view;
    const bool before = v.a < 0.5;
    if (face.side < 0 || (before ? v.a : 1 - v.a) * v.length > 2 * motion.range) return {{}, -1};
    const std::int32_t around = beside(face.side, before, master);
    if (around < 0) return {{}, -1};
    const Corner between = corner(motion, before ? around : face.side, before ? face.side : around);
    if (between != Corner::steep_valley && (motion.springs() || between != Corner::valley)) return {{}, -1};
    return {view(motion, around, x), around};
}

}  // namespace percuss
