#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "contact/closest.hpp"
#include "contact/row.hpp"
#include "contact/side_tree.hpp"
#include "contact/surface.hpp"
#include "dynamics/node.hpp"

namespace percuss {

/// What a search needs to know of a step.
struct StepMotion {
    const Node* nodes = nullptr;  ///< predicted positions, and the velocities that led there
    double dt = 0;                ///< of the step: positions x_n before it were dt * velocity back [time]
    double range = 0;     ///< bound of the relative motion of the two surfaces within the step [length]
    double recovery = 0;  ///< a penetration is taken back by no more than this in the step [length]
};

/// Finds which master nodes of a pair could come to a slave side within the step. Conditions are built at
/// x_n, where the contact forces of the step act: a row's force then does the work that the ledger books, and
/// rows do not depend on how far the prediction went inside. The normal is that of the closest side itself
/// (no average): a node that slides from one facet to the next crosses where both give the same gap.
///
/// Nodes far from the slave surface sleep until the two surfaces can have moved that much.
class NearSearch {
  public:
    NearSearch(Surface master, Surface slave);

    /// Appends the rows of this step in the order of the master chain, with penetration P = -(max(gap,
    /// -recovery) + dt gap rate): how deep the predicted motion would go, counted from a gap that a step may
    /// make good.
    void find(const StepMotion& motion, ContactRows& rows);
    /// The step is done. @param relative bound of the relative motion of the surfaces in it, @param slave
    /// that of the slave surface alone [length]
    void advance(double relative, double slave);
    /// Largest penetration at x_n among the last rows [length].
    [[nodiscard]] double deepest() const { return deepest_; }
    /// Forgets positions; nodes of `active`, indices in the master surface, count as having been in contact.
    void restart(const std::vector<std::int32_t>& active);

    [[nodiscard]] const Surface& master() const { return master_; }
    [[nodiscard]] const Surface& slave() const { return slave_; }

  private:
    using Point = std::array<double, 2>;
    struct Memory {
        std::int32_t middle = -1;   ///< looked at together with its neighbours
        std::int32_t closest = -1;  ///< closest side when it was last looked at
        bool near = false;          ///< had a row in the last step
        double others_from = 0;     ///< distance of all but the middle and its neighbours + travelled_ then
        double free_until = 0;      ///< value of travelled_ before which the node cannot touch
    };
    struct Closest {
        SideView view;
        double distance;  ///< to the side itself, its ends included [length]
        std::int32_t side;
    };

    void measure(const Node* nodes);
    void wake(const StepMotion& motion);
    [[nodiscard]] bool alone_on(const SideView& view, const Memory& memory) const;
    [[nodiscard]] Closest look(const StepMotion& motion, const Point& x, Memory& memory);
    enum class Corner { sharp, flat, valley };
    struct Face {
        SideView view;
        std::int32_t side;  ///< -1: none
    };
    [[nodiscard]] Corner corner(const StepMotion& motion, std::int32_t first, std::int32_t second) const;
    [[nodiscard]] Face face_of(const StepMotion& motion, const Point& x, const Closest& closest) const;
    [[nodiscard]] Face across_valley(const StepMotion& motion, const Point& x, const Face& face) const;
    bool add_row(const StepMotion& motion, std::int32_t master, const Face& face, bool was_near,
                 ContactRows& rows);
    [[nodiscard]] SideView view(const StepMotion& motion, std::int32_t side, const Point& x) const;

    Surface master_, slave_;
    SideTree tree_;
    std::vector<Memory> memory_;
    std::vector<std::int32_t> awake_;  ///< masters looked at in every step, in chain order
    double wake_at_ = 0;               ///< value of travelled_ at which all masters are looked over
    double mean_side_ = 0;             ///< 0: not measured yet [length]
    double travelled_ = 0;        ///< bound of the relative motion of the surfaces since the start [length]
    double slave_travelled_ = 0;  ///< bound of the slave's motion since the tree was fitted [length]
    double deepest_ = 0;
};

}  // namespace percuss
