#include "ui/draw_list_canvas.hpp"

#include <cmath>

#include <imgui.h>
#include <vtkImageData.h>

namespace percuss::render {
namespace {

ImU32 packed(Colour colour, double opacity = 1) {
    return IM_COL32(colour >> 16U & 255U, colour >> 8U & 255U, colour & 255U,
                    static_cast<unsigned>(std::lround(255 * opacity)));
}

ImVec2 point(double x, double y) { return {static_cast<float>(x), static_cast<float>(y)}; }

}  // namespace

namespace {

/// Letters are sharp in the size that the font was loaded in; only much smaller ones are drawn smaller.
float letter_size(const ImFont& font, const TextStyle& style) {
    return style.size < 0.82 * font.FontSize ? static_cast<float>(style.size) : font.FontSize;
}

}  // namespace

std::array<double, 2> DrawListCanvas::text_size(const std::string& words, const TextStyle& style) {
    const ImFont* font = style.bold ? fonts_.bold : fonts_.plain;
    const ImVec2 size = font->CalcTextSizeA(letter_size(*font, style), FLT_MAX, 0, words.c_str());
    return {size.x, size.y};
}

void DrawListCanvas::text(double x, double y, const std::string& words, const TextStyle& style) {
    if (words.empty()) return;
    const auto [width, height] = text_size(words, style);
    const double left = left_ + x -
                        (style.align == Align::left     ? 0
                         : style.align == Align::centre ? 0.5 * width
                                                        : width);
    const double middle = style.vertical == VerticalAlign::bottom ? y + 0.5 * height
                          : style.vertical == VerticalAlign::top  ? y - 0.5 * height
                                                                  : y;
    ImFont* font = style.bold ? fonts_.bold : fonts_.plain;
    list_.AddText(font, letter_size(*font, style),
                  point(std::round(left), std::round(bottom_ - middle - 0.5 * height)), packed(style.colour),
                  words.c_str());
}

void DrawListCanvas::line(double x0, double y0, double x1, double y1, Colour colour, double width) {
    list_.AddLine(point(left_ + x0, bottom_ - y0), point(left_ + x1, bottom_ - y1), packed(colour),
                  static_cast<float>(width));
}

void DrawListCanvas::rectangle(const Rect& rect, Colour fill, double opacity) {
    list_.AddRectFilled(point(left_ + rect.x, bottom_ - rect.top()),
                        point(left_ + rect.right(), bottom_ - rect.y), packed(fill, opacity));
}

void DrawListCanvas::quad(const std::array<std::array<double, 2>, 4>& corners, Colour fill) {
    std::array<ImVec2, 4> points;
    for (std::size_t i = 0; i < 4; ++i) points[i] = point(left_ + corners[i][0], bottom_ - corners[i][1]);
    list_.AddConvexPolyFilled(points.data(), 4, packed(fill));
}

void DrawListCanvas::disc(double x, double y, double radius, Colour fill) {
    const ImVec2 centre = point(left_ + x, bottom_ - y);
    list_.AddCircleFilled(centre, static_cast<float>(radius + 1), packed(ink::white));
    list_.AddCircleFilled(centre, static_cast<float>(radius), packed(fill));
}

void DrawListCanvas::image(const Rect& rect, vtkImageData* picture) {
    const int* size = picture->GetDimensions();
    const double width = rect.width / size[0], height = rect.height / size[1];
    for (int j = 0; j < size[1]; ++j)
        for (int i = 0; i < size[0]; ++i) {
            const auto* c = static_cast<const unsigned char*>(picture->GetScalarPointer(i, j, 0));
            rectangle({rect.x + i * width, rect.y + j * height, width, height},
                      static_cast<Colour>(c[0] << 16 | c[1] << 8 | c[2]), 1);
        }
}

void DrawListCanvas::fill_arrow(const std::array<std::array<double, 2>, 7>& outline, Colour colour) {
    std::array<ImVec2, 7> p;
    // ImGui's smooth rims want clockwise corners; turning y over does that.
    for (std::size_t i = 0; i < 7; ++i) p[i] = point(left_ + outline[i][0], bottom_ - outline[i][1]);
    list_.AddPolyline(p.data(), 7, packed(ink::white), ImDrawFlags_Closed,
                      2);  // whole widths are drawn with a third of the triangles
    const std::array<ImVec2, 4> shaft{p[0], p[1], p[5], p[6]};
    list_.AddConvexPolyFilled(shaft.data(), 4, packed(colour));
    list_.AddTriangleFilled(p[2], p[3], p[4], packed(colour));
}

}  // namespace percuss::render
