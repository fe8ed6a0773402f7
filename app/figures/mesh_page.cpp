#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "figures/run_page.hpp"
#include "report.hpp"
#include "run/fields.hpp"

namespace percuss::app {
namespace {

/// What all pictures show: the asked region, else the box around the bodies in all of them.
std::array<double, 4> region_of(const FigureSpec& figure,
                                const std::vector<std::shared_ptr<const Snapshot>>& frames) {
    if (figure.region) return *figure.region;
    constexpr double most = std::numeric_limits<double>::infinity();
    std::array<double, 4> box{most, most, -most, -most};
    for (const auto& frame : frames)
        for (std::size_t k = 0; k < frame->position.size(); ++k) {
            box[k % 2] = std::min(box[k % 2], frame->position[k]);
            box[2 + k % 2] = std::max(box[2 + k % 2], frame->position[k]);
        }
    const double margin = 0.02 * std::max(box[2] - box[0], box[3] - box[1]);
    for (std::size_t d = 0; d < 2; ++d) box[d] -= margin, box[2 + d] += margin;
    if (frames.front()->setup->scene.geometry == Geometry::axisymmetric) box[0] = std::max(box[0], 0.0);
    return box;
}

/// One range of colours for all pictures.
std::array<double, 2> range_of(const FigureSpec& figure,
                               const std::vector<std::shared_ptr<const Snapshot>>& frames) {
    if (figure.range) return *figure.range;
    const FieldInfo field = find_field(frames.front()->setup->scene, figure.field);
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const auto& frame : frames)
        for (const double value : field_values(*frame, field))
            if (std::isfinite(value)) {
                low = std::min(low, value);
                high = std::max(high, value);
            }
    if (figure.colour_map == "coolwarm") high = std::max(std::abs(low), std::abs(high)), low = -high;
    return {low, high};
}

}  // namespace

RunPage make_mesh_page(const RecordedRun& run, const FigureSpec& figure) {
    const Scene& scene = run.setup->scene;
    std::vector<std::shared_ptr<const Snapshot>> frames;
    for (const double time : figure.times) frames.push_back(frame_near(run.frames, time));
    const std::array<double, 4> region = region_of(figure, frames);

    RunPage result;
    render::Page& page = result.page;
    page.title = figure.title;
    const auto count = static_cast<double>(frames.size());
    const DisplayUnit unit = time_unit(run);
    for (std::size_t k = 0; k < frames.size(); ++k) {
        render::MeshPicture picture;
        picture.snapshot = frames[k];
        picture.title = fmt::format("({}) t = {:.4g} {}", static_cast<char>('a' + static_cast<int>(k % 26)),
                                    unit.scale * frames[k]->time, unit.label);
        picture.options = scene.view;
        picture.options.window = region;
        picture.coloured = !figure.field.empty();
        if (picture.coloured) {
            picture.options.field = figure.field;
            picture.options.colour_map = figure.colour_map;
            picture.options.range = range_of(figure, frames);
        }
        picture.colour_bar = picture.coloured && k == 0;
        picture.scale_bar = true;
        picture.room_below =
            figure.field.empty() ? render::MeshPicture::scale_bar_room : render::MeshPicture::colour_bar_room;
        page.panels.push_back({std::move(picture), {static_cast<double>(k) / count, 0, 1 / count, 1}});
    }
    const bool mirrored = scene.view.mirror && scene.geometry == Geometry::axisymmetric;
    double wide = region[2] - region[0], high = region[3] - region[1];
    if (mirrored) wide = 2 * std::max(std::abs(region[0]), std::abs(region[2]));
    if (scene.view.up == VerticalAxis::first) std::swap(wide, high);
    const double each = std::clamp(2100 / count, 420.0, 900.0);
    page.width = static_cast<int>(each * count);
    page.type = 1.4;
    const double around = page.type * (48 + 14 + 26 + (figure.field.empty() ? 48 : 70)) + 40;
    page.height = static_cast<int>(std::clamp((each - 30) * high / wide + around, 420.0, 1800.0));
    return result;
}

}  // namespace percuss::app
