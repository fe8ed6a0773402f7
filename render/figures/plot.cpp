#include "figures/plot.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <vtkAxis.h>
#include <vtkDoubleArray.h>
#include <vtkPen.h>
#include <vtkPlotLine.h>
#include <vtkRect.h>
#include <vtkStringArray.h>
#include <vtkTable.h>
#include <vtkTextProperty.h>

#include "figures/thin.hpp"
#include "figures/ticks.hpp"

namespace percuss::render {

namespace {

constexpr Colour exact_colour = 0x4a4f57;

void set_pen(vtkPen* pen, Colour colour, double width) {
    pen->SetColor(static_cast<unsigned char>(colour >> 16U & 255U),
                  static_cast<unsigned char>(colour >> 8U & 255U), static_cast<unsigned char>(colour & 255U));
    pen->SetWidth(static_cast<float>(width));
}

void set_text(vtkTextProperty* property, Colour colour, double size) {
    property->SetFontFamilyToArial();
    property->SetFontSize(std::max(1, static_cast<int>(std::lround(size))));
    property->SetColor((colour >> 16U & 255U) / 255.0, (colour >> 8U & 255U) / 255.0,
                       (colour & 255U) / 255.0);
    property->SetBold(false);
    property->SetItalic(false);
}

/// Least and greatest finite value of all curves; {0, 1} when there is none.
std::array<double, 2> extent(const std::vector<Curve>& curves, std::vector<double> Curve::*values) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const Curve& curve : curves)
        for (const double value : curve.*values)
            if (std::isfinite(value)) {
                low = std::min(low, value);
                high = std::max(high, value);
            }
    if (low > high) return {0, 1};
    return {low, high};
}

/// Room above and below the curves; zero is shown when it is near. What varies by rounding only is constant.
std::array<double, 2> padded(std::array<double, 2> range) {
    auto [low, high] = range;
    if (low > 0 && low < 0.35 * high) low = 0;
    if (high < 0 && high > 0.35 * low) high = 0;
    double span = high - low;
    const double largest = std::max(std::abs(low), std::abs(high));
    if (!(span > 1e-9 * largest)) span = largest > 0 ? largest : 1;
    return {low == 0 ? -0.03 * span : low - 0.06 * span, high == 0 ? 0.03 * span : high + 0.06 * span};
}

/// Cuts a polyline into dashes by its length in pixels: pen patterns do not exist in core OpenGL.
std::vector<Polyline2> dashes(const Polyline2& line, double x_scale, double y_scale, double on, double off) {
    std::vector<Polyline2> result;
    double phase = 0;  // within one period of on + off
    bool drawing = false;
    for (std::size_t i = 1; i < line.x.size(); ++i) {
        const double dx = line.x[i] - line.x[i - 1], dy = line.y[i] - line.y[i - 1];
        const double length = std::hypot(dx * x_scale, dy * y_scale);
        double done = 0;
        while (done < length) {
            const double part = std::min(phase < on ? on - phase : on + off - phase, length - done);
            if (phase < on) {
                if (!drawing) {
                    result.emplace_back();
                    result.back().x.push_back(line.x[i - 1] + dx * done / length);
                    result.back().y.push_back(line.y[i - 1] + dy * done / length);
                }
                result.back().x.push_back(line.x[i - 1] + dx * (done + part) / length);
                result.back().y.push_back(line.y[i - 1] + dy * (done + part) / length);
            }
            drawing = phase < on;
            done += part;
            phase += part;
            if (phase >= on + off - 1e-9) phase = 0;
            if (phase >= on) drawing = false;
        }
    }
    return result;
}

/// @param drawn curves so far that take their colour from their place
Colour colour_of(const Curve& curve, std::size_t& drawn) {
    if (curve.exact) return exact_colour;
    return curve_colour(curve.colour ? *curve.colour : drawn++);
}

}  // namespace

Colour curve_colour(std::size_t index) {
    // Darker ones from the ninth on, as in the window's plots.
    static constexpr std::array<Colour, 14> palette{0x0072b2, 0xd55e00, 0x009e73, 0xcc79a7, 0xe69f00,
                                                    0x56b4e9, 0x000000, 0xbeaf14, 0x00466e, 0x8c3c00,
                                                    0x005f46, 0x824669, 0x966400, 0x326e91};
    return palette[index % palette.size()];
}

