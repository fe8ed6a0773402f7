#include "figures/axes.hpp"

#include <algorithm>

#include "figures/ticks.hpp"

namespace percuss::render {
namespace {

Ticks x_ticks(const Axes& axes) {
    return make_ticks(axes.x[0], axes.x[1],
                      std::clamp(static_cast<int>(axes.area.width / (75 * axes.scale)), 2, 10));
}

Ticks y_ticks(const Axes& axes) {
    return make_ticks(axes.y[0], axes.y[1],
                      std::clamp(static_cast<int>(axes.area.height / (50 * axes.scale)), 2, 10));
}

}  // namespace

Rect axes_area(const Rect& rect, double heading, double right, double scale) {
    const double left = 76 * scale, below = 46 * scale;
    return {rect.x + left, rect.y + below, std::max(rect.width - left - right, 10.0),
            std::max(rect.height - below - heading - 8 * scale, 10.0)};
}

void paint_grid(Canvas& canvas, const Axes& axes) {
    const Rect& a = axes.area;
    for (const double value : x_ticks(axes).values)
        canvas.line(axes.to_x(value), a.y, axes.to_x(value), a.top(), ink::grid, axes.scale);
    for (const double value : y_ticks(axes).values)
        canvas.line(a.x, axes.to_y(value), a.right(), axes.to_y(value), ink::grid, axes.scale);
}

void paint_axes(Canvas& canvas, const Axes& axes, const Rect& rect, const std::string& x_title,
                const std::string& y_title) {
    const Rect& a = axes.area;
    const double s = axes.scale;
    for (const auto& [x0, y0, x1, y1] :
         {std::array{a.x, a.y, a.right(), a.y}, std::array{a.x, a.top(), a.right(), a.top()},
          std::array{a.x, a.y, a.x, a.top()}, std::array{a.right(), a.y, a.right(), a.top()}})
        canvas.line(x0, y0, x1, y1, ink::soft, s);
    const Ticks along = x_ticks(axes), up = y_ticks(axes);
    for (std::size_t i = 0; i < along.values.size(); ++i) {
        const double x = axes.to_x(along.values[i]);
        canvas.line(x, a.y - 5 * s, x, a.y, ink::soft, s);
        canvas.text(x, a.y - 14 * s, along.labels[i], {13 * s, ink::text, Align::centre});
    }
    for (std::size_t i = 0; i < up.values.size(); ++i) {
        const double y = axes.to_y(up.values[i]);
        canvas.line(a.x - 5 * s, y, a.x, y, ink::soft, s);
        canvas.text(a.x - 9 * s, y, up.labels[i], {13 * s, ink::text, Align::right});
    }
    TextStyle title{14 * s, ink::text, Align::centre, VerticalAlign::bottom};
    canvas.text(a.x + 0.5 * a.width, rect.y, x_title, title);
    title.vertical = VerticalAlign::centre;
    title.angle = 90;
    canvas.text(rect.x + 8 * s, a.y + 0.5 * a.height, y_title, title);
}

double panel_title_height(const std::string& title, double scale) { return title.empty() ? 0 : 26 * scale; }

double paint_panel_title(Canvas& canvas, const Rect& rect, const std::string& title, double scale) {
    canvas.text(rect.x, rect.top() - 12 * scale, title,
                {15 * scale, ink::text, Align::left, VerticalAlign::centre, true});
    return panel_title_height(title, scale);
}

double paint_legend(Canvas& canvas, const Rect& rect, double top, const std::vector<std::string>& labels,
                    const std::vector<Colour>& colours, double scale, bool paint) {
    if (labels.empty()) return 0;
    const TextStyle style{13 * scale};
    double x = rect.x;
    int row = 0;
    for (std::size_t i = 0; i < labels.size(); ++i) {
        const double width = 36 * scale + canvas.text_size(labels[i], style)[0];
        if (x > rect.x && x + width > rect.right()) {
            x = rect.x;
            ++row;
        }
        if (paint) {
            const double middle = top - (10 + 20 * row) * scale;
            canvas.rectangle({x, middle - 6 * scale, 14 * scale, 12 * scale}, colours[i]);
            canvas.text(x + 19 * scale, middle, labels[i], style);
        }
        x += width;
    }
    return (24 + 20 * row) * scale;
}

}  // namespace percuss::render
