#pragma once

#include <memory>

namespace percuss::render {

/// An OpenGL context that pictures are drawn in. Must outlive what is drawn in it; used from one thread.
class Context {
  public:
    virtual ~Context() = default;
    virtual void make_current() = 0;
    [[nodiscard]] virtual bool is_current() const = 0;
};

/// A true OSMesa context: no display, no GPU, libOSMesa loaded at this call.
/// @throws RenderError saying which library or symbol is missing and which package holds it.
[[nodiscard]] std::unique_ptr<Context> make_offscreen_context(int width = 16, int height = 16);

}  // namespace percuss::render
