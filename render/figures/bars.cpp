#include <algorithm>

#include "figures/axes.hpp"
#include "figures/panels.hpp"
#include "figures/ticks.hpp"

namespace percuss::render {

void paint_bars(Canvas& canvas, const Bars& bars, const Rect& rect, double scale) {
    std::vector<Colour> colours;
    for (std::size_t k = 0; k < bars.series.size(); ++k) colours.push_back(area_colour(k));
    double heading = paint_panel_title(canvas, rect, bars.title, scale);
    if (bars.series.size() > 1)
        heading += paint_legend(canvas, rect, rect.top() - heading, bars.series, colours, scale, true);
    const TextStyle type{13 * scale};
    double label = 0, text = 0, low = 0, high = 0;
    for (const auto& group : bars.groups) {
        label = std::max(label, canvas.text_size(group.label, type)[0]);
        for (const auto& words : group.texts) text = std::max(text, canvas.text_size(words, type)[0]);
        for (const double value : group.values) {
            low = std::min(low, value);
            high = std::max(high, value);
        }
    }
    if (bars.groups.empty() || !(high > low)) return;
    const double below = 46 * scale, gap = 8 * scale;
    // The texts stand beyond the bars' ends, inside the area.
    const Rect area{rect.x + label + 2 * gap, rect.y + below, std::max(rect.width - label - 3 * gap, 10.0),
                    std::max(rect.height - heading - below - gap, 10.0)};
    const double room = text + 2 * gap,
                 fill = std::max(area.width - (low < 0 ? room : 0) - (high > 0 ? room : 0), 10.0);
    const double per_pixel = (high - low) / fill;
    const Axes axes{area,
                    {low - (low < 0 ? room * per_pixel : 0), high + (high > 0 ? room * per_pixel : 0)},
                    {0, 1},
                    scale};
    const Ticks ticks =
        make_ticks(axes.x[0], axes.x[1], std::clamp(static_cast<int>(area.width / (90 * scale)), 2, 8));
    for (std::size_t i = 0; i < ticks.values.size(); ++i) {
        const double x = axes.to_x(ticks.values[i]);
        canvas.line(x, area.y, x, area.top(), ink::grid, scale);
        canvas.text(x, area.y - 14 * scale, ticks.labels[i], {13 * scale, ink::text, Align::centre});
    }
    const double each = area.height / static_cast<double>(bars.groups.size());
    const double zero = axes.to_x(0);
    for (std::size_t g = 0; g < bars.groups.size(); ++g) {
        const auto& group = bars.groups[g];
        const double top = area.top() - each * static_cast<double>(g);
        canvas.text(area.x - gap, top - 0.5 * each, group.label, {13 * scale, ink::text, Align::right});
        const double thick = std::min(0.76 * each / static_cast<double>(group.values.size()), 26 * scale);
        double y = top - 0.5 * each + 0.5 * thick * static_cast<double>(group.values.size());
        for (std::size_t k = 0; k < group.values.size(); ++k, y -= thick) {
            const double end = axes.to_x(group.values[k]);
            canvas.rectangle({std::min(zero, end), y - 0.94 * thick, std::abs(end - zero), 0.88 * thick},
                             area_colour(bars.by_group ? g : k));
            const bool left = group.values[k] < 0;
            canvas.text(end + (left ? -gap : gap), y - 0.5 * thick, group.texts[k],
                        {13 * scale, ink::text, left ? Align::right : Align::left});
        }
    }
    canvas.line(zero, area.y, zero, area.top(), ink::soft, scale);
    canvas.text(area.x + 0.5 * area.width, rect.y, bars.x_title,
                {14 * scale, ink::text, Align::centre, VerticalAlign::bottom});
}

}  // namespace percuss::render
