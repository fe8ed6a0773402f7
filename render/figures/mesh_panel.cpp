#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <vtkCamera.h>

#include "figures/axes.hpp"
#include "figures/panels.hpp"
#include "figures/ticks.hpp"
#include "run/fields.hpp"
#include "view/bodies.hpp"
#include "view/colour_map.hpp"
#include "view/colour_range.hpp"
#include "view/legend.hpp"
#include "view/walls.hpp"

namespace percuss::render {
namespace {

/// One pale colour a body: the mesh's lines stay readable on it.
vtkSmartPointer<vtkLookupTable> body_colours(std::size_t bodies) {
    constexpr std::array<Colour, 7> pale{0xdbe6ef, 0xf6e3c5, 0xd3ebe2, 0xf3d9cc,
                                         0xd9eef9, 0xf0dfe8, 0xe6e8ea};
    auto table = vtkSmartPointer<vtkLookupTable>::New();
    table->SetNumberOfTableValues(static_cast<vtkIdType>(std::max<std::size_t>(bodies, 1)));
    for (std::size_t b = 0; b < std::max<std::size_t>(bodies, 1); ++b) {
        const Colour c = pale[b % pale.size()];
        table->SetTableValue(static_cast<vtkIdType>(b), (c >> 16U & 255U) / 255.0, (c >> 8U & 255U) / 255.0,
                             (c & 255U) / 255.0);
    }
    return table;
}

FieldInfo field_of(const Scene& scene, const std::string& name) {
    try {
        return find_field(scene, name);
    } catch (const std::invalid_argument& error) {
        throw RenderError(error.what());
    }
}

double cell_pixels(const Mesh& mesh, const Fit& fit) {
    double area = 0;
    for (const Cell& cell : mesh.cells) {
        const auto at = [&](std::size_t k) { return mesh.nodes[static_cast<std::size_t>(cell[k])]; };
        const auto last = static_cast<std::size_t>(corner_count(cell) - 1);
        const Vec2 a = at(2) - at(0), b = at(last) - at(1);
        area += 0.5 * std::abs(a.x() * b.y() - a.y() * b.x());
    }
    return fit.pixels_per_unit * std::sqrt(area / std::max(1, mesh.cell_count()));
}

}  // namespace

MeshPanel::MeshPanel(const MeshPicture& picture, const Rect& rect, double scale,
                     std::array<double, 2> page_size)
    : picture_(picture),
      rect_(rect),
      model_(rect),
      scale_(scale),
      renderer_(vtkSmartPointer<vtkRenderer>::New()) {
    const Snapshot& snapshot = *picture_.snapshot;
    const Scene& scene = snapshot.setup->scene;
    const Plane plane{picture_.options.up,
                      picture_.options.mirror && scene.geometry == Geometry::axisymmetric};
    model_.height -= panel_title_height(picture_.title, scale);
    model_.y += picture_.room_below * scale;
    model_.height -= picture_.room_below * scale;
    std::array<double, 4> shown = box_around(body_boxes(snapshot, plane));
    if (picture_.options.window) {
        const auto& w = *picture_.options.window;
        const auto a = plane(w[0], w[1]), b = plane(w[2], w[3]);
        shown = {a[0], a[1], b[0], b[1]};
        // A window from the axis outwards shows the mirrored half as well.
        if (plane.mirrored && shown[plane.mirror_axis()] <= 0)
            shown[plane.mirror_axis()] =
                std::min(shown[plane.mirror_axis()], -shown[plane.mirror_axis() + 2]);
    }
    fit_ = fit_box(shown, model_, {4 * scale, 4 * scale});
    // Nothing beyond the window: neighbours show the same part of the model, whatever their rectangles'
    // shapes.
    const auto low = fit_(std::array{shown[0], shown[1]}), high = fit_(std::array{shown[2], shown[3]});
    model_ = {low[0] - 2 * scale, low[1] - 2 * scale, high[0] - low[0] + 4 * scale,
              high[1] - low[1] + 4 * scale};

    renderer_->SetLayer(1);
    renderer_->SetBackground(1, 1, 1);
    renderer_->SetViewport(model_.x / page_size[0], model_.y / page_size[1], model_.right() / page_size[0],
                           model_.top() / page_size[1]);
    vtkCamera* camera = renderer_->GetActiveCamera();
    camera->ParallelProjectionOn();
    const double x = 0.5 * (shown[0] + shown[2]), y = 0.5 * (shown[1] + shown[3]);
    camera->SetFocalPoint(x, y, 0);
    camera->SetPosition(x, y, 10);
    camera->SetViewUp(0, 1, 0);
    camera->SetParallelScale(0.5 * model_.height / fit_.pixels_per_unit);
    camera->SetClippingRange(1, 20);

    surface_ = std::make_unique<Surface>(snapshot.setup->mesh, plane, *renderer_);
    if (picture_.coloured) {
        const FieldInfo field = field_of(scene, picture_.options.field);
        const auto values = field_values(snapshot, field);
        colours_ = make_colour_map(picture_.options.colour_map);
        range_ = colour_range(values, picture_.options, picture_.options.colour_map == "coolwarm",
                              natural_size(*snapshot.setup, field));
        const double half = range_[1] > range_[0] ? 0 : std::max(1.0, std::abs(range_[0]));
        surface_->update(snapshot.position, values, field.per_cell);
        surface_->set_colours(colours_, {range_[0] - half, range_[1] + half});
    } else {
        std::vector<double> body_of_cell;
        const auto& bodies = snapshot.setup->mesh.bodies;
        for (std::size_t b = 0; b < bodies.size(); ++b)
            body_of_cell.insert(body_of_cell.end(),
                                static_cast<std::size_t>(bodies[b].cell_end - bodies[b].cell_begin),
                                static_cast<double>(b));
        colours_ = body_colours(bodies.size());
        surface_->update(snapshot.position, body_of_cell, true);
        surface_->set_colours(colours_, {-0.5, static_cast<double>(bodies.size()) - 0.5});
    }
    const double opacity = std::clamp((cell_pixels(snapshot.setup->mesh, fit_) - 1) / 20, 0.0, 0.7);
    surface_->set_edges(picture_.options.edges && opacity > 0.02, opacity);
    surface_->set_line_widths(2,
                              std::max(2.0, 1.2 * scale));  // two of the page's fine pixels are one of paper
}

void MeshPanel::paint(Canvas& canvas) const {
    const Scene& scene = picture_.snapshot->setup->scene;
    const Plane plane{picture_.options.up,
                      picture_.options.mirror && scene.geometry == Geometry::axisymmetric};
    const double s = scale_;
    canvas.text(rect_.x + 0.5 * rect_.width, rect_.top() - 12 * s, picture_.title,
                {15 * s, ink::text, Align::centre, VerticalAlign::centre, true});
    paint_walls(canvas, scene.walls, plane, fit_, model_, s);
    if (picture_.colour_bar && picture_.coloured) {
        const FieldInfo field = field_of(scene, picture_.options.field);
        const double width = std::min(0.6 * model_.width, 300 * s);
        paint_colour_bar(
            canvas,
            {model_.x, model_.y - MeshPicture::colour_bar_room * s, width, MeshPicture::colour_bar_room * s},
            s, field.title, field.quantity, range_, scene.units, colour_strip(*colours_));
    }
    if (picture_.scale_bar)
        paint_scale_bar(canvas, model_.right(), model_.y - 30 * s, s, fit_.pixels_per_unit, scene.units);
}

}  // namespace percuss::render
