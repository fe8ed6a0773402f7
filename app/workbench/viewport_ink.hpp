#pragma once

#include <memory>
#include <vector>

#include "workbench/workbench.hpp"

namespace percuss::app {

// What the workbench paints over the mesh beside LiveView::paint, on the screen, in films and in pictures
// alike.
// @param scale of ink: 1 is text of 15 pixels.

/// Outlines of the reference and of the design before, and a failed element, under arrows and labels.
void paint_beneath(const Workbench& w, const render::LiveView& view,
                   const std::shared_ptr<const Snapshot>& shown, double scale, render::Canvas& canvas);
/// In the upper right corner.
void write_time(const render::LiveView& view, const Snapshot& shown, double scale, render::Canvas& canvas);
/// Which of several runs it is, in the upper left corner.
void write_label(const render::LiveView& view, const std::string& label, double scale,
                 render::Canvas& canvas);
/// Where paint_above writes whose outlines they are, for LiveView::paint.
[[nodiscard]] std::vector<render::Rect> places_of_words(const Workbench& w, const render::LiveView& view,
                                                        const std::shared_ptr<const Snapshot>& shown,
                                                        double scale, render::Canvas& canvas);
/// Contact surfaces and probes; the time, in the upper right corner; in the left one whose outlines they are.
void paint_above(const Workbench& w, const render::LiveView& view,
                 const std::shared_ptr<const Snapshot>& shown, double scale, render::Canvas& canvas);

}  // namespace percuss::app
