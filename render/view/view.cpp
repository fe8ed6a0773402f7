#include "view/view.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include <fmt/format.h>
#include <vtkContextActor.h>
#include <vtkContextScene.h>
#include <vtkNew.h>
#include <vtkRenderer.h>

#include "context/render_window.hpp"
#include "figures/plot.hpp"
#include "run/fields.hpp"
#include "view/aim.hpp"
#include "view/colour_range.hpp"
#include "view/coloured_mesh.hpp"
#include "view/force_arrows.hpp"
#include "view/force_scale.hpp"
#include "view/ground.hpp"
#include "view/layout.hpp"
#include "view/legend.hpp"
#include "view/motion_labels.hpp"
#include "view/side_charts.hpp"
#include "vtk_canvas.hpp"

namespace percuss::render {

struct View::Impl {
    Impl(Context& context, std::shared_ptr<const RunSetup> run, ViewOptions chosen);
    ~Impl() { window->Finalize(); }
    Impl(const Impl&) = delete;
    Impl& operator=(const Impl&) = delete;

    void apply_options(ViewOptions chosen);
    Image draw(const Snapshot& snapshot, const History* history);
    void colour(const Snapshot& snapshot);
    void show_charts(const Snapshot& snapshot, const History* history);
    void paint_overlay(Canvas& canvas) const;
    void paint_title(Canvas& canvas) const;

    std::shared_ptr<const RunSetup> setup;
    ViewOptions options;
    double start_cell_size = 0;  // side of a mean cell of the undeformed mesh [length]
    vtkSmartPointer<RenderWindow> window;
    vtkNew<vtkRenderer> ground, stage, overlay;  // axis line; mesh, clipped to its rectangle; ink and charts
    vtkNew<CanvasItem> ground_ink, overlay_ink;
    vtkNew<vtkContextActor> ground_actor, overlay_actor;
    ColouredMesh mesh;  // on the stage, which outlives it
    std::vector<std::unique_ptr<Plot>> plots;

