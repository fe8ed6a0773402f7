#pragma once

#include <memory>
#include <string>

#include "workbench/workbench.hpp"

namespace percuss::app {

// What the workbench paints over a mesh that was drawn, on the screen, in films and in pictures alike.
// @param scale of ink: 1 is text of 15 pixels.

/// LiveView::paint and, under its arrows and labels, outlines of the reference and of the design before and a
/// failed element; above them contact surfaces and probes; the time in the upper right corner; in the left
/// one which of several runs it is and whose outlines they are.
void paint_ink(const Workbench& w, const render::LiveView& view, const std::shared_ptr<const Snapshot>& shown,
               double scale, render::Canvas& canvas);
/// The same of a run beside: LiveView::paint, the time, and which run it is.
void paint_ink_beside(const render::LiveView& view, const Snapshot& shown, const std::string& words,
                      double scale, render::Canvas& canvas);

}  // namespace percuss::app
