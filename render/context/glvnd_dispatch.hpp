#pragma once

namespace percuss::render {

/// Routes the GL calls of a thread to another GL library. VTK, GLEW and ImGui call libOpenGL, whose entry
/// points are glvnd stubs; without a dispatch table made current they do nothing, however current an OSMesa
/// context is.
class GlvndDispatch {
  public:
    using GetProc = void* (*)(const char* name, void* unused);

    /// @throws RenderError when libGLdispatch is missing or speaks another ABI.
    explicit GlvndDispatch(GetProc get_proc);

    /// Makes the table current on this thread; harmless when it already is.
    void make_current();
    [[nodiscard]] bool is_current() const;
    void lose_current();

  private:
    struct ThreadState;
    struct Api;
    const Api* api_;
    void* table_ = nullptr;
    int vendor_ = 0;
};

}  // namespace percuss::render
