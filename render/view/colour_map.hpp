#pragma once

#include <string>

#include <vtkLookupTable.h>
#include <vtkSmartPointer.h>

namespace percuss::render {

/// A table of 256 colours. @param name one of colour_map_names(). @throws RenderError naming the nearest
/// valid name.
[[nodiscard]] vtkSmartPointer<vtkLookupTable> make_colour_map(const std::string& name);

}  // namespace percuss::render
