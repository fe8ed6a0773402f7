#pragma once

#include "workbench/panels/panel.hpp"

struct ImDrawList;

namespace percuss::app {

// Parts of the viewport, one file each.

/// The runs beside the one that is shown, each in its part of the viewport. @param areas one a run
void show_beside(Workbench& workbench, const std::vector<PanelArea>& areas);
/// Parts of the viewport for so many runs, the first for the one that is shown: beside or above each other,
/// as they are less narrow.
[[nodiscard]] std::vector<PanelArea> viewport_parts(const PanelArea& area, std::size_t count);
/// The mesh that a view has drawn for an area, with its mirror image. @param texture of the view's last
/// draw()
void draw_picture(const render::LiveView& view, unsigned texture, const PanelArea& area, ImDrawList& ink);
void show_place_menu(Workbench& workbench);  ///< what can be done where the picture was clicked, once opened
void show_values_under_mouse(const Workbench& workbench);

}  // namespace percuss::app
