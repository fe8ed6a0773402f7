#pragma once

#include "context/context.hpp"
#include "image.hpp"

namespace percuss::render {

/// A picture that ImGui can show.
class Texture {
  public:
    Texture(Context& context, const Image& image);
    ~Texture();
    Texture(const Texture&) = delete;
    Texture& operator=(const Texture&) = delete;

    [[nodiscard]] unsigned name() const { return name_; }  ///< OpenGL's; first row on top
    [[nodiscard]] int width() const { return width_; }
    [[nodiscard]] int height() const { return height_; }

  private:
    Context& context_;
    unsigned name_ = 0;
    int width_ = 0, height_ = 0;
};

}  // namespace percuss::render
