#include "workbench/export/view_copy.hpp"

#include <algorithm>

#include "workbench/viewport_actions.hpp"
#include "workbench/viewport_ink.hpp"

namespace percuss::app {

ViewCopy::ViewCopy(Workbench& w, std::array<int, 2> size) : setup_(w.viewport.setup), size_(size) {
    const ViewportState& shown = w.viewport;
    ViewOptions options = shown.options;
    // Over all time: what the screen has come to, from the first picture on.
    if (shown.range_mode == render::RangeMode::all_time) options.range = shown.view->range();
    view_ = std::make_unique<render::LiveView>(w.screen.context(), setup_, options);
    view_->take_scales(*shown.view);
    const double factor = std::min(static_cast<double>(size[0]) / shown.drawn_size[0],
                                   static_cast<double>(size[1]) / shown.drawn_size[1]);
    scale_ = factor * w.screen.scale();
    camera_ = shown.view->camera();
    camera_.pixels_per_unit *= factor;
    view_->set_camera(camera_);
}

render::Image ViewCopy::draw(const Workbench& w, const std::shared_ptr<const Snapshot>& moment) {
    if (const auto centre = centre_after_node(w, *moment)) {
        camera_.centre = *centre;
        view_->set_camera(camera_);
    }
    return view_->picture(moment, size_, scale_, [&](render::Canvas& canvas) {
        paint_beneath(w, *view_, moment, scale_, canvas);
        view_->paint(canvas, places_of_words(w, *view_, moment, scale_, canvas));
        paint_above(w, *view_, moment, scale_, canvas);
    });
}

}  // namespace percuss::app
