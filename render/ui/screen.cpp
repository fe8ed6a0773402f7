#include <GL/glew.h>
//
#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>
#include <utility>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <fmt/format.h>
#include <imgui.h>

#include "ui/screen.hpp"

namespace percuss::render {
namespace {

void load_opengl() {
    const GLenum result = glewInit();
    // GLEW looks for a GLX display last; by then all GL entry points are loaded.
    if (result != GLEW_OK && result != GLEW_ERROR_NO_GLX_DISPLAY)
        throw RenderError(fmt::format("GLEW cannot load OpenGL: {}",
                                      reinterpret_cast<const char*>(glewGetErrorString(result))));
}

void put(const ScriptedInput& input, ImGuiIO& io) {
    const bool outside = input.mouse[0] < 0;
    io.MousePos = outside ? ImVec2(-FLT_MAX, -FLT_MAX) : ImVec2(input.mouse[0], input.mouse[1]);
    io.MouseDown[0] = input.pressed;
    io.MouseDown[1] = input.right_pressed;
    io.MouseWheel = input.wheel;
    std::fill(std::begin(io.KeysDown), std::end(io.KeysDown), false);
    for (const int key : input.keys) io.KeysDown[key] = true;
    io.KeyCtrl = input.ctrl;
    io.KeyShift = input.shift;
    io.KeyAlt = io.KeySuper = false;
    io.AddInputCharactersUTF8(input.text.c_str());
}

Image read_back_buffer(std::array<int, 2> size) {
    const auto width = static_cast<std::size_t>(size[0]), height = static_cast<std::size_t>(size[1]);
    std::vector<std::uint8_t> rgba(4 * width * height);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, size[0], size[1], GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
    Image image{size[0], size[1], std::vector<std::uint8_t>(3 * width * height)};
    for (std::size_t y = 0; y < height; ++y)
        for (std::size_t x = 0; x < width; ++x)
            std::copy_n(rgba.data() + 4 * (width * (height - 1 - y) + x), 3,
                        image.pixels.data() + 3 * (width * y + x));
    return image;
}

}  // namespace

Screen::~Screen() = default;

void Screen::start(Context& context, double scale) {
    context.make_current();
    load_opengl();
    scale_ = std::clamp(scale, 0.5, 4.0);
    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr;  // the panels have fixed places
    ImGui_ImplOpenGL3_Init("#version 150");
    apply_style();
    load_fonts();
}

void Screen::stop() {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui::DestroyContext();
}

void Screen::load_fonts() {
    // Latin, Greek, and what units and numbers need: dashes, minus, arrows, dots.
    static const ImWchar glyphs[] = {0x20,   0x17f,  0x370,  0x3ff,  0x2010, 0x2027, 0x2070, 0x209f, 0x2190,
                                     0x2199, 0x2212, 0x2212, 0x221e, 0x221e, 0x2264, 0x2265, 0};
    ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
    atlas.Clear();
    const auto size = static_cast<float>(std::round(15 * scale_));
    const auto load = [&](const char* name) -> ImFont* {
        const std::filesystem::path file = std::filesystem::path("/usr/share/fonts/truetype/dejavu") / name;
        if (!std::filesystem::exists(file)) return nullptr;
        return atlas.AddFontFromFileTTF(file.c_str(), size, nullptr, glyphs);
    };
    fonts_.plain = load("DejaVuSans.ttf");
    if (fonts_.plain == nullptr) {
        ImFontConfig config;  // ImGui's own bitmap font knows Latin only, but is always there
        config.SizePixels = static_cast<float>(std::round(13 * scale_));
        fonts_.plain = atlas.AddFontDefault(&config);
    }
    fonts_.bold = load("DejaVuSans-Bold.ttf");
    if (fonts_.bold == nullptr) fonts_.bold = fonts_.plain;
    ImGui_ImplOpenGL3_DestroyFontsTexture();
    ImGui_ImplOpenGL3_CreateFontsTexture();
}

void Screen::apply_style() {
    ImGuiStyle style;
    if (dark_)
        ImGui::StyleColorsDark(&style);
    else
        ImGui::StyleColorsLight(&style);
    style.WindowRounding = 0;
    style.FrameRounding = 3;
    style.GrabRounding = 3;
    style.WindowBorderSize = 1;
    style.WindowPadding = {8, 6};
    style.FramePadding = {6, 3};
    style.ItemSpacing = {7, 5};
    if (!dark_) {
        style.Colors[ImGuiCol_WindowBg] = {0.965F, 0.969F, 0.973F, 1};
        style.Colors[ImGuiCol_FrameBg] = {0.88F, 0.895F, 0.91F, 1};
        style.Colors[ImGuiCol_Button] = {0.83F, 0.87F, 0.915F, 1};
        style.Colors[ImGuiCol_Border] = {0.78F, 0.8F, 0.83F, 1};
    }
    style.Colors[ImGuiCol_PopupBg].w = style.Colors[ImGuiCol_WindowBg].w =
        1;  // what lies beneath would be read, too
    style.Colors[ImGuiCol_PlotHistogram] =
        dark_ ? ImVec4{0.2F, 0.45F, 0.7F, 1} : ImVec4{0.55F, 0.75F, 0.95F, 1};
    style.ScaleAllSizes(static_cast<float>(scale_));
    ImGui::GetStyle() = style;
}

void Screen::set_scale(double scale) { wanted_scale_ = std::clamp(scale, 0.5, 4.0); }

void Screen::set_dark(bool dark) {
    dark_ = dark;
    apply_style();
}

bool Screen::begin_frame(const ScriptedInput* scripted) {
    context().make_current();
    if (!poll()) return false;
    if (wanted_scale_ && *wanted_scale_ != scale_) {
        scale_ = *wanted_scale_;
        apply_style();
        load_fonts();
    }
    wanted_scale_.reset();
    ImGui_ImplOpenGL3_NewFrame();
    begin_backend_frame();
    if (scripted != nullptr) put(*scripted, ImGui::GetIO());
    ImGui::NewFrame();
    return true;
}

void Screen::end_frame(bool grab) {
    ImGui::Render();
    context().make_current();
    const auto [width, height] = size();
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glViewport(0, 0, width, height);
    glDisable(GL_SCISSOR_TEST);
    glClearColor(1, 1, 1, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    if (grab) {
        glFinish();
        grabbed_ = read_back_buffer({width, height});
    }
    present();
}

namespace {

class Window final : public Screen {
  public:
    Window(const std::string& title, std::array<int, 2> size, double scale)
        : context_(make_window_context(title, size[0], size[1])) {
        if (scale <= 0) {
            float across = 1, down = 1;
            glfwGetWindowContentScale(context_->window(), &across, &down);
            scale = std::max(across, down);
        }
        glfwSetWindowUserPointer(context_->window(), this);
        glfwSetDropCallback(context_->window(), [](GLFWwindow* window, int count, const char** paths) {
            auto& dropped = static_cast<Window*>(glfwGetWindowUserPointer(window))->dropped_;
            dropped.insert(dropped.end(), paths, paths + count);
        });
        start(*context_, scale);
        ImGui_ImplGlfw_InitForOpenGL(context_->window(), true);
    }
    ~Window() override {
        context_->make_current();
        ImGui_ImplGlfw_Shutdown();
        stop();
    }
    Context& context() override { return *context_; }
    [[nodiscard]] std::array<int, 2> size() const override { return context_->size(); }
    void rest(double seconds) override { glfwWaitEventsTimeout(seconds); }
    void resize(std::array<int, 2> size) override { glfwSetWindowSize(context_->window(), size[0], size[1]); }
    void set_title(const std::string& title) override {
        glfwSetWindowTitle(context_->window(), title.c_str());
    }
    std::vector<std::filesystem::path> take_dropped_files() override { return std::exchange(dropped_, {}); }

  private:
    bool poll() override {
        glfwPollEvents();
        return glfwWindowShouldClose(context_->window()) == GLFW_FALSE;
    }
    void begin_backend_frame() override { ImGui_ImplGlfw_NewFrame(); }
    void present() override { glfwSwapBuffers(context_->window()); }

    std::unique_ptr<WindowContext> context_;
    std::vector<std::filesystem::path> dropped_;
};

/// Frames of 1/60 s that nobody sees; what is asked for is grabbed.
class Offscreen final : public Screen {
  public:
    Offscreen(std::array<int, 2> size, double scale)
        : size_(size), context_(make_offscreen_context(size[0], size[1])) {
        start(*context_, scale > 0 ? scale : 1);
        ImGuiIO& io = ImGui::GetIO();
        const std::pair<ImGuiKey, int> keys[] = {{ImGuiKey_Tab, GLFW_KEY_TAB},
                                                 {ImGuiKey_LeftArrow, GLFW_KEY_LEFT},
                                                 {ImGuiKey_RightArrow, GLFW_KEY_RIGHT},
                                                 {ImGuiKey_UpArrow, GLFW_KEY_UP},
                                                 {ImGuiKey_DownArrow, GLFW_KEY_DOWN},
                                                 {ImGuiKey_Home, GLFW_KEY_HOME},
                                                 {ImGuiKey_End, GLFW_KEY_END},
                                                 {ImGuiKey_Delete, GLFW_KEY_DELETE},
                                                 {ImGuiKey_Backspace, GLFW_KEY_BACKSPACE},
                                                 {ImGuiKey_Enter, GLFW_KEY_ENTER},
                                                 {ImGuiKey_Escape, GLFW_KEY_ESCAPE},
                                                 {ImGuiKey_Space, GLFW_KEY_SPACE},
                                                 {ImGuiKey_A, GLFW_KEY_A}};
        for (const auto& [name, number] : keys) io.KeyMap[name] = number;
    }
    ~Offscreen() override {
        context_->make_current();
        stop();
    }
    Context& context() override { return *context_; }
    [[nodiscard]] std::array<int, 2> size() const override { return size_; }
    void rest(double seconds) override {
        std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
    }
    void resize(std::array<int, 2> size) override { wanted_size_ = size; }
    void set_title(const std::string&) override {}

  private:
    bool poll() override {
        if (const auto size = std::exchange(wanted_size_, std::nullopt)) {
            context_->resize((*size)[0], (*size)[1]);
            size_ = *size;
        }
        return true;
    }
    void begin_backend_frame() override {
        ImGuiIO& io = ImGui::GetIO();
        io.DisplaySize = {static_cast<float>(size_[0]), static_cast<float>(size_[1])};
        io.DeltaTime = 1.0F / 60;
    }
    void present() override {}

    std::array<int, 2> size_;
    std::optional<std::array<int, 2>> wanted_size_;
    std::unique_ptr<OffscreenContext> context_;
};

}  // namespace

std::unique_ptr<Screen> make_window(const std::string& title, std::array<int, 2> size, double scale) {
    return std::make_unique<Window>(title, size, scale);
}

std::unique_ptr<Screen> make_offscreen(std::array<int, 2> size, double scale) {
    return std::make_unique<Offscreen>(size, scale);
}

}  // namespace percuss::render
