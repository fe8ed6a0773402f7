#pragma once

#include <array>
#include <vector>

#include <vtkActor.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkLookupTable.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include "run/snapshot.hpp"
#include "view/plane.hpp"

namespace percuss::render {

/// Side of a square as large as a mean cell of the undeformed mesh [length].
[[nodiscard]] double mean_cell_size(const Mesh& mesh);
/// Edges fade as they come closer together than the eye resolves. @param cell_size [pixels at 1280 x 720]
[[nodiscard]] double edge_opacity(double cell_size);

/// The deformed mesh. Its cells, edges and outlines are handed to VTK once; a frame changes points and
/// scalars in place.
class Surface {
  public:
    Surface(const Mesh& mesh, const Plane& plane, vtkRenderer& renderer);
    ~Surface();
    Surface(const Surface&) = delete;
    Surface& operator=(const Surface&) = delete;

    /// @param position 2 per node, scene units. @param values one a cell or one a node.
    void update(const std::vector<double>& position, const std::vector<double>& values, bool per_cell);
    void set_colours(vtkLookupTable* table, const std::array<double, 2>& range);
    /// @param opacity 0 to 1: dense meshes need faint edges. The outlines of the bodies are drawn in any
    /// case.
    void set_edges(bool shown, double opacity);
    /// Which halves of a mirrored mesh are drawn; both at first.
    void set_halves(bool meshed, bool mirror_image);
    void set_line_widths(double edges, double outlines);  ///< pixels

  private:
    void add_actors(vtkPolyDataMapper* mapper, std::vector<vtkSmartPointer<vtkActor>>& actors);

    void show(const std::vector<vtkSmartPointer<vtkActor>>& actors, bool shown);

    Plane plane_;
    std::array<bool, 2> halves_{true, true};
    bool edges_ = true;
    vtkRenderer& renderer_;
    vtkSmartPointer<vtkPoints> points_;
    vtkSmartPointer<vtkPolyData> cells_, lines_, outlines_;
    vtkSmartPointer<vtkPolyDataMapper> cell_mapper_, line_mapper_, outline_mapper_;
    vtkSmartPointer<vtkFloatArray> cell_values_, node_values_;
    std::vector<vtkSmartPointer<vtkActor>> cell_actors_, line_actors_, outline_actors_;
};

}  // namespace percuss::render
