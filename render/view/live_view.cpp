#include "view/live_view.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include <vtkContextActor.h>
#include <vtkContextScene.h>
#include <vtkNew.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkRenderer.h>
#include <vtkTextureObject.h>

#include "context/render_window.hpp"
#include "view/aim.hpp"
#include "view/coloured_mesh.hpp"
#include "view/force_arrows.hpp"
#include "view/force_scale.hpp"
#include "view/ground.hpp"
#include "view/legend.hpp"
#include "view/motion_labels.hpp"
#include "vtk_canvas.hpp"

namespace percuss::render {
namespace {

// Legend: width from which bar, reference arrow and scale bar stand in one row, and how far above the bar the
// arrow stands else. Both at scale 1 [pixels].
constexpr double room_for_arrows = 500, arrows_lift = 50;

}  // namespace

struct LiveView::Impl {
    Impl(Context& context, std::shared_ptr<const RunSetup> run)
        : setup(std::move(run)), window(RenderWindow::make(context, 64, 64, 1)) {
        window->SetNumberOfLayers(2);
        int layer = 0;
        for (vtkRenderer* renderer : {ground.Get(), stage.Get()}) {
            renderer->SetLayer(layer++);
            renderer->SetBackground(1, 1, 1);
            renderer->SetBackgroundAlpha(1);  // ImGui blends what it shows
            window->AddRenderer(renderer);
        }
        ground_ink->painter = [this](Canvas& canvas) {
            paint_ground(canvas, setup->scene, mesh.plane, fit, model, scale);
        };
        ground_actor->GetScene()->AddItem(ground_ink);
        ground->AddActor(ground_actor);
        start_cell_size = mean_cell_size(setup->mesh);
    }
    ~Impl() { window->Finalize(); }
    Impl(const Impl&) = delete;
    Impl& operator=(const Impl&) = delete;

    void apply(ViewOptions chosen, RangeMode wanted_mode);
    void prepare(std::shared_ptr<const Snapshot> snapshot, std::array<int, 2> size, double ink_scale,
                 bool folded);
    void fold(bool wanted);
    void colour();

    std::shared_ptr<const RunSetup> setup;
    ViewOptions options;
    RangeMode mode = RangeMode::frame;
    std::optional<LiveCamera> camera;
    vtkSmartPointer<RenderWindow> window;
    vtkNew<vtkRenderer> ground, stage, overlay;  // walls and axis; mesh; ink, in pictures to be kept
    vtkNew<CanvasItem> ground_ink, overlay_ink;
    vtkNew<vtkContextActor> ground_actor, overlay_actor;
    ColouredMesh mesh;                  // on the stage, which outlives it
    std::optional<ColourRange> widest;  // of all frames since the field was chosen
    double start_cell_size = 0;         // [length]

