#pragma once

#include <array>
#include <memory>
#include <string>

struct GLFWwindow;

namespace percuss::render {

/// An OpenGL context that pictures are drawn in. Must outlive what is drawn in it; used from one thread.
class Context {
  public:
    virtual ~Context() = default;
    virtual void make_current() = 0;
    [[nodiscard]] virtual bool is_current() const = 0;
};

/// A window on the display, with a context of its own.
class WindowContext : public Context {
  public:
    [[nodiscard]] virtual GLFWwindow* window() = 0;
    [[nodiscard]] virtual std::array<int, 2> size() const = 0;  ///< [pixels]
};

/// @throws RenderError saying why, e.g. that there is no display.
[[nodiscard]] std::unique_ptr<WindowContext> make_window_context(const std::string& title, int width,
                                                                 int height);

/// A picture in memory, with a context of its own.
class OffscreenContext : public Context {
  public:
    /// What was drawn is lost. @throws RenderError.
    virtual void resize(int width, int height) = 0;
};

/// A true OSMesa context: no display, no GPU, libOSMesa loaded at this call. VTK draws into framebuffers of
/// its own, whatever the size; a user interface needs the size at which it is shown.
/// @throws RenderError saying which library or symbol is missing and which package holds it.
[[nodiscard]] std::unique_ptr<OffscreenContext> make_offscreen_context(int width = 16, int height = 16);

}  // namespace percuss::render
