#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "contact/joint/breadth_first.hpp"
#include "contact/row.hpp"
#include "contact/solvers/profile_cholesky.hpp"

namespace percuss {

/// The matrix dt kick G M^-1 G^T of contact rows that couple through the nodes they share, by connected
/// groups. Rows stand in breadth-first order. Which products go where is worked out only when rows come, go
/// or change their nodes.
///
/// Rows that share a node all couple with each other: a thousand nodes on one side would fill the matrix. A
/// node of more than `most_sharing` rows is therefore split off: in each direction, with w = dt kick / m, its
/// scaled motion l = sqrt(w) sum(g C) is an unknown of its own,
///     [ D              G sqrt(w) ] [ C ]   [ P ]
///     [ (G sqrt(w))^T     -1     ] [ l ] = [ 0 ],
/// D what rows share besides: the same C, from a matrix that stays narrow. It is quasidefinite, and so has
/// factors L D L^T in any order (Vanderbei 1995, doi:10.1137/0805005). Such a place stands for no row.
class Coupling {
  public:
    using Group = PlaceGroup;

    /// @param fixed nodes that never move, those of walls: all rows on a wall share its two, and do not
    /// couple by them.
    explicit Coupling(std::int32_t node_count, std::span<const std::int32_t> fixed = {});
    static constexpr std::int32_t most_sharing = 32;
    /// Whether nodes of many rows are split off, as only BoundedSolver can take it. At first they are.
    void split_off(bool splits);
    void reserve(std::size_t rows, std::size_t terms);

    /// @param rows of which those in `chosen` take part; the nodes of a row differ. @param inverse_mass
    /// 2 per node [1/mass]; @param factor dt * kick [time^2].
    void assemble(const RowSpan& rows, std::span<const std::int32_t> chosen, const double* inverse_mass,
                  double factor);

    /// Adds to the diagonal: the row at this place gives way by so much to a unit force.
    void soften(std::int32_t place, double compliance) { matrix_.at(place, place) += compliance; }

    [[nodiscard]] const ProfileMatrix& matrix() const { return matrix_; }
    [[nodiscard]] std::span<const Group> groups() const { return groups_; }
    /// Per place in the matrix: which of the chosen rows stands there, -1: none.
    [[nodiscard]] std::span<const std::int32_t> order() const { return order_; }
    [[nodiscard]] std::size_t places() const { return order_.size(); }
    [[nodiscard]] bool has_row(std::size_t place) const { return order_[place] >= 0; }

  private:
    struct Link {
        std::int32_t place, term, next;
    };
    struct Product {
        std::int32_t entry, unit, share;  ///< matrix value += unit motion of a term . share of a term
    };
    /// A node that is split off, and the last place of its rows.
    struct Split {
        std::int32_t last, node;
    };
    /// Entry of such a node's motion: a term of a row, in one direction.
    struct Motion {
        std::int32_t entry, diagonal, term, node;  ///< of the row in the second
        std::size_t direction;
    };
    [[nodiscard]] bool same_nodes(const RowSpan& rows, std::span<const std::int32_t> chosen) const;
    [[nodiscard]] std::span<const std::int32_t> nodes_of(std::int32_t chosen) const;
    [[nodiscard]] bool is_split(std::int32_t node) const {
        return sharing_[static_cast<std::size_t>(node)] != 0;
    }
    template <class Visit>
    void for_links(std::int32_t node, const Visit& visit) const;
    void link(std::span<const std::int32_t> order);
    void restructure();
    void find_split();
    void find_motions(const RowSpan& rows, std::span<const std::int32_t> chosen, const double* inverse_mass);
    [[nodiscard]] bool moved_enough(std::int32_t row) const;
    [[nodiscard]] bool all_moved_enough() const;
    void sort_into_groups();
    void insert_split();
    void lay_out();
    void lay_out_split(std::int32_t node, std::int32_t place);

    std::vector<char> fixed_;  ///< per node
    bool splits_ = true;
    std::vector<std::int32_t> sharing_;  ///< per node that is split off: its rows; 0: another
    std::vector<Split> split_;           ///< in the order of their places
    std::vector<double> motion_;         ///< per term of the chosen rows: of a unit force [1/mass]
    std::vector<std::int32_t> waiting_;  ///< scratch: links of split nodes; places of rows
    std::vector<Motion> motions_;
    std::vector<std::int32_t> nodes_,
        nodes_begin_;                 ///< of the chosen rows when last restructured, back to back
    std::vector<std::int32_t> head_;  ///< per node: its newest link, -1 between calls
    std::vector<Link> links_;
    BreadthFirst breadth_first_;
    std::vector<std::int32_t> order_;
    std::vector<Group> groups_;
    std::vector<Product> products_;
    /// Per term of the rows in the order of their places: its direction, and the motion that a unit force
    /// causes.
    std::vector<std::array<double, 2>> share_, unit_;
    ProfileMatrix matrix_;
};

}  // namespace percuss
