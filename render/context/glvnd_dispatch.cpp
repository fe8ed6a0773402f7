#include "context/glvnd_dispatch.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include "context/shared_library.hpp"
#include "image.hpp"

namespace percuss::render {

/// What libGLdispatch keeps for a thread: its layout is fixed by ABI version 1 (no header is installed).
struct GlvndDispatch::ThreadState {
    int tag;  // 0 and 1 belong to GLX and EGL
    void (*thread_destroyed)(ThreadState*);
    void* priv;
};

struct GlvndDispatch::Api {
    explicit Api(const SharedLibrary& library) {
        library.load("__glDispatchGetABIVersion", abi_version);
        library.load("__glDispatchInit", init);
        library.load("__glDispatchNewVendorID", new_vendor);
        library.load("__glDispatchCreateTable", create_table);
        library.load("__glDispatchGetCurrentThreadState", current);
        library.load("__glDispatchMakeCurrent", make_current);
        library.load("__glDispatchLoseCurrent", lose_current);
        if (abi_version() != 1)
            throw RenderError(
                fmt::format("libGLdispatch.so.0 has ABI version {}; percuss knows version 1", abi_version()));
        init();
    }
    int (*abi_version)();
    void (*init)();
    int (*new_vendor)();
    void* (*create_table)(GetProc, void*);
    ThreadState* (*current)();
    unsigned char (*make_current)(ThreadState*, void* table, int vendor, const void* patches);
    void (*lose_current)();

    static ThreadState& thread_state() {
        static constexpr int own_tag = 0x7065;
        static thread_local ThreadState state{own_tag, [](ThreadState*) {}, nullptr};
        return state;
    }
};

GlvndDispatch::GlvndDispatch(GetProc get_proc) {
    static const SharedLibrary library("libGLdispatch.so.0", "libglvnd0");
    static const Api api(library);
    api_ = &api;
    vendor_ = api.new_vendor();
    table_ = api.create_table(get_proc, nullptr);
    if (table_ == nullptr) throw RenderError("libGLdispatch.so.0 could not make a dispatch table");
}

bool GlvndDispatch::is_current() const { return api_->current() == &Api::thread_state(); }

void GlvndDispatch::make_current() {
    if (is_current()) return;
    if (api_->current() != nullptr)
        throw RenderError("another OpenGL context (GLX or EGL) is current on this thread; release it first");
    if (api_->make_current(&Api::thread_state(), table_, vendor_, nullptr) == 0)
        throw RenderError("libGLdispatch.so.0 refused to make the OSMesa dispatch table current");
}

void GlvndDispatch::lose_current() {
    if (is_current()) api_->lose_current();
}

}  // namespace percuss::render
