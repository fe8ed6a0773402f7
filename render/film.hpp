#pragma once

#include <filesystem>
#include <memory>

#include "image.hpp"

namespace percuss::render {

/// Pipes pictures to ffmpeg (no shell in between) into an H.264 mp4.
class Film {
  public:
    /// @throws RenderError when ffmpeg is missing ("install the package ffmpeg") or cannot be started.
    Film(const std::filesystem::path& file, int width, int height, double frames_per_second);
    ~Film();
    void add(const Image& image);
    /// Waits for ffmpeg. @throws RenderError with ffmpeg's last words when it failed.
    void finish();

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace percuss::render
