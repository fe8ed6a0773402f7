#include <GL/glew.h>
//
#include <fmt/format.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLState.h>

#include "context/render_window.hpp"

namespace percuss::render {

vtkStandardNewMacro(RenderWindow)

    vtkSmartPointer<RenderWindow> RenderWindow::make(Context& context, int width, int height, int samples) {
    auto window = vtkSmartPointer<RenderWindow>::New();
    window->context_ = &context;
    window->SetOwnContext(0);
    window->SetMultiSamples(0);  // costs 6 times the rest on llvmpipe
    window->SetFrameBlitModeToNoBlit();
    window->SetShowWindow(false);
    window->samples_ = samples;
    window->resize(width, height);
    return window;
}

void RenderWindow::MakeCurrent() {
    if (context_ != nullptr) context_->make_current();
}

bool RenderWindow::IsCurrent() { return context_ != nullptr && context_->is_current(); }

void RenderWindow::OpenGLInitContext() {
    if (Initialized) return;
    MakeCurrent();
    const GLenum result = glewInit();
    // GLEW looks for a GLX display last; by then all GL entry points that VTK needs are loaded.
    if (result != GLEW_OK && result != GLEW_ERROR_NO_GLX_DISPLAY)
        throw RenderError(fmt::format("GLEW cannot load OpenGL: {}",
                                      reinterpret_cast<const char*>(glewGetErrorString(result))));
    if (!GLEW_VERSION_3_2) throw RenderError("OpenGL 3.2 or newer is needed");
    Initialized = true;
    GlewInitValid = true;
}

void RenderWindow::resize(int width, int height) {
    width_ = width;
    height_ = height;
    SetSize(samples_ * width, samples_ * height);
}

void RenderWindow::Start() {
    vtkGenericOpenGLRenderWindow::Start();
    if (samples_ == 1) glEnable(GL_LINE_SMOOTH);  // VTK neither sets nor tracks this
}

void RenderWindow::Frame() {
    // VTK would now copy its framebuffer to a second one for display; grab() reads the first.
    if (!grabbing_) vtkGenericOpenGLRenderWindow::Frame();
}

Image RenderWindow::grab() {
    grabbing_ = true;
    Render();
    grabbing_ = false;
    MakeCurrent();
    vtkOpenGLState* state = GetState();
    state->PushFramebufferBindings();
    GLuint target = 0, colour = 0;
    glGenFramebuffers(1, &target);
    glGenRenderbuffers(1, &colour);
    glBindRenderbuffer(GL_RENDERBUFFER, colour);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, width_, height_);
    state->vtkglBindFramebuffer(GL_READ_FRAMEBUFFER, GetRenderFramebuffer()->GetFBOIndex());
    state->vtkglBindFramebuffer(GL_DRAW_FRAMEBUFFER, target);
    glFramebufferRenderbuffer(GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, colour);
    state->vtkglDrawBuffer(GL_COLOR_ATTACHMENT0);
    state->vtkglReadBuffer(GL_COLOR_ATTACHMENT0);
    state->vtkglDisable(GL_SCISSOR_TEST);
    // Halving with the linear filter reads each pixel between four, so it is their mean.
    glBlitFramebuffer(0, 0, samples_ * width_, samples_ * height_, 0, 0, width_, height_, GL_COLOR_BUFFER_BIT,
                      samples_ == 1 ? GL_NEAREST : GL_LINEAR);
    state->vtkglBindFramebuffer(GL_READ_FRAMEBUFFER, target);
    state->vtkglReadBuffer(GL_COLOR_ATTACHMENT0);
    const auto width = static_cast<std::size_t>(width_), height = static_cast<std::size_t>(height_);
    rgba_.resize(4 * width * height);
    glReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, rgba_.data());
    state->PopFramebufferBindings();
    glDeleteFramebuffers(1, &target);
    glDeleteRenderbuffers(1, &colour);

    Image image{width_, height_, std::vector<std::uint8_t>(3 * width * height)};
    std::uint8_t* to = image.pixels.data();
    for (std::size_t row = height; row-- > 0;) {  // OpenGL's first row is the lowest
        const std::uint8_t* from = rgba_.data() + 4 * width * row;
        for (std::size_t x = 0; x < width; ++x, from += 4, to += 3) {
            to[0] = from[0];
            to[1] = from[1];
            to[2] = from[2];
        }
    }
    return image;
}

}  // namespace percuss::render
