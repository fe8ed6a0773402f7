#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "canvas.hpp"
#include "context/context.hpp"
#include "image.hpp"
#include "run/fields.hpp"
#include "run/snapshot.hpp"
#include "view/colour_range.hpp"
#include "view/layout.hpp"
#include "view/plane.hpp"

namespace percuss::render {

/// Which part of the model a window shows, in picture coordinates.
struct LiveCamera {
    std::array<double, 2> centre{0, 0};  ///< of the model's part of the window [length]
    double pixels_per_unit = 1;          ///< [pixels/length]
};

/// A part of a picture and where its pixels are in the texture: the other way round where it is the mirror
/// image of what the texture has.
struct LivePart {
    Rect place;  ///< in the picture [pixels]
    /// Of the texture, at the lower left and at the upper right corner of the place [0 to 1].
    std::array<double, 2> low{0, 0}, high{1, 1};
};

enum class RangeMode {
    frame,     ///< least and greatest value of each frame, or ViewOptions::range when it is set
    all_time,  ///< of all frames drawn since the field was chosen
};

/// Draws a run that goes on into a window: the mesh by VTK into a texture, the ink over it on any canvas, so
/// that text is as sharp as the rest of the window and costs little.
class LiveView {
  public:
    LiveView(Context& context, std::shared_ptr<const RunSetup> setup, ViewOptions options);
    ~LiveView();

    /// Goes on with another run; the colour range and scales begin anew. What was set stays.
    /// @throws RenderError when the new scene has no such field; nothing is changed then.
    void show(std::shared_ptr<const RunSetup> setup, const ViewOptions& options);
    /// Other field, colours, arrows, ...; `size`, `charts` and `window` are not looked at. @throws
    /// RenderError.
    void set_options(const ViewOptions& options, RangeMode mode);
    /// @param camera absent: all bodies, followed as they fly.
    void set_camera(std::optional<LiveCamera> camera);
    /// Draws the mesh. @param size of the picture [pixels]. @param scale of ink: 1 is 14 pixels for text.
    /// @returns the OpenGL name of an RGB texture, lowest row first, valid until the next draw; parts() says
    /// how it makes the picture.
    [[nodiscard]] unsigned draw(std::shared_ptr<const Snapshot> snapshot, std::array<int, 2> size,
                                double scale);
    /// The whole texture; of a mirrored mesh its larger half, twice: half the work.
    [[nodiscard]] std::vector<LivePart> parts() const;
    /// Arrows, labels, colour bar and scale bar of the last draw(), in its pixels. @param corners that others
    /// write in: labels keep away from them and from the upper right one.
    void paint(Canvas& canvas, std::vector<Rect> corners = {}) const;

    /// Mesh and ink in one picture, to be kept. @param ink paints over the mesh: paint(), and what else
    /// belongs to it.
    [[nodiscard]] Image picture(std::shared_ptr<const Snapshot> snapshot, std::array<int, 2> size,
                                double scale, const std::function<void(Canvas&)>& ink);
    /// Takes over what grows while a run is shown: the box of all bodies and the scales of arrows, so that
    /// both views draw alike. @param other of the same scene.
    void take_scales(const LiveView& other);

    /// Of the last draw() or picture().
    [[nodiscard]] const Fit& fit() const;
    [[nodiscard]] const Rect& model() const;  ///< where the model is shown [pixels]
    [[nodiscard]] ColourRange range() const;
    [[nodiscard]] const Plane& plane() const;
    [[nodiscard]] const FieldInfo& field() const;
    [[nodiscard]] double force_reference() const;  ///< of the reference arrow; 0 while it has none [force]
    [[nodiscard]] double value(std::size_t cell_or_node) const;  ///< of the field, in scene units
    /// The camera of the last draw(), to pan and zoom from.
    [[nodiscard]] LiveCamera camera() const;
    /// A camera that shows this box {left, low, right, high} of picture coordinates.
    [[nodiscard]] LiveCamera around(const std::array<double, 4>& box) const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace percuss::render
