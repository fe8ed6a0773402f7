#pragma once

#include "mesh/mesh.hpp"
#include "record/hdf5.hpp"

namespace percuss {

/// Writes the mesh into an empty group / reads it back. Layout: FORMAT.md, /mesh. @throws RecordError.
void write_mesh(hid_t group, const Mesh& mesh, const std::string& length_label);
[[nodiscard]] Mesh read_mesh(hid_t group);

}  // namespace percuss