    // Of the picture being drawn.
    const Snapshot* now = nullptr;
    ColourRange range{};
    Layout layout;
    Fit fit;
    double cell_size = 0;  // [pixels]
    ForceScaling forces;
};

View::Impl::Impl(Context& context, std::shared_ptr<const RunSetup> run, ViewOptions chosen)
    : setup(std::move(run)), window(RenderWindow::make(context, chosen.size[0], chosen.size[1], 1)) {
    window->SetNumberOfLayers(3);
    int layer = 0;
    for (vtkRenderer* renderer : {ground.Get(), stage.Get(), overlay.Get()}) {
        renderer->SetLayer(layer++);
        renderer->SetBackground(1, 1, 1);
        renderer->SetBackgroundAlpha(1);
        window->AddRenderer(renderer);
    }
    ground_ink->painter = [this](Canvas& canvas) {
        paint_ground(canvas, setup->scene, mesh.plane, fit, layout.model, layout.scale);
    };
    overlay_ink->painter = [this](Canvas& canvas) { paint_overlay(canvas); };
    ground_actor->GetScene()->AddItem(ground_ink);
    overlay_actor->GetScene()->AddItem(overlay_ink);
    ground->AddActor(ground_actor);
    overlay->AddActor(overlay_actor);
    start_cell_size = mean_cell_size(setup->mesh);
    apply_options(std::move(chosen));
}

void View::Impl::apply_options(ViewOptions chosen) {
    if (chosen.size[0] < 64 || chosen.size[1] < 64)
        throw RenderError("a picture needs at least 64 x 64 pixels");
    mesh.apply(setup, chosen, *stage);
    options = std::move(chosen);
    window->resize(options.size[0], options.size[1]);
}

void View::Impl::colour(const Snapshot& snapshot) {
    const std::vector<double> values = field_values(snapshot, mesh.field);
    range = colour_range(values, options, options.colour_map == "coolwarm", natural_size(*setup, mesh.field));
    mesh.show(snapshot, values, range, options.edges, cell_size / layout.scale);
}

void View::Impl::show_charts(const Snapshot& snapshot, const History* history) {
    while (plots.size() < layout.charts.size())
        plots.push_back(std::make_unique<Plot>(*overlay_actor->GetScene(), true));
    for (auto& plot : plots) plot->hide();
    if (layout.charts.empty()) return;
    const DisplayUnit time = setup->scene.units.display(Quantity::time, setup->scene.duration);
    for (std::size_t i = 0; i < layout.charts.size(); ++i) {
        try {
            const Chart chart =
                make_side_chart(options.charts[i], setup->scene, *history, snapshot.time, time);
            plots[i]->show(chart, layout.charts[i], layout.scale, time.scale * snapshot.time);
        } catch (const std::invalid_argument& error) {
            throw RenderError(error.what());
        }
    }
}

Image View::Impl::draw(const Snapshot& snapshot, const History* history) {
    now = &snapshot;
    mesh.extent->follow(snapshot, mesh.plane);
    std::array<double, 4> shown = mesh.extent->box;
    if (options.window) {
        const auto& chosen = *options.window;
        const auto a = mesh.plane(chosen[0], chosen[1]), b = mesh.plane(chosen[2], chosen[3]);
        shown = {a[0], a[1], b[0], b[1]};
    }
    const bool charts = history != nullptr && history->rows() > 0;
    layout = make_layout(options.size[0], options.size[1],
                         (shown[2] - shown[0]) / std::max(shown[3] - shown[1], 1e-300),
                         charts ? options.charts.size() : 0);
    const double s = layout.scale;
    // Room for the velocity labels around the bodies; a window of one's own is filled.
    const bool labels = options.velocities && !options.window;
    fit = fit_box(shown, layout.model, labels ? std::array{34 * s, 40 * s} : std::array{8 * s, 8 * s});
    forces = make_force_scaling(options, mesh.extent->largest_force, 0.13 * options.size[1]);
    cell_size = fit.pixels_per_unit * start_cell_size;
    aim(*stage, fit, layout.model, options.size);
    colour(snapshot);
    show_charts(snapshot, charts ? history : nullptr);
    ground_actor->GetScene()->SetDirty(true);
    overlay_actor->GetScene()->SetDirty(true);
    Image image = window->grab();
    now = nullptr;
    return image;
}

void View::Impl::paint_title(Canvas& canvas) const {
    const Scene& scene = setup->scene;
    const double s = layout.scale, y = layout.title.y + 0.5 * layout.title.height;
    // One unit for a whole run: "t = 0.4 µs" and "t = 380 ns" in one film would confuse.
    const DisplayUnit unit = scene.units.display(Quantity::time, std::max(scene.duration, now->time));
    const double largest = unit.scale * std::max(scene.duration, now->time);
    const int decimals =
        largest > 0 ? std::clamp(2 - static_cast<int>(std::floor(std::log10(largest))), 0, 6) : 1;
    const std::string time = fmt::format("t = {:.{}f} {}", unit.scale * now->time, decimals, unit.label);
    const TextStyle style{20 * s, ink::text, Align::right, VerticalAlign::centre, true};
    canvas.text(layout.title.right(), y, time, style);
    const double room = layout.title.width - canvas.text_size(time, style)[0] - 30 * s;
    TextStyle title{20 * s, ink::text};
    const double width = canvas.text_size(scene.title, title)[0];
    if (width > room) title.size *= std::max(room / width, 0.4);
    canvas.text(layout.title.x, y, scene.title, title);
    if (now->status == RunStatus::diverged && !now->message.empty())
        canvas.text(layout.title.x, y - 24 * s, now->message, {14 * s, 0xb00020});
}

void View::Impl::paint_overlay(Canvas& canvas) const {
    const Scene& scene = setup->scene;
    const double s = layout.scale;
    paint_title(canvas);
    const Rect& legend = layout.legend;
    const double column = std::min(0.36 * legend.width, 420 * s);
    paint_colour_bar(canvas, {legend.x, legend.y, column, legend.height}, s, mesh.field.title,
                     mesh.field.quantity, range, scene.units, mesh.strip);
    if (options.forces && !scene.contacts.empty())
        paint_force_legend(canvas, {legend.x + column + 44 * s, legend.y, 0, legend.height}, s, forces,
                           scene.units);
    paint_scale_bar(canvas, legend.right(), legend.y + 32.5 * s, s, fit.pixels_per_unit, scene.units);
    std::vector<Rect> taken;
    if (options.forces)
        taken = paint_force_arrows(canvas, *now, mesh.plane, fit, layout.model, forces, cell_size, s);
    if (options.velocities)
        paint_motion(canvas, *now, mesh.plane, fit, layout.model, s, mesh.extent->fastest,
                     0.09 * options.size[1], std::move(taken));
}

View::View(Context& context, std::shared_ptr<const RunSetup> setup, ViewOptions options)
    : impl_(std::make_unique<Impl>(context, std::move(setup), std::move(options))) {}

View::~View() = default;

Image View::draw(const Snapshot& snapshot, const History* history) { return impl_->draw(snapshot, history); }

void View::set_options(const ViewOptions& options) { impl_->apply_options(options); }

}  // namespace percuss::render
