#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "contact/row.hpp"
#include "contact/solvers/profile_cholesky.hpp"

namespace percuss {

/// The matrix dt kick G M^-1 G^T of contact rows that couple through the nodes they share, by connected
/// groups. Rows stand in breadth-first order from the first row of each group (Cuthill & McKee 1969, without
/// sorting by degree), so that the profile is narrow whatever the order of pairs. Which products go where is
/// worked out only when rows come, go or change their nodes.
class Coupling {
  public:
    struct Group {
        std::int32_t begin, end;  ///< places of its rows in the matrix
    };

    /// @param fixed nodes that never move, those of walls: all rows on a wall share its two, and do not
    /// couple by them.
    explicit Coupling(std::int32_t node_count, std::span<const std::int32_t> fixed = {});
    void reserve(std::size_t rows, std::size_t terms);

    /// @param rows of which those in `chosen` take part; the nodes of a row differ. @param inverse_mass
    /// 2 per node [1/mass]; @param factor dt * kick [time^2].
    void assemble(const RowSpan& rows, std::span<const std::int32_t> chosen, const double* inverse_mass,
                  double factor);

    /// Adds to the diagonal: the row at this place gives way by so much to a unit force.
    void soften(std::int32_t place, double compliance) { matrix_.at(place, place) += compliance; }

    [[nodiscard]] const ProfileMatrix& matrix() const { return matrix_; }
    [[nodiscard]] std::span<const Group> groups() const { return groups_; }
    /// Per place in the matrix: which of the chosen rows stands there.
    [[nodiscard]] std::span<const std::int32_t> order() const { return order_; }

  private:
    struct Link {
        std::int32_t place, term, next;
    };
    struct Product {
        std::int32_t entry, unit, share;  ///< matrix value += unit motion of a term . share of a term
    };
    [[nodiscard]] bool same_nodes(const RowSpan& rows, std::span<const std::int32_t> chosen) const;
    [[nodiscard]] std::span<const std::int32_t> nodes_of(std::int32_t chosen) const;
    void restructure();
    void sort_into_groups();

    std::vector<char> fixed_;  ///< per node
    std::vector<std::int32_t> nodes_,
        nodes_begin_;                 ///< of the chosen rows when last restructured, back to back
    std::vector<std::int32_t> head_;  ///< per node: its newest link, -1 between calls
    std::vector<Link> links_;
    std::vector<std::int32_t> order_;
    std::vector<char> seen_;
    std::vector<Group> groups_;
    std::vector<Product> products_;
    /// Per term of the rows in the order of their places: its direction, and the motion that a unit force
    /// causes.
    std::vector<std::array<double, 2>> share_, unit_;
    ProfileMatrix matrix_;
};

}  // namespace percuss
