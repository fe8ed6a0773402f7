#include "figures/figure.hpp"

#include <algorithm>
#include <memory>

#include <vtkContextActor.h>
#include <vtkContextScene.h>
#include <vtkNew.h>
#include <vtkRenderer.h>

#include "vtk_canvas.hpp"
#include "context/render_window.hpp"
#include "figures/plot.hpp"

namespace percuss::render {

Image draw_figure(Context& context, const Figure& figure) {
    if (figure.width < 100 || figure.height < 100 || figure.columns < 1)
        throw RenderError("a figure needs at least one column and 100 x 100 pixels");
    constexpr int samples = 2;
    const auto window = RenderWindow::make(context, figure.width, figure.height, samples);
    vtkNew<vtkRenderer> renderer;
    renderer->SetBackground(1, 1, 1);
    window->AddRenderer(renderer);
    vtkNew<vtkContextActor> actor;
    renderer->AddActor(actor);
    vtkContextScene* scene = actor->GetScene();
    scene->SetRenderer(renderer);

    const double width = samples * figure.width, height = samples * figure.height;
    const auto count = static_cast<int>(figure.charts.size());
    const int columns = std::max(1, std::min(figure.columns, count));
    const int rows = std::max(1, (count + columns - 1) / columns);
    // Type of one size for a page: 1 is right for a chart of 640 x 400 pixels.
    const double scale = std::clamp(std::min(width / columns / 640, height / rows / 400), 0.5, 3.0);
    const double pad = 20 * scale, top = figure.title.empty() ? pad : 48 * scale;
    vtkNew<CanvasItem> title;
    title->painter = [&](Canvas& canvas) {
        canvas.text(pad, height - 0.5 * top, figure.title,
                    {20 * scale, ink::text, Align::left, VerticalAlign::centre, true});
    };
    scene->AddItem(title);

    const double each_width = (width - (columns + 1) * pad) / columns;
    const double each_height = (height - top - rows * pad) / rows;
    std::vector<std::unique_ptr<Plot>> plots;
    for (int i = 0; i < count; ++i) {
        const Rect rect{pad + (i % columns) * (each_width + pad),
                        height - top - (i / columns + 1) * each_height - (i / columns) * pad, each_width,
                        each_height};
        plots.push_back(std::make_unique<Plot>(*scene, false));
        plots.back()->show(figure.charts[static_cast<std::size_t>(i)], rect, scale);
    }
    Image image = window->grab();
    window->Finalize();
    return image;
}

}  // namespace percuss::render
