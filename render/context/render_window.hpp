#pragma once

#include <cstdint>
#include <vector>

#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkSmartPointer.h>

#include "context/context.hpp"
#include "image.hpp"

namespace percuss::render {

/// VTK's window for a context that somebody else owns: OSMesa without a display, GLFW with one. VTK draws
/// into a framebuffer object of its own, whatever the context's size.
class RenderWindow : public vtkGenericOpenGLRenderWindow {
  public:
    static RenderWindow* New();
    vtkTypeMacro(RenderWindow, vtkGenericOpenGLRenderWindow)
        /// A window that is ready to render. @param samples VTK draws `samples` times wider and higher and
        /// grab() averages the pixels; 1 smooths lines only (+5 ms a frame of 5,000 quads where 2 costs +30,
        /// FXAA +50, multisampling +90 on llvmpipe), so shapes should carry an outline.
        static vtkSmartPointer<RenderWindow> make(Context& context, int width, int height, int samples);

    void MakeCurrent() override;
    bool IsCurrent() override;
    int SupportsOpenGL() override { return 1; }
    void Start() override;
    void Frame() override;

    void resize(int width, int height);
    /// Renders and copies the picture out: width x height pixels.
    [[nodiscard]] Image grab();

  protected:
    RenderWindow() = default;
    void OpenGLInitContext() override;

  private:
    RenderWindow(const RenderWindow&) = delete;
    RenderWindow& operator=(const RenderWindow&) = delete;
    Context* context_ = nullptr;
    int width_ = 0, height_ = 0, samples_ = 1;  // of the grabbed picture
    bool grabbing_ = false;
    std::vector<std::uint8_t> rgba_;
};

}  // namespace percuss::render
