#pragma once

#include <functional>

#include <vtkContext2D.h>
#include <vtkContextItem.h>
#include <vtkImageData.h>

#include "canvas.hpp"

namespace percuss::render {

/// Ink of VTK's 2D API.
class VtkCanvas final : public Canvas {
  public:
    explicit VtkCanvas(vtkContext2D& context) : context_(context) {}

    void text(double x, double y, const std::string& words, const TextStyle& style) override;
    [[nodiscard]] std::array<double, 2> text_size(const std::string& words, const TextStyle& style) override;
    void line(double x0, double y0, double x1, double y1, Colour colour, double width) override;
    void rectangle(const Rect& rect, Colour fill, double opacity) override;
    void quad(const std::array<std::array<double, 2>, 4>& corners, Colour fill) override;
    void disc(double x, double y, double radius, Colour fill) override;
    void image(const Rect& rect, vtkImageData* picture) override;

  private:
    void fill_arrow(const std::array<std::array<double, 2>, 7>& outline, Colour colour) override;
    void apply(const TextStyle& style);
    vtkContext2D& context_;
};

/// A scene item that calls a function to paint it.
class CanvasItem : public vtkContextItem {
  public:
    static CanvasItem* New();
    vtkTypeMacro(CanvasItem, vtkContextItem) bool Paint(vtkContext2D* context) override;
    std::function<void(Canvas&)> painter;

  protected:
    CanvasItem() = default;

  private:
    CanvasItem(const CanvasItem&) = delete;
    CanvasItem& operator=(const CanvasItem&) = delete;
};

}  // namespace percuss::render
