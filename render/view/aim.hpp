#pragma once

#include <array>

#include <vtkRenderer.h>

#include "view/layout.hpp"

namespace percuss::render {

/// Points a renderer's camera so that the model lies in `area` as `fit` says. @param size of the picture
/// [pixels]
void aim(vtkRenderer& renderer, const Fit& fit, const Rect& area, const std::array<int, 2>& size);

}  // namespace percuss::render
