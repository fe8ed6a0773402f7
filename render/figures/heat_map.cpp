#include <algorithm>
#include <cmath>
#include <limits>

#include <vtkImageData.h>

#include "figures/axes.hpp"
#include "figures/panels.hpp"
#include "figures/ticks.hpp"
#include "view/colour_map.hpp"

namespace percuss::render {
namespace {

std::array<double, 2> extent_of(const std::vector<double>& places) {
    if (places.size() < 2)
        return {places.empty() ? 0 : places[0] - 0.5, places.empty() ? 1 : places[0] + 0.5};
    const std::size_t n = places.size();
    return {places[0] - 0.5 * (places[1] - places[0]), places[n - 1] + 0.5 * (places[n - 1] - places[n - 2])};
}

std::array<double, 2> range_of(const HeatMap& map) {
    if (map.range) return *map.range;
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const double value : map.values)
        if (std::isfinite(value)) {
            low = std::min(low, value);
            high = std::max(high, value);
        }
    if (low > high) return {0, 1};
    if (map.colour_map == "coolwarm") high = std::max(std::abs(low), std::abs(high)), low = -high;
    return high > low ? std::array{low, high} : std::array{low - 0.5, high + 0.5};
}

/// For each of `pixels` equal parts of [low, high]: the nearest place, or -1 beyond the outermost samples'
/// own parts.
std::vector<int> nearest_places(const std::vector<double>& places, const std::array<double, 2>& shown,
                                int pixels) {
    const auto extent = extent_of(places);
    std::vector<int> nearest(static_cast<std::size_t>(pixels), -1);
    for (int i = 0; i < pixels; ++i) {
        const double at = shown[0] + (shown[1] - shown[0]) * (i + 0.5) / pixels;
        if (at < extent[0] || at > extent[1]) continue;
        auto right =
            static_cast<std::size_t>(std::lower_bound(places.begin(), places.end(), at) - places.begin());
        if (right == places.size() || (right > 0 && at - places[right - 1] < places[right] - at)) --right;
        nearest[static_cast<std::size_t>(i)] = static_cast<int>(right);
    }
    return nearest;
}

vtkSmartPointer<vtkImageData> paint_values(const HeatMap& map, const Axes& axes,
                                           const std::array<double, 2>& range, vtkLookupTable& colours) {
    const int width = std::max(1, static_cast<int>(axes.area.width)),
              height = std::max(1, static_cast<int>(axes.area.height));
    const auto columns = nearest_places(map.x, axes.x, width), rows = nearest_places(map.y, axes.y, height);
    auto image = vtkSmartPointer<vtkImageData>::New();
    image->SetDimensions(width, height, 1);
    image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
    auto* pixel = static_cast<unsigned char*>(image->GetScalarPointer());
    const auto last = static_cast<double>(colours.GetNumberOfTableValues() - 1);
    for (const int row : rows)
        for (const int column : columns) {
            const double value = row < 0 || column < 0
                                     ? std::numeric_limits<double>::quiet_NaN()
                                     : map.values[static_cast<std::size_t>(column) * map.y.size() +
                                                  static_cast<std::size_t>(row)];
            std::array<unsigned char, 3> colour{255, 255, 255};
            if (std::isfinite(value)) {
                const double part = std::clamp((value - range[0]) / (range[1] - range[0]), 0.0, 1.0);
                const double* rgba = colours.GetTableValue(static_cast<vtkIdType>(std::lround(part * last)));
                for (std::size_t c = 0; c < 3; ++c)
                    colour[c] = static_cast<unsigned char>(std::lround(255 * rgba[c]));
            }
            pixel = std::copy(colour.begin(), colour.end(), pixel);
        }
    return image;
}

void paint_colour_column(Canvas& canvas, const Rect& bar, const std::array<double, 2>& range,
                         const std::string& title, vtkLookupTable& colours, double s) {
    const auto count = static_cast<int>(colours.GetNumberOfTableValues());
    for (int i = 0; i < count; ++i) {
        const double* rgba = colours.GetTableValue(i);
        Colour colour = 0;
        for (std::size_t c = 0; c < 3; ++c)
            colour = colour << 8U | static_cast<Colour>(std::lround(255 * rgba[c]));
        const double low = bar.y + bar.height * i / count;
        canvas.rectangle({bar.x, low, bar.width, bar.y + bar.height * (i + 1) / count - low}, colour);
    }
    const Ticks ticks =
        make_ticks(range[0], range[1], std::clamp(static_cast<int>(bar.height / (50 * s)), 2, 10));
    double widest = 0;
    for (std::size_t i = 0; i < ticks.values.size(); ++i) {
        const double y = bar.y + bar.height * (ticks.values[i] - range[0]) / (range[1] - range[0]);
        canvas.line(bar.right(), y, bar.right() + 5 * s, y, ink::soft, s);
        canvas.text(bar.right() + 9 * s, y, ticks.labels[i], {13 * s});
        widest = std::max(widest, canvas.text_size(ticks.labels[i], {13 * s})[0]);
    }
    TextStyle style{14 * s, ink::text, Align::centre};
    style.angle = 90;
    canvas.text(bar.right() + 9 * s + widest + 14 * s, bar.y + 0.5 * bar.height, title, style);
}

}  // namespace

void paint_heat_map(Canvas& canvas, const HeatMap& map, const Rect& rect, double scale) {
    const double heading = paint_panel_title(canvas, rect, map.title, scale);
    Axes axes{axes_area(rect, heading, 120 * scale, scale), map.x_range.value_or(extent_of(map.x)),
              map.y_range.value_or(extent_of(map.y)), scale};
    const auto range = range_of(map);
    const auto colours = make_colour_map(map.colour_map);
    canvas.image(axes.area, paint_values(map, axes, range, *colours));
    paint_axes(canvas, axes, rect, map.x_title, map.y_title);
    paint_colour_column(canvas, {axes.area.right() + 18 * scale, axes.area.y, 18 * scale, axes.area.height},
                        range, map.value_title, *colours, scale);
}

}  // namespace percuss::render
