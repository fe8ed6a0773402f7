#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "workbench/export/picture_stream.hpp"
#include "workbench/export/view_copy.hpp"

namespace percuss::app {

/// A film or a sequence of pictures of the run so far, from its kept moments: one picture a frame of the
/// window, which stays alive; the run may go on, be reset or built anew meanwhile.
class MomentsFilm {
  public:
    /// @param times of the pictures [time]. @throws render::RenderError.
    MomentsFilm(Workbench& w, std::filesystem::path target, std::vector<double> times,
                std::array<int, 2> size, double frames_per_second);

    /// Draws the next picture, when there is room for it and its moment has been read. @throws
    /// render::RenderError.
    void advance(const Workbench& w);
    [[nodiscard]] double progress() const;  ///< 0 to 1
    PictureStream stream;

  private:
    ViewCopy view_;
    std::function<std::shared_ptr<const Snapshot>(double time)> moments_;
    std::shared_ptr<const Snapshot> newest_;  // of a run that goes on; null of a recorded one
    std::vector<double> times_;
    std::size_t next_ = 0;
    std::shared_ptr<const Snapshot> drawn_;
    render::Image image_;  // of `drawn_`
};

}  // namespace percuss::app
