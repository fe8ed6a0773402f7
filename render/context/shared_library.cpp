#include "context/shared_library.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include "image.hpp"

namespace percuss::render {

SharedLibrary::SharedLibrary(std::string name, std::string package)
    : name_(std::move(name)), package_(std::move(package)) {
    handle_ = dlopen(name_.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (handle_ != nullptr) return;
    const char* reason = dlerror();
    throw RenderError(fmt::format("{} cannot be loaded ({}); install the package {}", name_,
                                  reason == nullptr ? "unknown reason" : reason, package_));
}

void* SharedLibrary::address(const char* symbol) const {
    if (void* found = dlsym(handle_, symbol); found != nullptr) return found;
    throw RenderError(
        fmt::format("{} lacks the symbol {}; reinstall the package {}", name_, symbol, package_));
}

}  // namespace percuss::render
