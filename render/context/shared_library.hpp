#pragma once

#include <string>

namespace percuss::render {

/// A library opened at run time. It stays mapped for good: Mesa keeps threads and thread-local data behind
/// it.
class SharedLibrary {
  public:
    /// @param package the Debian package that holds it, for the message. @throws RenderError.
    SharedLibrary(std::string name, std::string package);

    /// Stores the address of `symbol` in a function pointer. @throws RenderError when the symbol is missing.
    template <class Function>
    void load(const char* symbol, Function*& function) const {
        function = reinterpret_cast<Function*>(address(symbol));
    }

  private:
    [[nodiscard]] void* address(const char* symbol) const;
    std::string name_, package_;
    void* handle_ = nullptr;
};

}  // namespace percuss::render
