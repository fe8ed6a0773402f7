#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "contact/closest.hpp"
#include "contact/row.hpp"
#include "contact/side_tree.hpp"
#include "contact/surface.hpp"
#include "dynamics/node.hpp"

namespace percuss {

/// Finds which master nodes have penetrated which slave side (step 1 of the paper). Every node remembers how
/// far it was from the slave surface and is looked at again only when the two surfaces can have moved that
/// much; a node near a side looks at that side and its neighbours only, until a farther side could have come
/// closer.
class PenetrationSearch {
  public:
    PenetrationSearch(Surface master, Surface slave);

    /// Fills `rows` with the penetrating master nodes at the predicted positions, in the order of the master
    /// chain.
    /// @param nodes predicted positions, and the velocities that led there in the step @param dt [time].
    void find(const Node* nodes, double dt, ContactRows& rows);

    /// Present penetration of the node that a row keeps out into its slave side, negative when open [length].
    [[nodiscard]] double penetration(const Node* nodes, const ContactRow& row) const;

    [[nodiscard]] const Surface& master() const { return master_; }
    [[nodiscard]] const Surface& slave() const { return slave_; }
    void
    forget();  ///< drops all that was remembered: positions were set back or the step was not the next one

  private:
    using Point = std::array<double, 2>;
    struct Memory {
        std::int32_t side = -1;  ///< looked at together with its neighbours
        std::int32_t held = -1;  ///< side that held the node when it was last looked at, -1: none
        double free_until = 0;   ///< value of travelled_ before which the node cannot reach the slave surface
        double others_from = 0;  ///< distance of all other sides + travelled_ when they were looked at
    };
    struct Closest {
        std::int32_t side;
        double distance;  ///< [length]
    };
    /// The slave side that a node has penetrated, and how it stands to it.
    struct Entered {
        std::int32_t side;
        SideView view;
    };
    void measure_motion(const Node* nodes, double dt);
    void measure_lengths(const Node* nodes);
    [[nodiscard]] Closest closest_side(const Node* nodes, const double* x, Memory& memory);
    [[nodiscard]] Closest closest_of_neighbours(const Node* nodes, const double* x, std::int32_t side) const;
    [[nodiscard]] double free_distance(const Node* nodes, const double* x, const Closest& closest,
                                       const Memory& memory) const;
    [[nodiscard]] std::optional<Entered> enter(const Node* nodes, double dt, std::int32_t master,
                                               const Closest& closest, std::int32_t held) const;
    [[nodiscard]] static bool behind_vertex(const Node* nodes, const Side& around, const SideView& view,
                                            double dx, double dy);
    [[nodiscard]] bool entered_neighbour(const Node* nodes, double dt, std::int32_t node, std::int32_t side,
                                         const SideView& view, std::int32_t held,
                                         const SideView& neighbour) const;
    [[nodiscard]] bool sharp_corner(const Node* nodes, std::int32_t first, std::int32_t second) const;
    [[nodiscard]] double gap_before(const Node* nodes, double dt, std::int32_t node, const Side& side) const;

    Surface master_, slave_;
    SideTree tree_;
    std::vector<Memory> memory_;
    std::vector<Point> master_at_, slave_at_;  ///< surface nodes when find was last called; empty: not yet
    double end_reach_ = 0;    ///< how far past the end of a face a node still belongs to it [length]
    double refit_after_ = 0;  ///< value of slave_travelled_ at which the tree is fitted anew [length]
    double travelled_ = 0;    ///< bound of the relative motion of the two surfaces since the start [length]
    double step_motion_ = 0;  ///< the same, since the last call [length]
    double slave_travelled_ = 0;  ///< bound of the slave surface's motion since the tree was fitted [length]
};

}  // namespace percuss
