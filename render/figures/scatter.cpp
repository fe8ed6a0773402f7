#include <algorithm>
#include <cmath>
#include <limits>

#include "figures/axes.hpp"
#include "figures/panels.hpp"
#include "figures/plot.hpp"
#include "figures/ticks.hpp"

namespace percuss::render {
namespace {

using Range = std::array<double, 2>;

bool shown(double x, double y) { return std::isfinite(x) && std::isfinite(y) && x > 0 && y > 0; }

/// Where points stand on the paper.
struct LogAxes {
    Rect area;
    Range x, y;
    [[nodiscard]] double to_x(double value) const {
        return area.x + area.width * std::log(value / x[0]) / std::log(x[1] / x[0]);
    }
    [[nodiscard]] double to_y(double value) const {
        return area.y + area.height * std::log(value / y[0]) / std::log(y[1] / y[0]);
    }
};

void include(Range& range, double value) {
    range[0] = std::min(range[0], value);
    range[1] = std::max(range[1], value);
}

/// Room around the points; at least half a decade, so that one point has a place.
Range padded(const Range& range, double low_room, double high_room) {
    if (range[0] > range[1]) return {0.1, 10};
    const double decades = std::max(std::log10(range[1] / range[0]), 0.5);
    return {range[0] * std::pow(10.0, -low_room * decades), range[1] * std::pow(10.0, high_room * decades)};
}

void paint_axis_frame(Canvas& canvas, const LogAxes& axes, const Rect& rect, const Scatter& scatter,
                      double s) {
    const Rect& a = axes.area;
    const Ticks along = make_log_ticks(axes.x[0], axes.x[1], static_cast<int>(a.width / (70 * s))),
                up = make_log_ticks(axes.y[0], axes.y[1], static_cast<int>(a.height / (40 * s)));
    for (std::size_t i = 0; i < along.values.size(); ++i) {
        const double x = axes.to_x(along.values[i]);
        canvas.line(x, a.y, x, a.top(), ink::grid, s);
        canvas.line(x, a.y - 5 * s, x, a.y, ink::soft, s);
        canvas.text(x, a.y - 14 * s, along.labels[i], {13 * s, ink::text, Align::centre});
    }
    for (std::size_t i = 0; i < up.values.size(); ++i) {
        const double y = axes.to_y(up.values[i]);
        canvas.line(a.x, y, a.right(), y, ink::grid, s);
        canvas.line(a.x - 5 * s, y, a.x, y, ink::soft, s);
        canvas.text(a.x - 9 * s, y, up.labels[i], {13 * s, ink::text, Align::right});
    }
    for (const auto& [x0, y0, x1, y1] :
         {std::array{a.x, a.y, a.right(), a.y}, std::array{a.x, a.top(), a.right(), a.top()},
          std::array{a.x, a.y, a.x, a.top()}, std::array{a.right(), a.y, a.right(), a.top()}})
        canvas.line(x0, y0, x1, y1, ink::soft, s);
    TextStyle title{14 * s, ink::text, Align::centre, VerticalAlign::bottom};
    canvas.text(a.x + 0.5 * a.width, rect.y, scatter.x_title, title);
    title.vertical = VerticalAlign::centre;
    title.angle = 90;
    canvas.text(rect.x + 8 * s, a.y + 0.5 * a.height, scatter.y_title, title);
}

/// How many of the series after this one have a point where its point `i` is.
double later_at(const Scatter& scatter, const LogAxes& axes, std::size_t series, std::size_t i, double near) {
    const double x = scatter.series[series].x[i], y = scatter.series[series].y[i];
    if (!shown(x, y)) return 0;
    int count = 0;
    for (std::size_t k = series + 1; k < scatter.series.size(); ++k) {
        const auto& other = scatter.series[k];
        for (std::size_t j = 0; j < other.x.size(); ++j)
            if (shown(other.x[j], other.y[j]) && std::abs(axes.to_x(other.x[j]) - axes.to_x(x)) < near &&
                std::abs(axes.to_y(other.y[j]) - axes.to_y(y)) < near) {
                ++count;
                break;
            }
    }
    return count;
}

/// Writes notes beside their points where they cover neither points nor each other nor the frame; a note
/// without such a place is left out.
class NotePainter {
  public:
    NotePainter(Canvas& canvas, const LogAxes& axes, const Scatter& scatter, double s)
        : canvas_(canvas), axes_(axes), s_(s) {
        for (const auto& series : scatter.series)
            for (std::size_t i = 0; i < series.x.size(); ++i)
                if (shown(series.x[i], series.y[i])) {
                    const double r = 5 * s;
                    taken_.push_back({axes.to_x(series.x[i]) - r, axes.to_y(series.y[i]) - r, 2 * r, 2 * r});
                }
    }

