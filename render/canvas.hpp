#pragma once

#include <array>
#include <string>

class vtkImageData;

namespace percuss::render {

/// 0xRRGGBB
using Colour = unsigned;

namespace ink {
inline constexpr Colour text = 0x1f2630, soft = 0x5b6673, line = 0xb8c0c8, grid = 0xe7eaed, white = 0xffffff;
}

/// A rectangle of the picture in pixels; y upwards from the lowest row.
struct Rect {
    double x = 0, y = 0, width = 0, height = 0;
    [[nodiscard]] double right() const { return x + width; }
    [[nodiscard]] double top() const { return y + height; }
    [[nodiscard]] bool overlaps(const Rect& other) const {
        return x < other.right() && other.x < right() && y < other.top() && other.y < top();
    }
    [[nodiscard]] bool contains(const Rect& other) const {
        return other.x >= x && other.y >= y && other.right() <= right() && other.top() <= top();
    }
};

enum class Align { left, centre, right };
enum class VerticalAlign { bottom, centre, top };

struct TextStyle {
    double size = 14;  ///< pixels
    Colour colour = ink::text;
    Align align = Align::left;
    VerticalAlign vertical = VerticalAlign::centre;
    bool bold = false;
    double angle = 0;  ///< degrees, counter-clockwise
};

/// Ink on the picture, in pixels: on a figure or film frame by VTK, in the window by ImGui.
class Canvas {
  public:
    virtual ~Canvas() = default;

    virtual void text(double x, double y, const std::string& words, const TextStyle& style) = 0;
    [[nodiscard]] virtual std::array<double, 2> text_size(const std::string& words,
                                                          const TextStyle& style) = 0;
    virtual void line(double x0, double y0, double x1, double y1, Colour colour, double width) = 0;
    virtual void rectangle(const Rect& rect, Colour fill, double opacity = 1) = 0;
    /// A convex quadrilateral.
    virtual void quad(const std::array<std::array<double, 2>, 4>& corners, Colour fill) = 0;
    virtual void disc(double x, double y, double radius, Colour fill) = 0;
    virtual void image(const Rect& rect, vtkImageData* picture) = 0;
    /// An arrow with a filled head and a thin white rim that keeps it apart from what lies under it.
    /// @param dx, dy from tail to tip. The head shrinks with short arrows.
    void arrow(double x, double y, double dx, double dy, Colour colour, double thickness);

  protected:
    /// Fills an arrow. @param outline seven corners, anticlockwise from the tail's right corner; 2 and 4 are
    /// the head's corners, 3 its tip.
    virtual void fill_arrow(const std::array<std::array<double, 2>, 7>& outline, Colour colour) = 0;
};

}  // namespace percuss::render
