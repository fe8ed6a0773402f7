#pragma once

#include <vtkContextScene.h>
#include <vtkLookupTable.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include "canvas.hpp"
#include "figures/page.hpp"
#include "view/layout.hpp"
#include "view/surface.hpp"

namespace percuss::render {

// Each paints one panel into a rectangle of the page [pixels]; scale 1 makes type of 13 pixels.
void paint_heat_map(Canvas& canvas, const HeatMap& map, const Rect& rect, double scale);
void paint_areas(Canvas& canvas, const StackedAreas& areas, const Rect& rect, double scale);
void paint_bars(Canvas& canvas, const Bars& bars, const Rect& rect, double scale);
void paint_scatter(Canvas& canvas, const Scatter& scatter, const Rect& rect, double scale);
void paint_table(Canvas& canvas, const Table& table, const Rect& rect, double scale);

/// The mesh of a MeshPicture: its own renderer, clipped to its part of the page, and ink around it.
class MeshPanel {
  public:
    /// @param window of the page. @param page_size pixels. @throws RenderError for an unknown field or colour
    /// map.
    MeshPanel(const MeshPicture& picture, const Rect& rect, double scale, std::array<double, 2> page_size);
    [[nodiscard]] vtkRenderer* renderer() const { return renderer_; }
    void paint(Canvas& canvas) const;

  private:
    MeshPicture picture_;
    Rect rect_, model_;
    double scale_;
    Fit fit_;
    std::array<double, 2> range_{0, 1};
    vtkSmartPointer<vtkRenderer> renderer_;
    vtkSmartPointer<vtkLookupTable> colours_;
    std::unique_ptr<Surface> surface_;  // after the renderer that it is drawn by
};

}  // namespace percuss::render
