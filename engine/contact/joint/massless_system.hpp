#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "contact/joint/breadth_first.hpp"
#include "contact/joint/massless_layer.hpp"
#include "contact/row.hpp"
#include "contact/solvers/bounded.hpp"
#include "run/statistics.hpp"

namespace percuss {

/// The quasidefinite system of a massless layer and contact rows,
///     [ -K  G^T ] [ u ]   [ f ]
///     [  G   e  ] [ C ] = [ P ],   C >= 0,
/// u the displacements of the layer, f its imbalance, e a little of each row's own compliance, so that rows
/// which depend on each other share a force. Nodes of the layer stand in breadth-first order over cells and
/// rows, each row behind the last of its nodes.
class MasslessSystem {
  public:
    /// @param rows, terms to make room for
    MasslessSystem(const MasslessLayer& layer, std::size_t rows, std::size_t terms);

    /// @param chosen of the rows @param imbalance per unknown of the layer [force] @param stand per row:
    /// where its force is expected (BoundedSolver)
    void assemble(const MasslessLayer& layer, const RowSpan& rows, std::span<const std::int32_t> chosen,
                  std::span<const double> imbalance, std::span<const char> stand);
    void solve(ContactSolverStatistics& statistics);

    /// Displacement of an unknown of the layer [length].
    [[nodiscard]] double moved(std::size_t unknown) const {
        return answer_[static_cast<std::size_t>(place_of_unknown_[unknown])];
    }
    /// Whether the chosen row k moves any node of the layer. The others have no force.
    [[nodiscard]] bool has_row(std::size_t k) const { return place_of_row_[k] >= 0; }
    [[nodiscard]] double force(std::size_t k) const {
        return has_row(k) ? std::max(0.0, answer_[static_cast<std::size_t>(place_of_row_[k])]) : 0;
    }
    /// @pre has_row(k)
    [[nodiscard]] char stand(std::size_t k) const {
        return stand_[static_cast<std::size_t>(place_of_row_[k])];
    }

  private:
    [[nodiscard]] bool same_nodes(const MasslessLayer& layer, const RowSpan& rows,
                                  std::span<const std::int32_t> chosen);
    [[nodiscard]] std::span<const std::int32_t> nodes_of(std::size_t row) const;
    [[nodiscard]] std::span<const std::int32_t> rows_at(std::size_t node) const;
    void list_rows_at_nodes(std::size_t nodes);
    void lay_out(const MasslessLayer& layer);
    void give_places(const MasslessLayer& layer);
    void make_profile(const MasslessLayer& layer);
    void add_stiffness(const MasslessLayer& layer);
    void add_rows(const MasslessLayer& layer, const RowSpan& rows, std::span<const std::int32_t> chosen,
                  std::span<const char> stand);

    // Layer nodes of the chosen rows, back to back, and those of the step to come; rows at each layer node.
    std::vector<std::int32_t> row_nodes_, row_nodes_begin_, next_nodes_, next_nodes_begin_;
    std::vector<std::int32_t> rows_at_, rows_at_begin_;
    std::vector<std::int32_t> left_;  ///< per row: its nodes that have no places yet
    std::vector<std::int32_t> place_of_unknown_, place_of_row_;
    std::vector<std::int32_t> first_of_;  ///< per place
    BreadthFirst breadth_first_;
    std::vector<PlaceGroup> groups_;
    ProfileMatrix matrix_;
    std::vector<double> known_, answer_;  ///< per place
    std::vector<char> stand_;
    BoundedSolver solver_;
};

}  // namespace percuss
