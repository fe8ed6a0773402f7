#pragma once

#include "workbench/workbench.hpp"

namespace percuss::app {

// Parts of the viewport, one file each.

void show_place_menu(Workbench& workbench);  ///< what can be done where the picture was clicked, once opened
void show_values_under_mouse(const Workbench& workbench);

}  // namespace percuss::app
