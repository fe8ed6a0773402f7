#pragma once

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "context/context.hpp"
#include "image.hpp"
#include "ui/input.hpp"

struct ImFont;

namespace percuss::render {

/// The fonts that ImGui has loaded at the screen's scale.
struct Fonts {
    ImFont* plain = nullptr;
    ImFont* bold = nullptr;
};

/// Dear ImGui on a context: in a window, or in a picture in memory. One at a time.
class Screen {
  public:
    virtual ~Screen();
    Screen(const Screen&) = delete;
    Screen& operator=(const Screen&) = delete;

    /// Takes input and begins a frame of ImGui. @param scripted what to do instead of listening to the user.
    /// @returns false when the user has closed the window; there is no frame then.
    [[nodiscard]] bool begin_frame(const ScriptedInput* scripted);
    /// Draws the frame and shows it. @param grab whether to keep a copy.
    void end_frame(bool grab = false);
    /// The copy that the last end_frame(true) made.
    [[nodiscard]] const Image& grabbed() const { return grabbed_; }

    [[nodiscard]] virtual Context& context() = 0;
    [[nodiscard]] virtual std::array<int, 2> size() const = 0;  ///< [pixels]
    [[nodiscard]] double scale() const { return scale_; }
    void set_scale(double scale);  ///< of text and gaps, from the next frame on; 1: text of 15 pixels
    void set_dark(bool dark);
    [[nodiscard]] bool dark() const { return dark_; }
    [[nodiscard]] const Fonts& fonts() const { return fonts_; }
    /// Waits for input, at most so long, when nothing would change on the screen.
    virtual void rest(double seconds) = 0;
    /// Takes effect in the next frames; a display may not grant it. @param size at least 1 x 1 [pixels]
    virtual void resize(std::array<int, 2> size) = 0;
    virtual void set_title(const std::string& title) = 0;
    [[nodiscard]] virtual std::vector<std::filesystem::path> take_dropped_files() { return {}; }

  protected:
    Screen() = default;
    void start(Context& context, double scale);  ///< makes ImGui; call once the context is there
    void stop();                                 ///< ends ImGui while the context is there
    virtual bool poll() = 0;                     ///< @returns false when the window is to close
    virtual void begin_backend_frame() = 0;
    virtual void present() = 0;

  private:
    void load_fonts();
    void apply_style();
    double scale_ = 1;
    std::optional<double> wanted_scale_;
    bool dark_ = false;
    Fonts fonts_;
    Image grabbed_;
};

/// @param scale 0: that of the display. @throws RenderError, e.g. when there is no display.
[[nodiscard]] std::unique_ptr<Screen> make_window(const std::string& title, std::array<int, 2> size,
                                                  double scale);
/// A screen without a display, by OSMesa. @throws RenderError.
[[nodiscard]] std::unique_ptr<Screen> make_offscreen(std::array<int, 2> size, double scale);

}  // namespace percuss::render