    // Of the last picture.
    std::shared_ptr<const Snapshot> now;
    std::vector<double> values;
    ColourRange range{};
    Rect model, legend;
    Fit fit;
    double scale = 1, cell_size = 0;
    std::array<int, 2> size{64, 64};
    ForceScaling forces;
    bool arrows_above = false;  // the reference arrow has a row of its own in the legend
    [[nodiscard]] bool shows_forces() const { return options.forces && !setup->scene.contacts.empty(); }
    std::optional<double> fold_at;  // the axis, when the texture has one side of it only [pixels]
};

void LiveView::Impl::apply(ViewOptions chosen, RangeMode wanted_mode) {
    const std::string before = mesh.field.name;
    mesh.apply(setup, chosen, *stage);
    if (mesh.field.name != before) widest.reset();
    options = std::move(chosen);
    mode = wanted_mode;
}

void LiveView::Impl::colour() {
    values = field_values(*now, mesh.field);
    range = colour_range(values, options, options.colour_map == "coolwarm", natural_size(*setup, mesh.field));
    if (mode == RangeMode::all_time) {
        if (widest) range = {std::min(range[0], (*widest)[0]), std::max(range[1], (*widest)[1])};
        widest = range;
    }
    mesh.show(*now, values, range, options.edges, cell_size / scale);
}

/// Where the axis is in sight, only the larger side of it is drawn. Walls are not alike on both sides: their
/// hatches lean.
void LiveView::Impl::fold(bool wanted) {
    fold_at.reset();
    const std::size_t across = mesh.plane.mirror_axis();
    const double from = across == 0 ? model.x : model.y, to = across == 0 ? model.right() : model.top();
    double& at = fit.offset[across];
    const bool folded =
        wanted && mesh.plane.mirrored && setup->scene.walls.empty() && at > from + 1 && at < to - 1;
    if (folded) {
        at = std::round(at);  // pixels come to lie on pixels
        fold_at = at;
    }
    const bool mirror_image = folded && at - from > to - at;
    mesh.surface->set_halves(!mirror_image, !folded || mirror_image);
}

void LiveView::Impl::prepare(std::shared_ptr<const Snapshot> snapshot, std::array<int, 2> wanted_size,
                             double ink_scale, bool folded) {
    now = std::move(snapshot);
    size = {std::max(wanted_size[0], 64), std::max(wanted_size[1], 64)};
    scale = ink_scale;
    window->resize(size[0], size[1]);
    mesh.extent->follow(*now, mesh.plane);
    const double pad = 16 * scale, row = 70 * scale;
    const double width = size[0] - 2 * pad;
    // In a narrow picture that is high the reference arrow stands above the colour bar.
    arrows_above =
        shows_forces() && width <= room_for_arrows * scale && width > 225 * scale && size[1] > 370 * scale;
    const double legend_height = std::min(arrows_above ? row + arrows_lift * scale : row, 0.4 * size[1]);
    legend = {pad, 0, size[0] - 2 * pad, legend_height};
    model = {0, legend_height, static_cast<double>(size[0]), size[1] - legend_height};
    if (camera) {
        fit.pixels_per_unit = camera->pixels_per_unit;
        fit.offset = {model.x + 0.5 * model.width - fit.pixels_per_unit * camera->centre[0],
                      model.y + 0.5 * model.height - fit.pixels_per_unit * camera->centre[1]};
    } else {
        const double s = scale;
        fit = fit_box(mesh.extent->box, model,
                      options.velocities ? std::array{34 * s, 40 * s} : std::array{12 * s, 12 * s});
    }
    forces = make_force_scaling(options, mesh.extent->largest_force, 0.15 * std::min(size[0], size[1]));
    cell_size = fit.pixels_per_unit * start_cell_size;
    fold(folded);
    aim(*stage, fit, model, size);
    colour();
    ground_actor->GetScene()->SetDirty(true);
}

LiveView::LiveView(Context& context, std::shared_ptr<const RunSetup> setup, ViewOptions options)
    : impl_(std::make_unique<Impl>(context, std::move(setup))) {
    impl_->apply(std::move(options), RangeMode::frame);
}

LiveView::~LiveView() = default;

void LiveView::show(std::shared_ptr<const RunSetup> setup, const ViewOptions& options) {
    if (const std::string fault = fault_of_field(setup->scene, "field", options.field); !fault.empty())
        throw RenderError(fault);
    impl_->setup = std::move(setup);
    impl_->now.reset();
    impl_->mesh.surface.reset();
    impl_->widest.reset();
    impl_->start_cell_size = mean_cell_size(impl_->setup->mesh);
    impl_->apply(options, impl_->mode);
}

void LiveView::set_options(const ViewOptions& options, RangeMode mode) { impl_->apply(options, mode); }
void LiveView::set_camera(std::optional<LiveCamera> camera) { impl_->camera = camera; }

unsigned LiveView::draw(std::shared_ptr<const Snapshot> snapshot, std::array<int, 2> size, double scale) {
    impl_->prepare(std::move(snapshot), size, scale, true);
    impl_->overlay->DrawOff();
    RenderWindow& window = *impl_->window;
    window.Render();
    return window.GetDisplayFramebuffer()->GetColorAttachmentAsTextureObject(0)->GetHandle();
}

std::vector<LivePart> LiveView::parts() const {
    const std::array<double, 2> size{static_cast<double>(impl_->size[0]),
                                     static_cast<double>(impl_->size[1])};
    if (!impl_->fold_at) return {{{0, 0, size[0], size[1]}}};
    const std::size_t across = impl_->mesh.plane.mirror_axis();
    const Rect& model = impl_->model;
    const double from = across == 0 ? model.x : model.y, to = across == 0 ? model.right() : model.top();
    const double axis = *impl_->fold_at;
    const bool low_drawn = axis - from > to - axis;
    // What lies beside the model is as it was drawn.
    const double begin = low_drawn ? axis : from, end = low_drawn ? to : axis;
    std::vector<LivePart> parts;
    const auto part = [&](double low, double high, double source_low, double source_high) {
        if (high <= low) return;
        LivePart made{{0, 0, size[0], size[1]}};
        (across == 0 ? made.place.x : made.place.y) = low;
        (across == 0 ? made.place.width : made.place.height) = high - low;
        made.low[across] = source_low / size[across];
        made.high[across] = source_high / size[across];
        parts.push_back(made);
    };
    part(0, begin, 0, begin);
    part(begin, end, 2 * axis - begin, 2 * axis - end);
    part(end, size[across], end, size[across]);
    return parts;
}

Image LiveView::picture(std::shared_ptr<const Snapshot> snapshot, std::array<int, 2> size, double scale,
                        const std::function<void(Canvas&)>& ink) {
    Impl& view = *impl_;
    if (!view.overlay_ink->painter) {  // the first picture
        view.window->SetNumberOfLayers(3);
        view.overlay->SetLayer(2);
        view.overlay_actor->GetScene()->AddItem(view.overlay_ink);
        view.overlay->AddActor(view.overlay_actor);
        view.window->AddRenderer(view.overlay);
    }
    view.overlay_ink->painter = ink;
    view.prepare(std::move(snapshot), size, scale, false);
    view.overlay_actor->GetScene()->SetDirty(true);
    view.overlay->DrawOn();
    Image image = view.window->grab();
    view.overlay_ink->painter = [](Canvas&) {};
    return image;
}

void LiveView::take_scales(const LiveView& other) { impl_->mesh.extent = other.impl_->mesh.extent; }

void LiveView::paint(Canvas& canvas, std::vector<Rect> corners) const {
    const Impl& view = *impl_;
    const Scene& scene = view.setup->scene;
    const double s = view.scale;
    const Rect& legend = view.legend;
    // What has no room is left out, the reference arrow first.
    const bool arrows = view.shows_forces() && legend.width > room_for_arrows * s;
    const bool length = legend.width > 300 * s;
    const double column = std::min(
        {420 * s, arrows ? 0.36 * legend.width : 0.6 * legend.width, legend.width - (arrows ? 380 * s : 0)});
    paint_colour_bar(canvas, {legend.x, legend.y, column, legend.height}, s, view.mesh.field.title,
                     view.mesh.field.quantity, view.range, scene.units, view.mesh.strip);
    if (arrows || view.arrows_above) {
        const double x = view.arrows_above ? legend.x : legend.x + column + 28 * s,
                     y = view.arrows_above ? legend.y + arrows_lift * s : legend.y;
        paint_force_legend(canvas, {x, y, 0, legend.height}, s, view.forces, scene.units);
    }
    if (length)
        paint_scale_bar(canvas, legend.right(), legend.y + 32.5 * s, s, view.fit.pixels_per_unit,
                        scene.units);
    std::vector<Rect> taken;
    if (view.options.forces)
        taken = paint_force_arrows(canvas, *view.now, view.mesh.plane, view.fit, view.model, view.forces,
                                   view.cell_size, s);
    // In the upper right corner whoever shows the view writes the time.
    corners.push_back({view.model.right() - 160 * s, view.model.top() - 36 * s, 160 * s, 36 * s});
    if (view.options.velocities)
        paint_motion(canvas, *view.now, view.mesh.plane, view.fit, view.model, s, view.mesh.extent->fastest,
                     0.1 * std::min(view.size[0], view.size[1]), std::move(taken), std::move(corners));
}

const Fit& LiveView::fit() const { return impl_->fit; }
const Rect& LiveView::model() const { return impl_->model; }
ColourRange LiveView::range() const { return impl_->range; }
const Plane& LiveView::plane() const { return impl_->mesh.plane; }
const FieldInfo& LiveView::field() const { return impl_->mesh.field; }
double LiveView::force_reference() const { return impl_->forces.reference; }
double LiveView::value(std::size_t index) const { return impl_->values[index]; }

LiveCamera LiveView::camera() const {
    const Fit& fit = impl_->fit;
    const Rect& model = impl_->model;
    return {{(model.x + 0.5 * model.width - fit.offset[0]) / fit.pixels_per_unit,
             (model.y + 0.5 * model.height - fit.offset[1]) / fit.pixels_per_unit},
            fit.pixels_per_unit};
}

LiveCamera LiveView::around(const std::array<double, 4>& box) const {
    const double s = impl_->scale;
    const Fit fitted = fit_box(box, impl_->model, {30 * s, 30 * s});
    return {{0.5 * (box[0] + box[2]), 0.5 * (box[1] + box[3])}, fitted.pixels_per_unit};
}

}  // namespace percuss::render