Plot::Plot(vtkContextScene& scene, bool smooth_hairlines)
    : chart_(vtkSmartPointer<vtkChartXY>::New()),
      heading_(vtkSmartPointer<CanvasItem>::New()),
      smooth_hairlines_(smooth_hairlines) {
    chart_->SetAutoSize(false);
    chart_->SetShowLegend(false);
    chart_->SetRenderEmpty(true);
    chart_->SetInteractive(false);
    heading_->painter = [this](Canvas& canvas) { paint_heading(canvas); };
    scene.AddItem(chart_);
    scene.AddItem(heading_);
    hide();
}

void Plot::hide() {
    chart_->SetVisible(false);
    heading_->SetVisible(false);
}

void Plot::style_axis(int which, const std::array<double, 2>& range, int ticks) {
    vtkAxis* axis = chart_->GetAxis(which);
    set_text(axis->GetLabelProperties(), ink::text, 13 * scale_);
    axis->SetTitle("");
    axis->SetBehavior(vtkAxis::FIXED);
    axis->SetRange(range[0], range[1]);
    const Ticks places = make_ticks(range[0], range[1], ticks);
    auto values = vtkSmartPointer<vtkDoubleArray>::New();
    auto labels = vtkSmartPointer<vtkStringArray>::New();
    for (std::size_t i = 0; i < places.values.size(); ++i) {
        values->InsertNextValue(places.values[i]);
        labels->InsertNextValue(places.labels[i]);
    }
    axis->SetCustomTickPositions(values, labels);
    set_pen(axis->GetPen(), ink::soft, std::max(1.0, scale_));
    set_pen(axis->GetGridPen(), ink::grid, std::max(1.0, scale_));
    axis->SetLabelOffset(static_cast<float>(8 * scale_));
    axis->SetTickLength(static_cast<float>(5 * scale_));
}

void Plot::add_line(const Polyline2& line, Colour colour, double width) {
    if (line.x.size() < 2) return;  // VTK logs an error
    auto table = vtkSmartPointer<vtkTable>::New();
    auto x = vtkSmartPointer<vtkDoubleArray>::New(), y = vtkSmartPointer<vtkDoubleArray>::New();
    x->SetName("x");
    y->SetName("y");
    for (const double value : line.x) x->InsertNextValue(value);
    for (const double value : line.y) y->InsertNextValue(value);
    table->AddColumn(x);
    table->AddColumn(y);
    auto plot = vtkSmartPointer<vtkPlotLine>::New();
    plot->SetInputData(table, 0, 1);
    plot->SetMarkerStyle(vtkPlotPoints::NONE);
    set_pen(plot->GetPen(), colour, width);
    chart_->AddPlot(plot);
}

void Plot::add_curve(const Polyline2& line, Colour colour, double width) {
    if (!smooth_hairlines_ || width <= 1) return add_line(line, colour, width);
    // Three hairlines around the true place widen the curve alike in all directions.
    const double r = 0.5 * (width - 1);
    for (const auto& [dx, dy] :
         {std::pair{0.0, r}, std::pair{0.866 * r, -0.5 * r}, std::pair{-0.866 * r, -0.5 * r}}) {
        Polyline2 shifted = line;
        for (double& x : shifted.x) x += dx * pixel_[0];
        for (double& y : shifted.y) y += dy * pixel_[1];
        add_line(shifted, colour, 1);
    }
}

void Plot::set_legend(const std::vector<Curve>& curves) {
    entries_.clear();
    double x = 0;
    int row = 0;
    std::size_t drawn = 0;
    for (const Curve& curve : curves) {
        const Colour colour = colour_of(curve, drawn);
        if (curve.label.empty()) continue;
        // The text cannot be measured before it is painted; 8 pixels a letter is a wide estimate at this
        // size.
        const double width = (41 + 8 * static_cast<double>(curve.label.size())) * scale_;
        if (x > 0 && x + width > rect_.width) {
            x = 0;
            ++row;
        }
        entries_.push_back({curve.label, colour, curve.exact || curve.dashed, x, row});
        x += width;
    }
}

