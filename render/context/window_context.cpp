#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include "context/context.hpp"
#include "image.hpp"

namespace percuss::render {
namespace {

std::string last_glfw_error() {
    const char* text = nullptr;
    glfwGetError(&text);
    std::string reason = text != nullptr ? text : "no reason given";
    while (reason.ends_with(' ')) reason.pop_back();
    return reason;
}

class GlfwContext final : public WindowContext {
  public:
    GlfwContext(const std::string& title, int width, int height) {
        if (glfwInit() == GLFW_FALSE) throw RenderError(fmt::format("no window: {}", last_glfw_error()));
        // Core 3.3, as of the off-screen context: VTK 9 and ImGui ask for it.
        glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
        glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
        glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
        glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
        window_ = glfwCreateWindow(width, height, title.c_str(), nullptr, nullptr);
        if (window_ == nullptr) {
            const std::string why = last_glfw_error();
            glfwTerminate();
            throw RenderError(fmt::format("no window: {}", why));
        }
        make_current();
        glfwSwapInterval(1);
    }
    ~GlfwContext() override {
        glfwDestroyWindow(window_);
        glfwTerminate();
    }
    GlfwContext(const GlfwContext&) = delete;
    GlfwContext& operator=(const GlfwContext&) = delete;

    void make_current() override {
        if (!is_current()) glfwMakeContextCurrent(window_);
    }
    [[nodiscard]] bool is_current() const override { return glfwGetCurrentContext() == window_; }
    [[nodiscard]] GLFWwindow* window() override { return window_; }
    [[nodiscard]] std::array<int, 2> size() const override {
        std::array<int, 2> pixels{};
        glfwGetFramebufferSize(window_, pixels.data(), &pixels[1]);
        return pixels;
    }

  private:
    GLFWwindow* window_ = nullptr;
};

}  // namespace

std::unique_ptr<WindowContext> make_window_context(const std::string& title, int width, int height) {
    return std::make_unique<GlfwContext>(title, width, height);
}

}  // namespace percuss::render
