#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "contact/closest.hpp"
#include "contact/joint/overlap_allowance.hpp"
#include "contact/joint/row_builder.hpp"
#include "contact/row.hpp"
#include "contact/side_tree.hpp"
#include "contact/surface.hpp"
#include "dynamics/node.hpp"

namespace percuss {

/// Which way round a search stands in its pair, and how strict it is.
struct NearRole {
    bool of_master = true;         ///< its nodes, and not its sides, are of the pair's first body
    std::int32_t first_owner = 0;  ///< of its nodes
    std::int32_t first_key = 0;    ///< of its rows
    double slack = 0;              ///< a gap may close to less than zero by this part of a mean side
    /// At a sharp corner of the sides, the face that opposes a side of the node's own surface keeps the node
    /// out: the corners of flush bodies stand on each other, however little one of them hangs over.
    bool by_facing = false;
    /// Nodes, by index, that begin inside.
    std::vector<std::int32_t> overlapping = {};
    /// The two surfaces are one, the whole outline of a body that may fold on itself.
    bool self = false;
};

/// Finds which master nodes of a pair could come to a slave side within the step. Conditions are built at
/// x_n, where the contact forces of the step act: a row's force then does the work that the ledger books, and
/// rows do not depend on how far the prediction went inside. The normal is that of the closest side itself
/// (no average): a node that slides from one facet to the next crosses where both give the same gap.
///
/// Nodes far from the slave surface sleep until the two surfaces can have moved that much.
///
/// Where the surfaces are one, a node looks at the sides that face it only: not its own two, none that it
/// sees from behind (the back of a thin part), none that turns the same way as its own.
class NearSearch {
  public:
    NearSearch(Surface master, Surface slave, NearRole role = {});

    /// Appends the rows of this step in the order of the master chain.
    void find(const StepMotion& motion, ContactRows& rows);
    /// The step is done. @param relative bound of the relative motion of the surfaces in it, @param slave
    /// that of the slave surface alone [length]
    void advance(double relative, double slave);
    /// Largest penetration at x_n that the last find saw, beyond allowances [length].
    [[nodiscard]] double deepest() const { return deepest_; }
    /// Forgets positions; nodes of `active`, indices in the master surface, count as having been in contact.
    void restart(const std::vector<std::int32_t>& active);

    /// Nodes that were looked at, in chain order, and the side that each is closest to (-1: not known).
    [[nodiscard]] const std::vector<std::int32_t>& awake() const { return awake_; }
    [[nodiscard]] std::int32_t closest(std::int32_t master) const {
        return memory_[static_cast<std::size_t>(master)].closest;
    }

    [[nodiscard]] const Surface& master() const { return master_; }
    [[nodiscard]] const Surface& slave() const { return slave_; }
    [[nodiscard]] bool of_master() const { return role_.of_master; }
    [[nodiscard]] std::int32_t first_owner() const { return role_.first_owner; }
    [[nodiscard]] bool any_overlap() const { return !role_.overlapping.empty(); }

  private:
    using Point = std::array<double, 2>;
    struct Memory {
        std::int32_t middle = -1;   ///< looked at together with its neighbours
        std::int32_t closest = -1;  ///< closest side when it was last looked at
        std::int32_t face = -1;     ///< the side that was within reach in the last step, -1: none
        bool near = false;          ///< was within reach in the last step
        double others_from = 0;     ///< distance of all but the middle and its neighbours + travelled_ then
        double free_until = 0;      ///< value of travelled_ before which the node cannot touch
        OverlapAllowance allowance;
    };
    struct Closest {
        SideView view;
        double distance;  ///< to the side itself, its ends included [length]
        std::int32_t side;
    };

    void measure(const Node* nodes);
    void wake(const StepMotion& motion);
    [[nodiscard]] bool alone_on(const SideView& view, const Memory& memory) const;
    [[nodiscard]] double sight(const StepMotion& motion) const;
    [[nodiscard]] Closest look(const StepMotion& motion, std::int32_t master, const Point& x);
    enum class Corner { sharp, flat, valley, steep_valley };  // over 45 degrees: sharp, steep
    struct Face {
        SideView view;
        std::int32_t side;  ///< -1: none
        [[nodiscard]] double gap() const {
            return side < 0 ? std::numeric_limits<double>::infinity() : view.gap;
        }
    };
    /// Whether a side can keep the node out; always, where the surfaces are two.
    [[nodiscard]] bool counts(const StepMotion& motion, std::int32_t master, const Point& x,
                              std::int32_t side) const;
    /// The neighbour of a side before its start or behind its end, -1: none that can keep the node out.
    [[nodiscard]] std::int32_t beside(std::int32_t side, bool before, std::int32_t master) const;
    [[nodiscard]] std::array<Point, 2> own_normals(const StepMotion& motion, std::int32_t master) const;
    [[nodiscard]] bool is_own(std::int32_t master, std::int32_t side) const;
    [[nodiscard]] Corner corner(const StepMotion& motion, std::int32_t first, std::int32_t second) const;
    [[nodiscard]] Face face_of(const StepMotion& motion, std::int32_t master, const Point& x,
                               const Closest& closest) const;
    [[nodiscard]] std::optional<Face> kept_face(const StepMotion& motion, const Point& x,
                                                const Closest& closest, const Memory& memory) const;
    [[nodiscard]] std::optional<Face> opposed_face(const StepMotion& motion, std::int32_t master,
                                                   const Point& x, const Closest& closest) const;
    [[nodiscard]] bool opposes(const StepMotion& motion, std::int32_t master, const SideView& face) const;
    [[nodiscard]] Face across_valley(const StepMotion& motion, std::int32_t master, const Point& x,
                                     const Face& face) const;
    /// @returns whether the face is within reach, whether the node has a row or not.
    bool add_row(const StepMotion& motion, std::int32_t master, const Face& face, const Memory& memory,
                 ContactRows& rows);
    void allow_overlap();
    [[nodiscard]] SideView view(const StepMotion& motion, std::int32_t side, const Point& x) const;

    Surface master_, slave_;
    NearRole role_;
    SideTree tree_;
    std::vector<Memory> memory_;
    std::vector<std::array<std::int32_t, 2>>
        own_sides_;                    ///< per master: sides that end and begin there, -1: none
    std::vector<std::int32_t> awake_;  ///< masters looked at in every step, in chain order
    double wake_at_ = 0;               ///< value of travelled_ at which all masters are looked over
    double mean_side_ = 0;             ///< 0: not measured yet [length]
    double travelled_ = 0;        ///< bound of the relative motion of the surfaces since the start [length]
    double slave_travelled_ = 0;  ///< bound of the slave's motion since the tree was fitted [length]
    double deepest_ = 0;
};

}  // namespace percuss
