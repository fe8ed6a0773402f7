#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <vtkImageData.h>
#include <vtkLookupTable.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include "run/fields.hpp"
#include "run/snapshot.hpp"
#include "view/colour_range.hpp"
#include "view/plane.hpp"
#include "view/run_extent.hpp"
#include "view/surface.hpp"

namespace percuss::render {

/// The mesh of a run on its stage, coloured by a field: what pictures and the window show alike.
struct ColouredMesh {
    FieldInfo field;
    Plane plane;
    vtkSmartPointer<vtkLookupTable> colours;
    vtkSmartPointer<vtkImageData> strip;  ///< of the colours, for the bar
    std::unique_ptr<Surface> surface;
    std::optional<RunExtent> extent;

    /// Takes over field, colour map, direction and mirror of the options. @throws RenderError when the scene
    /// has no such field or colours; nothing is changed then.
    void apply(const std::shared_ptr<const RunSetup>& setup, const ViewOptions& options, vtkRenderer& stage);
    /// @param values of the field. @param apart distance of edges in the picture, 1 where text is 14 pixels
    /// high: they fade as they come closer together than the eye resolves.
    void show(const Snapshot& snapshot, const std::vector<double>& values, ColourRange range, bool edges,
              double apart);
};

}  // namespace percuss::render
