#pragma once

#include <cstdint>
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
};

/// One reading for each probe and recorded quantity, in the scene's order.
[[nodiscard]] std::vector<ProbeReading> bind_probes(const Scene& scene, const Mesh& mesh);

/// What a probe reads of an element; an elastic one is at temperature 0.
[[nodiscard]] CellValues cell_values(const Batch& batch, const Node* nodes, std::int32_t element);

}  // namespace percuss
