#include <algorithm>
#include <array>

#include "figures/axes.hpp"
#include "figures/panels.hpp"

namespace percuss::render {

unsigned area_colour(std::size_t index) {
    // Okabe & Ito's colours and lighter ones of them, neighbours apart in lightness.
    static constexpr std::array<Colour, 12> palette{0x0072b2, 0xe69f00, 0x009e73, 0xd55e00,
                                                    0x56b4e9, 0xcc79a7, 0xf0e442, 0x7f8a96,
                                                    0x80b9d9, 0xf3cf80, 0x80cfb9, 0xeaaf80};
    return palette[index % palette.size()];
}

void paint_areas(Canvas& canvas, const StackedAreas& areas, const Rect& rect, double scale) {
    std::vector<std::string> labels;
    std::vector<Colour> colours;
    for (std::size_t k = 0; k < areas.layers.size(); ++k) {
        labels.push_back(areas.layers[k].label);
        colours.push_back(area_colour(k));
    }
    double heading = paint_panel_title(canvas, rect, areas.title, scale);
    heading += paint_legend(canvas, rect, rect.top() - heading, labels, colours, scale, true);

    const std::size_t count = areas.x.size();
    std::vector<double> above(count, 0), below(count, 0);
    struct Band {
        std::vector<double> low, high;
    };
    std::vector<Band> bands;
    double highest = 0, lowest = 0;
    for (const auto& layer : areas.layers) {
        Band band;
        for (std::size_t i = 0; i < count; ++i) {
            double& pile = layer.y[i] >= 0 ? above[i] : below[i];
            band.low.push_back(pile);
            pile += layer.y[i];
            band.high.push_back(pile);
            highest = std::max(highest, pile);
            lowest = std::min(lowest, pile);
        }
        bands.push_back(std::move(band));
    }
    if (count < 2 || !(highest > lowest)) return;
    const double margin = 0.04 * (highest - lowest);
    const bool hangs = lowest < -0.005 * highest;
    const Axes axes{axes_area(rect, heading, 16 * scale, scale),
                    {areas.x.front(), areas.x.back()},
                    areas.y_range.value_or(std::array{hangs ? lowest - margin : 0.0, highest + margin}),
                    scale};
    paint_grid(canvas, axes);
    for (std::size_t k = 0; k < bands.size(); ++k)
        for (std::size_t i = 0; i + 1 < count; ++i)
            canvas.quad({{{axes.to_x(areas.x[i]), axes.to_y(bands[k].low[i])},
                          {axes.to_x(areas.x[i + 1]), axes.to_y(bands[k].low[i + 1])},
                          {axes.to_x(areas.x[i + 1]), axes.to_y(bands[k].high[i + 1])},
                          {axes.to_x(areas.x[i]), axes.to_y(bands[k].high[i])}}},
                        colours[k]);
    paint_axes(canvas, axes, rect, areas.x_title, areas.y_title);
}

}  // namespace percuss::render
