#pragma once

#include <array>
#include <memory>

#include "image.hpp"
#include "view/live_view.hpp"
#include "workbench/workbench.hpp"

namespace percuss::app {

/// Draws moments of a run as the viewport shows the present one: its camera, field, colours and arrows, in
/// another size.
class ViewCopy {
  public:
    /// Of the viewport as it is now, which must have been drawn. @param size [pixels]: what the viewport
    /// shows is fitted into it. @throws render::RenderError.
    ViewCopy(Workbench& w, std::array<int, 2> size);
    [[nodiscard]] const std::shared_ptr<const RunSetup>& setup() const { return setup_; }
    /// @param moment of the same run. @throws render::RenderError.
    [[nodiscard]] render::Image draw(const Workbench& w, const std::shared_ptr<const Snapshot>& moment);

  private:
    std::shared_ptr<const RunSetup> setup_;
    std::array<int, 2> size_;
    double scale_;
    std::unique_ptr<render::LiveView> view_;
    render::LiveCamera camera_;
};

}  // namespace percuss::app