    void paint(const Scatter::Note& note) {
        if (!shown(note.x, note.y)) return;
        const TextStyle style{12 * s_, ink::text};
        const auto [width, height] = canvas_.text_size(note.text, style);
        const double x = axes_.to_x(note.x), y = axes_.to_y(note.y);
        for (const double far : {8.0, 16.0, 26.0, 38.0})
            for (const auto& [dx, dy] : {std::pair{1.0, 0.0}, std::pair{1.0, -1.0}, std::pair{-1.0, -1.0},
                                         std::pair{1.0, 1.0}, std::pair{-1.0, 0.0}, std::pair{-1.0, 1.0}}) {
                const double gap = far * s_;
                const Rect place{dx > 0 ? x + gap : x - gap - width, y + dy * gap - 0.5 * height, width,
                                 height};
                if (!axes_.area.contains(place)) continue;
                if (std::any_of(taken_.begin(), taken_.end(),
                                [&](const Rect& r) { return r.overlaps(place); }))
                    continue;
                if (far > 10)
                    canvas_.line(x, y, dx > 0 ? place.x - 2 * s_ : place.right() + 2 * s_,
                                 place.y + 0.5 * height, ink::line, s_);
                canvas_.rectangle({place.x - 2 * s_, place.y, width + 4 * s_, height}, ink::white, 0.85);
                canvas_.text(place.x, place.y + 0.5 * height, note.text, style);
                taken_.push_back(place);
                return;
            }
    }

  private:
    Canvas& canvas_;
    const LogAxes& axes_;
    double s_;
    std::vector<Rect> taken_;
};

}  // namespace

void paint_scatter(Canvas& canvas, const Scatter& scatter, const Rect& rect, double scale) {
    const double s = scale;
    std::vector<std::string> labels;
    std::vector<Colour> colours;
    Range x{std::numeric_limits<double>::infinity(), 0}, y = x;
    for (const auto& series : scatter.series) {
        if (!series.label.empty()) {
            labels.push_back(series.label);
            colours.push_back(curve_colour(series.colour));
        }
        for (std::size_t i = 0; i < series.x.size(); ++i)
            if (shown(series.x[i], series.y[i])) include(x, series.x[i]), include(y, series.y[i]);
    }
    double heading = paint_panel_title(canvas, rect, scatter.title, s);
    if (labels.size() > 1)
        heading += paint_legend(canvas, rect, rect.top() - heading, labels, colours, s, true);
    if (scatter.limit && x[1] > 0) include(y, *scatter.limit);
    const LogAxes axes{axes_area(rect, heading, 12 * s, s), padded(x, 0.06, 0.12), padded(y, 0.08, 0.08)};
    paint_axis_frame(canvas, axes, rect, scatter, s);
    if (scatter.limit) {
        const double level = axes.to_y(*scatter.limit);
        for (double at = axes.area.x; at < axes.area.right(); at += 12 * s)
            canvas.line(at, level, std::min(at + 6 * s, axes.area.right()), level, ink::soft, s);
        canvas.text(axes.area.right() - 4 * s, level + 3 * s, scatter.limit_label,
                    {12 * s, ink::soft, Align::right, VerticalAlign::bottom});
    }
    for (std::size_t i = 0; i < scatter.front_x.size(); ++i) {
        // What costs more than a point of the front need not be worse: the step is level, then falls.
        const double from = axes.to_x(scatter.front_x[i]), level = axes.to_y(scatter.front_y[i]);
        const bool last = i + 1 == scatter.front_x.size();
        const double to = last ? axes.area.right() : axes.to_x(scatter.front_x[i + 1]);
        canvas.line(from, level, to, level, ink::line, 2 * s);
        if (!last) canvas.line(to, level, to, axes.to_y(scatter.front_y[i + 1]), ink::line, 2 * s);
    }
    for (std::size_t k = 0; k < scatter.series.size(); ++k) {
        const auto& series = scatter.series[k];
        const Colour colour = curve_colour(series.colour);
        // What later ones would cover is drawn larger, so that a rim of it is seen.
        std::vector<double> covers;
        for (std::size_t i = 0; i < series.x.size(); ++i)
            covers.push_back(later_at(scatter, axes, k, i, 3 * s));
        for (std::size_t i = 1; series.joined && i < series.x.size(); ++i)
            if (shown(series.x[i - 1], series.y[i - 1]) && shown(series.x[i], series.y[i]))
                canvas.line(axes.to_x(series.x[i - 1]), axes.to_y(series.y[i - 1]), axes.to_x(series.x[i]),
                            axes.to_y(series.y[i]), colour,
                            (1.6 + 2.2 * std::min(covers[i - 1], covers[i])) * s);
        for (std::size_t i = 0; i < series.x.size(); ++i)
            if (shown(series.x[i], series.y[i]))
                canvas.disc(axes.to_x(series.x[i]), axes.to_y(series.y[i]), (4.2 + 2.2 * covers[i]) * s,
                            colour);
    }
    NotePainter notes(canvas, axes, scatter, s);
    for (const auto& note : scatter.notes) notes.paint(note);
}

}  // namespace percuss::render
