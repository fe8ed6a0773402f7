#pragma once

#include <optional>

#include <vtkChartXY.h>
#include <vtkContextScene.h>
#include <vtkSmartPointer.h>

#include "vtk_canvas.hpp"
#include "figures/figure.hpp"
#include "figures/thin.hpp"

namespace percuss::render {

/// Colours that stay apart for colour-blind eyes and in print (Okabe & Ito).
[[nodiscard]] Colour curve_colour(std::size_t index);

/// One chart in a context scene: VTK's axes, grid and curves under a heading with title and legend, which
/// stand above the axes so that they never cover a curve.
class Plot {
  public:
    /// @param smooth_hairlines true in a window that smooths lines of one pixel but no wider ones, which VTK
    /// makes of triangles (RenderWindow with one sample): curves are then drawn as bundles of such lines.
    Plot(vtkContextScene& scene, bool smooth_hairlines);

    /// @param rect pixels, heading and axis titles included. @param scale of fonts and line widths.
    /// @param marker x of a vertical line, e.g. the present time.
    void show(const Chart& chart, const Rect& rect, double scale, std::optional<double> marker = {});
    void hide();

  private:
    struct Entry {
        std::string label;
        Colour colour;
        bool dashed;
        double x = 0;  // offset from the left, pixels
        int row = 0;
    };
    void paint_heading(Canvas& canvas) const;
    void set_legend(const std::vector<Curve>& curves);
    void add_line(const Polyline2& line, Colour colour, double width);
    void add_curve(const Polyline2& line, Colour colour, double width);
    void style_axis(int which, const std::array<double, 2>& range, int ticks);

    vtkSmartPointer<vtkChartXY> chart_;
    vtkSmartPointer<CanvasItem> heading_;
    Rect rect_;
    double scale_ = 1;
    bool smooth_hairlines_ = false;
    std::array<double, 2> pixel_{1, 1};  // one pixel in units of the axes
    std::string title_, x_title_, y_title_;
    std::vector<Entry> entries_;
};

}  // namespace percuss::render
