#include "view/aim.hpp"

#include <vtkCamera.h>

namespace percuss::render {

void aim(vtkRenderer& renderer, const Fit& fit, const Rect& area, const std::array<int, 2>& size) {
    const double width = size[0], height = size[1];
    renderer.SetViewport(area.x / width, area.y / height, area.right() / width, area.top() / height);
    const double x = (area.x + 0.5 * area.width - fit.offset[0]) / fit.pixels_per_unit;
    const double y = (area.y + 0.5 * area.height - fit.offset[1]) / fit.pixels_per_unit;
    vtkCamera* camera = renderer.GetActiveCamera();
    camera->ParallelProjectionOn();
    camera->SetFocalPoint(x, y, 0);
    camera->SetPosition(x, y, 10);
    camera->SetViewUp(0, 1, 0);
    camera->SetParallelScale(0.5 * area.height / fit.pixels_per_unit);
    camera->SetClippingRange(1, 20);
}

}  // namespace percuss::render
