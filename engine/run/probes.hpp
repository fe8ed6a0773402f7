#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "elements/batch.hpp"
#include "run/fields.hpp"

namespace percuss {

/// A probe's quantity bound to the cell or node it is read from.
struct ProbeReading {
    FieldInfo field;
    std::int32_t body = 0;
    std::int32_t cell = -1;  ///< nearest cell centre, for cell fields
    std::int32_t node = -1;  ///< nearest node, for node fields
    /// What a cell of a body that does not heat is shown at, when others do [temperature].
    std::optional<double> ambient;
};

/// One reading for each probe and recorded quantity, in the scene's order.
[[nodiscard]] std::vector<ProbeReading> bind_probes(const Scene& scene, const Mesh& mesh);
/// The same of one probe, which need not be the scene's. @pre the scene has its body and quantities.
[[nodiscard]] std::vector<ProbeReading> bind_probe(const Scene& scene, const Mesh& mesh, const Probe& probe);
/// Why a probe cannot be set beside the scene's own: they have its name, or the scene lacks its body or a
/// quantity; "" when it can.
[[nodiscard]] std::string fault_of_probe(const Scene& scene, const Mesh& mesh, const Probe& probe);

/// The value of a cell field when a step begins. @pre the reading is of a cell.
[[nodiscard]] double read_cell(const ProbeReading& reading, const std::vector<Batch>& batches,
                               const Node* nodes);
/// The value of a node field at the moment at which a step began: the velocity of that moment is the mean of
/// those before and after the step. @pre the reading is of a node.
[[nodiscard]] double read_node(const ProbeReading& reading, const Node& before, const Node& after,
                               const Mesh& mesh);

/// What an element is made of for its fields; an elastic one is at temperature 0.
[[nodiscard]] CellValues cell_values(const Batch& batch, const Node* nodes, std::int32_t element);

}  // namespace percuss