void Plot::show(const Chart& chart, const Rect& rect, double scale, std::optional<double> marker) {
    rect_ = rect;
    scale_ = scale;
    title_ = chart.title;
    chart_->SetVisible(true);
    heading_->SetVisible(true);
    chart_->ClearPlots();
    chart_->SetHiddenAxisBorder(static_cast<int>(14 * scale_));

    const std::array<double, 2> x = chart.x_range ? *chart.x_range : extent(chart.curves, &Curve::x);
    const std::array<double, 2> y = chart.y_range ? *chart.y_range : padded(extent(chart.curves, &Curve::y));
    set_legend(chart.curves);
    const int legend_rows = entries_.empty() ? 0 : entries_.back().row + 1;
    const double heading = (title_.empty() ? 0 : 24 * scale) + legend_rows * 20 * scale;
    // VTK's axes would print their titles over tick labels of this size, so the heading's painter writes
    // them.
    x_title_ = chart.x_title;
    y_title_ = chart.y_title;
    const double left = y_title_.empty() ? 0 : 22 * scale, below = x_title_.empty() ? 0 : 21 * scale;
    chart_->SetSize(vtkRectf(static_cast<float>(rect.x + left), static_cast<float>(rect.y + below),
                             static_cast<float>(rect.width - left),
                             static_cast<float>(std::max(rect.height - heading - below, 10.0))));
    style_axis(vtkAxis::BOTTOM, x, std::clamp(static_cast<int>(rect.width / (75 * scale)), 2, 10));
    style_axis(vtkAxis::LEFT, y, std::clamp(static_cast<int>(rect.height / (56 * scale)), 2, 8));

    const double width = rect.width - 60 * scale, height = rect.height - heading - 50 * scale;
    pixel_ = {(x[1] - x[0]) / width, (y[1] - y[0]) / height};
    if (marker) add_line({{*marker, *marker}, {y[0], y[1]}}, 0x9aa3ad, 1);
    std::size_t drawn = 0;
    for (const Curve& curve : chart.curves) {
        const Colour colour = colour_of(curve, drawn);
        const Polyline2 line = thin(curve.x, curve.y, x[0], x[1], std::max(1, static_cast<int>(width)));
        if (!curve.exact && !curve.dashed) {
            add_curve(line, colour, 1.6 * scale);
            continue;
        }
        for (const Polyline2& dash : dashes(line, 1 / pixel_[0], 1 / pixel_[1], 9 * scale, 5 * scale))
            add_curve(dash, colour, 1.6 * scale);
    }
}

void Plot::paint_heading(Canvas& canvas) const {
    const int* low = chart_->GetPoint1();  // of the area between the axes, known since the chart was painted
    const int* high = chart_->GetPoint2();
    TextStyle axis_title{14 * scale_, ink::text, Align::centre, VerticalAlign::bottom};
    canvas.text(0.5 * (low[0] + high[0]), rect_.y, x_title_, axis_title);
    axis_title.vertical = VerticalAlign::centre;
    axis_title.angle = 90;
    canvas.text(rect_.x + 8 * scale_, 0.5 * (low[1] + high[1]), y_title_, axis_title);
    double y = rect_.top();
    if (!title_.empty()) {
        canvas.text(rect_.x, y - 12 * scale_, title_,
                    {15 * scale_, ink::text, Align::left, VerticalAlign::centre, true});
        y -= 24 * scale_;
    }
    for (const Entry& entry : entries_) {
        const double x = rect_.x + entry.x, middle = y - (10 + 20 * entry.row) * scale_;
        const double sample = 20 * scale_;
        if (entry.dashed) {
            canvas.line(x, middle, x + 0.4 * sample, middle, entry.colour, 2 * scale_);
            canvas.line(x + 0.6 * sample, middle, x + sample, middle, entry.colour, 2 * scale_);
        } else {
            canvas.line(x, middle, x + sample, middle, entry.colour, 3 * scale_);
        }
        canvas.text(x + sample + 5 * scale_, middle, entry.label, {13 * scale_, ink::text});
    }
}

}  // namespace percuss::render
