#include <cstdint>
#include <utility>
#include <vector>

#include "context/context.hpp"
#include "context/glvnd_dispatch.hpp"
#include "context/shared_library.hpp"
#include "image.hpp"

#ifndef GLAPI
#define GLAPI extern
#endif
#ifndef GLAPIENTRY
#define GLAPIENTRY
#endif
#include <GL/osmesa.h>

namespace percuss::render {

namespace {

/// The few functions of libOSMesa that are called by name; the rest goes through the dispatch table.
struct OsMesa {
    OsMesa() : library("libOSMesa.so.8", "libosmesa6") {
        library.load("OSMesaCreateContextAttribs", create);
        library.load("OSMesaDestroyContext", destroy);
        library.load("OSMesaMakeCurrent", make_current);
        library.load("OSMesaGetCurrentContext", current);
        library.load("OSMesaGetProcAddress", get_proc);
    }
    SharedLibrary library;
    OSMesaContext (*create)(const int*, OSMesaContext) = nullptr;
    void (*destroy)(OSMesaContext) = nullptr;
    GLboolean (*make_current)(OSMesaContext, void*, GLenum, GLsizei, GLsizei) = nullptr;
    OSMesaContext (*current)() = nullptr;
    OSMESAproc (*get_proc)(const char*) = nullptr;
};

const OsMesa& osmesa() {
    static const OsMesa loaded;
    return loaded;
}

void* osmesa_address(const char* name, void*) { return reinterpret_cast<void*>(osmesa().get_proc(name)); }

class OsMesaContext final : public OffscreenContext {
  public:
    OsMesaContext(int width, int height)
        : width_(width),
          height_(height),
          buffer_(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {
        // Core 3.3 is what VTK 9 and ImGui ask for; Mesa answers with 4.5 core.
        const int attributes[] = {OSMESA_FORMAT,
                                  OSMESA_RGBA,
                                  OSMESA_DEPTH_BITS,
                                  24,
                                  OSMESA_STENCIL_BITS,
                                  8,
                                  OSMESA_PROFILE,
                                  OSMESA_CORE_PROFILE,
                                  OSMESA_CONTEXT_MAJOR_VERSION,
                                  3,
                                  OSMESA_CONTEXT_MINOR_VERSION,
                                  3,
                                  0};
        context_ = osmesa().create(attributes, nullptr);
        if (context_ == nullptr)
            throw RenderError(
                "OSMesa cannot make an OpenGL 3.3 core context; libosmesa6 18 or newer is needed");
        make_current();
    }

    ~OsMesaContext() override {
        // The dispatch table must go first: a call in between would reach a context that is being destroyed.
        if (is_current()) {
            dispatch().lose_current();
            osmesa().make_current(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0);
        }
        osmesa().destroy(context_);
    }
    OsMesaContext(const OsMesaContext&) = delete;
    OsMesaContext& operator=(const OsMesaContext&) = delete;

    void make_current() override {
        if (is_current()) return;  // OSMesaMakeCurrent flushes and revalidates each time
        if (osmesa().make_current(context_, buffer_.data(), GL_UNSIGNED_BYTE, width_, height_) == GL_FALSE)
            throw RenderError("OSMesa refused to make its context current");
        dispatch().make_current();
    }

    void resize(int width, int height) override {
        if (width < 1 || height < 1) throw RenderError("an offscreen context needs at least one pixel");
        std::vector<std::uint8_t> buffer(4 * static_cast<std::size_t>(width) *
                                         static_cast<std::size_t>(height));
        // The old buffer is written to until the new one is current.
        if (osmesa().make_current(context_, buffer.data(), GL_UNSIGNED_BYTE, width, height) == GL_FALSE)
            throw RenderError("OSMesa refused to make its context current");
        dispatch().make_current();
        buffer_ = std::move(buffer);
        width_ = width;
        height_ = height;
    }

    [[nodiscard]] bool is_current() const override {
        return osmesa().current() == context_ && dispatch().is_current();
    }

  private:
    /// One table for all contexts: OSMesa's addresses do not depend on the context.
    static GlvndDispatch& dispatch() {
        static GlvndDispatch table(osmesa_address);
        return table;
    }

    int width_, height_;
    std::vector<std::uint8_t> buffer_;
    OSMesaContext context_ = nullptr;
};

}  // namespace

std::unique_ptr<OffscreenContext> make_offscreen_context(int width, int height) {
    if (width < 1 || height < 1) throw RenderError("an offscreen context needs at least one pixel");
    return std::make_unique<OsMesaContext>(width, height);
}

}  // namespace percuss::render
