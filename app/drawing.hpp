#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "context/context.hpp"
#include "film.hpp"
#include "run/history.hpp"
#include "run/snapshot.hpp"
#include "view/view.hpp"

namespace percuss::app {

/// Where pictures go; either may be absent, not both.
struct DrawingTargets {
    std::optional<std::filesystem::path> folder;  ///< numbered PNGs
    std::optional<std::filesystem::path> film;    ///< mp4
};

/// Draws snapshots off screen into numbered PNGs and a film. Used from one thread: it owns an OpenGL context.
class Drawing {
  public:
    /// Makes the folder and the context, and starts ffmpeg. @throws render::RenderError.
    Drawing(std::shared_ptr<const RunSetup> setup, const ViewOptions& options, DrawingTargets targets);
    ~Drawing();  ///< takes a film away that was not finished
    Drawing(const Drawing&) = delete;
    Drawing& operator=(const Drawing&) = delete;

    void add(const Snapshot& snapshot, const History* history, long long index);
    /// Completes the film. @throws render::RenderError.
    void finish();

  private:
    DrawingTargets targets_;
    std::filesystem::path film_aside_;
    std::unique_ptr<render::Context> context_;
    std::unique_ptr<render::View> view_;  // drawn in the context: goes before it
    std::unique_ptr<render::Film> film_;
};

/// @throws UsageError when `film` exists and may not be replaced, or is no .mp4.
void check_film(const std::filesystem::path& film, bool force);

}  // namespace percuss::app
