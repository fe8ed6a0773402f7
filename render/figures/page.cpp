#include "figures/page.hpp"

#include <algorithm>
#include <memory>

#include <vtkContextActor.h>
#include <vtkContextScene.h>
#include <vtkNew.h>
#include <vtkRenderer.h>

#include "context/render_window.hpp"
#include "figures/panels.hpp"
#include "figures/plot.hpp"
#include "vtk_canvas.hpp"

namespace percuss::render {
namespace {

template <class... Handlers>
struct Overloaded : Handlers... {
    using Handlers::operator()...;
};

}  // namespace

Image draw_page(Context& context, const Page& page) {
    if (page.width < 100 || page.height < 100) throw RenderError("a page needs at least 100 x 100 pixels");
    constexpr int samples = 2;
    const auto window = RenderWindow::make(context, page.width, page.height, samples);
    window->SetNumberOfLayers(3);
    const double width = samples * page.width, height = samples * page.height, scale = samples * page.type;
    // Charts and painted panels; meshes, each clipped to its rectangle; ink upon meshes.
    vtkNew<vtkRenderer> ground, overlay;
    vtkNew<vtkContextActor> ground_actor, overlay_actor;
    for (const auto& [renderer, actor, layer] : {std::tuple{ground.Get(), ground_actor.Get(), 0},
                                                 std::tuple{overlay.Get(), overlay_actor.Get(), 2}}) {
        renderer->SetLayer(layer);
        renderer->SetBackground(1, 1, 1);
        renderer->AddActor(actor);
        actor->GetScene()->SetRenderer(renderer);
    }
    window->AddRenderer(ground);

    std::vector<vtkSmartPointer<CanvasItem>> items;
    const auto paint_on = [&](vtkContextScene& scene, std::function<void(Canvas&)> painter) {
        items.push_back(vtkSmartPointer<CanvasItem>::New());
        items.back()->painter = std::move(painter);
        scene.AddItem(items.back());
    };
    const double pad = 14 * scale, top = page.title.empty() ? pad : 48 * scale;
    paint_on(*ground_actor->GetScene(), [&page, pad, top, height, scale](Canvas& canvas) {
        canvas.text(pad, height - 0.5 * top, page.title,
                    {20 * scale, ink::text, Align::left, VerticalAlign::centre, true});
    });

    std::vector<std::unique_ptr<Plot>> plots;
    std::vector<std::unique_ptr<MeshPanel>> meshes;
    for (const Page::Placed& placed : page.panels) {
        const auto& [left, from_top, part_wide, part_high] = placed.place;
        const Rect whole{pad, pad, width - 2 * pad, height - pad - top};
        Rect rect{whole.x + left * whole.width, whole.top() - (from_top + part_high) * whole.height,
                  part_wide * whole.width, part_high * whole.height};
        // Neighbours keep their distance.
        rect = {rect.x + 0.4 * pad, rect.y + 0.4 * pad, rect.width - 0.8 * pad, rect.height - 0.8 * pad};
        vtkContextScene& scene = *ground_actor->GetScene();
        std::visit(
            Overloaded{
                [&](const Chart& chart) {
                    plots.push_back(std::make_unique<Plot>(scene, false));
                    plots.back()->show(chart, rect, scale);
                },
                [&](const HeatMap& map) {
                    paint_on(scene, [&map, rect, scale](Canvas& c) { paint_heat_map(c, map, rect, scale); });
                },
                [&](const StackedAreas& areas) {
                    paint_on(scene, [&areas, rect, scale](Canvas& c) { paint_areas(c, areas, rect, scale); });
                },
                [&](const Bars& bars) {
                    paint_on(scene, [&bars, rect, scale](Canvas& c) { paint_bars(c, bars, rect, scale); });
                },
                [&](const Table& table) {
                    paint_on(scene, [&table, rect, scale](Canvas& c) { paint_table(c, table, rect, scale); });
                },
                [&](const Scatter& scatter) {
                    paint_on(scene,
                             [&scatter, rect, scale](Canvas& c) { paint_scatter(c, scatter, rect, scale); });
                },
                [&](const MeshPicture& picture) {
                    meshes.push_back(
                        std::make_unique<MeshPanel>(picture, rect, scale, std::array{width, height}));
                    window->AddRenderer(meshes.back()->renderer());
                    const MeshPanel* mesh = meshes.back().get();
                    paint_on(*overlay_actor->GetScene(), [mesh](Canvas& c) { mesh->paint(c); });
                }},
            placed.panel);
    }
    window->AddRenderer(overlay);
    Image image = window->grab();
    window->Finalize();
    return image;
}

}  // namespace percuss::render
