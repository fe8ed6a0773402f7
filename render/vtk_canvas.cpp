#include "vtk_canvas.hpp"

#include <algorithm>
#include <cmath>

#include <vtkBrush.h>
#include <vtkObjectFactory.h>
#include <vtkPen.h>
#include <vtkRect.h>
#include <vtkTextProperty.h>

namespace percuss::render {

vtkStandardNewMacro(CanvasItem)

    bool CanvasItem::Paint(vtkContext2D* context) {
    VtkCanvas canvas(*context);
    if (painter) painter(canvas);
    return true;
}

namespace {

std::array<unsigned char, 3> bytes(Colour colour) {
    return {static_cast<unsigned char>(colour >> 16U & 255U), static_cast<unsigned char>(colour >> 8U & 255U),
            static_cast<unsigned char>(colour & 255U)};
}

void set_pen(vtkContext2D& context, Colour colour, double width) {
    const auto c = bytes(colour);
    context.GetPen()->SetLineType(vtkPen::SOLID_LINE);
    context.GetPen()->SetColor(c[0], c[1], c[2]);
    context.GetPen()->SetOpacity(255);
    context.GetPen()->SetWidth(static_cast<float>(width));
}

void set_brush(vtkContext2D& context, Colour colour, double opacity = 1) {
    const auto c = bytes(colour);
    context.GetBrush()->SetTexture(nullptr);
    context.GetBrush()->SetColor(c[0], c[1], c[2]);
    context.GetBrush()->SetOpacityF(opacity);
}

}  // namespace

void VtkCanvas::apply(const TextStyle& style) {
    vtkTextProperty* property = context_.GetTextProp();
    const auto c = bytes(style.colour);
    property->SetFontFamilyToArial();
    property->SetFontSize(std::max(1, static_cast<int>(std::lround(style.size))));
    property->SetColor(c[0] / 255.0, c[1] / 255.0, c[2] / 255.0);
    property->SetBold(style.bold);
    property->SetItalic(false);
    property->SetOrientation(style.angle);
    property->SetJustification(style.align == Align::left     ? VTK_TEXT_LEFT
                               : style.align == Align::centre ? VTK_TEXT_CENTERED
                                                              : VTK_TEXT_RIGHT);
    property->SetVerticalJustification(style.vertical == VerticalAlign::bottom   ? VTK_TEXT_BOTTOM
                                       : style.vertical == VerticalAlign::centre ? VTK_TEXT_CENTERED
                                                                                 : VTK_TEXT_TOP);
}

void VtkCanvas::text(double x, double y, const std::string& words, const TextStyle& style) {
    if (words.empty()) return;
    apply(style);
    context_.DrawString(static_cast<float>(std::round(x)), static_cast<float>(std::round(y)), words.c_str());
}

std::array<double, 2> VtkCanvas::text_size(const std::string& words, const TextStyle& style) {
    if (words.empty()) return {0, 0};
    apply(style);
    float bounds[4];
    context_.ComputeStringBounds(words.c_str(), bounds);
    return {bounds[2], bounds[3]};
}

void VtkCanvas::line(double x0, double y0, double x1, double y1, Colour colour, double width) {
    set_pen(context_, colour, width);
    context_.DrawLine(static_cast<float>(x0), static_cast<float>(y0), static_cast<float>(x1),
                      static_cast<float>(y1));
}

void VtkCanvas::rectangle(const Rect& rect, Colour fill, double opacity) {
    context_.GetPen()->SetLineType(vtkPen::NO_PEN);
    set_brush(context_, fill, opacity);
    context_.DrawRect(static_cast<float>(rect.x), static_cast<float>(rect.y), static_cast<float>(rect.width),
                      static_cast<float>(rect.height));
}

void VtkCanvas::quad(const std::array<std::array<double, 2>, 4>& corners, Colour fill) {
    context_.GetPen()->SetLineType(vtkPen::NO_PEN);
    set_brush(context_, fill);
    std::array<float, 8> points{};
    for (std::size_t i = 0; i < 4; ++i) {
        points[2 * i] = static_cast<float>(corners[i][0]);
        points[2 * i + 1] = static_cast<float>(corners[i][1]);
    }
    context_.DrawPolygon(points.data(), 4);
}

void VtkCanvas::disc(double x, double y, double radius, Colour fill) {
    context_.GetPen()->SetLineType(vtkPen::NO_PEN);
    for (const auto& [r, colour] : {std::pair{radius + 1, ink::white}, std::pair{radius, fill}}) {
        set_brush(context_, colour);
        context_.DrawEllipse(static_cast<float>(x), static_cast<float>(y), static_cast<float>(r),
                             static_cast<float>(r));
    }
}

void VtkCanvas::image(const Rect& rect, vtkImageData* picture) {
    context_.GetPen()->SetLineType(vtkPen::NO_PEN);
    set_brush(context_, ink::white);
    context_.DrawImage(vtkRectf(static_cast<float>(rect.x), static_cast<float>(rect.y),
                                static_cast<float>(rect.width), static_cast<float>(rect.height)),
                       picture);
    context_.GetBrush()->SetTexture(nullptr);
}

void VtkCanvas::fill_arrow(const std::array<std::array<double, 2>, 7>& outline, Colour colour) {
    std::array<float, 16> points{};
    for (std::size_t i = 0; i < 8; ++i) {
        points[2 * i] = static_cast<float>(outline[i % 7][0]);
        points[2 * i + 1] = static_cast<float>(outline[i % 7][1]);
    }
    set_pen(context_, ink::white, 2.5);
    context_.DrawPoly(points.data(), 8);
    context_.GetPen()->SetLineType(vtkPen::NO_PEN);
    set_brush(context_, colour);
    float* p = points.data();
    float shaft[8] = {p[0], p[1], p[2], p[3], p[10], p[11], p[12], p[13]};
    float tip[6] = {p[4], p[5], p[6], p[7], p[8], p[9]};
    context_.DrawPolygon(shaft, 4);
    context_.DrawPolygon(tip, 3);
    set_pen(context_, colour, 1);  // smooth rim
    context_.DrawPoly(points.data(), 8);
}

}  // namespace percuss::render
