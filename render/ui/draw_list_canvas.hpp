#pragma once

#include "canvas.hpp"
#include "ui/screen.hpp"

struct ImDrawList;

namespace percuss::render {

/// Ink of ImGui: the same arrows, labels and bars as in pictures, over what a window shows.
class DrawListCanvas final : public Canvas {
  public:
    /// @param left, bottom of the canvas on the screen [pixels from the top left corner].
    /// Text comes in the loaded size, whatever size is asked for: other sizes would be blurred.
    DrawListCanvas(ImDrawList& list, const Fonts& fonts, double left, double bottom)
        : list_(list), fonts_(fonts), left_(left), bottom_(bottom) {}

    void text(double x, double y, const std::string& words, const TextStyle& style) override;
    [[nodiscard]] std::array<double, 2> text_size(const std::string& words, const TextStyle& style) override;
    void line(double x0, double y0, double x1, double y1, Colour colour, double width) override;
    void rectangle(const Rect& rect, Colour fill, double opacity) override;
    void quad(const std::array<std::array<double, 2>, 4>& corners, Colour fill) override;
    void disc(double x, double y, double radius, Colour fill) override;
    void image(const Rect& rect, vtkImageData* picture) override;

  private:
    void fill_arrow(const std::array<std::array<double, 2>, 7>& outline, Colour colour) override;
    ImDrawList& list_;
    const Fonts& fonts_;
    double left_, bottom_;
};

}  // namespace percuss::render
