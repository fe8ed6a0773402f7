#pragma once

#include <array>
#include <functional>
#include <string>

#include <vtkContext2D.h>
#include <vtkContextItem.h>
#include <vtkImageData.h>

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

/// Ink on the picture, in pixels.
class Canvas {
  public:
    explicit Canvas(vtkContext2D& context) : context_(context) {}

    void text(double x, double y, const std::string& words, const TextStyle& style);
    [[nodiscard]] std::array<double, 2> text_size(const std::string& words, const TextStyle& style);
    void line(double x0, double y0, double x1, double y1, Colour colour, double width);
    void rectangle(const Rect& rect, Colour fill, double opacity = 1);
    /// A convex quadrilateral.
    void quad(const std::array<std::array<double, 2>, 4>& corners, Colour fill);
    void disc(double x, double y, double radius, Colour fill);
    void image(const Rect& rect, vtkImageData* picture);
    /// An arrow with a filled head and a thin white rim that keeps it apart from what lies under it.
    /// @param dx, dy from tail to tip. The head shrinks with short arrows.
    void arrow(double x, double y, double dx, double dy, Colour colour, double thickness);

  private:
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
