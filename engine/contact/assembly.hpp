#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "contact/row.hpp"
#include "contact/solvers/profile_cholesky.hpp"

namespace percuss {

/// Assembles the paper's system (6), factor * (M_m^-1 + E^T M_s^-1 E). Rows couple through the nodes they
/// share. The paper's groups, master nodes on the same or adjacent slave sides, come out as blocks between
/// which the profile is empty; no order of rows is assumed, that along a surface makes the profile a narrow
/// band.
class ContactAssembly {
  public:
    explicit ContactAssembly(std::int32_t node_count) : head_(static_cast<std::size_t>(node_count), -1) {}

    /// Room for so many terms of rows.
    void reserve(std::size_t terms) {
        links_.resize(terms);
        couplings_.resize(terms);
    }
    /// @pre the nodes of a row differ. @param inverse_mass 2 per node [1/mass]; @param factor dt * kick
    /// [time^2].
    void assemble(const RowSpan& rows, const double* inverse_mass, double factor, ProfileMatrix& matrix);

  private:
    struct Link {
        std::int32_t row, next;
        std::array<double, 2> g;
    };
    struct Coupling {
        std::int32_t row;
        double value;
    };
    std::vector<std::int32_t> head_;  ///< per node: its newest link, -1 between calls
    std::vector<Link> links_;
    std::vector<Coupling> couplings_;  ///< of the row being assembled
};

}  // namespace percuss
