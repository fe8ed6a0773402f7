#pragma once

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "live/beside.hpp"
#include "live/curves.hpp"
#include "live/ghost.hpp"
#include "live/live_run.hpp"
#include "live/reference.hpp"
#include "ui/screen.hpp"
#include "view/live_view.hpp"
#include "view/pick.hpp"
#include "workbench/design_panel.hpp"
#include "workbench/export/exports.hpp"
#include "workbench/layout.hpp"
#include "workbench/lessons.hpp"
#include "workbench/thumbnails/thumbnails.hpp"
#include "workbench/timeline_state.hpp"
#include "workbench/timing.hpp"
#include "workbench/viewport_marks.hpp"
#include "workbench/widget_names.hpp"

namespace percuss::app {

/// Which part of the model the viewport shows.
enum class Framing {
    scene,   ///< the window that the scene's [view] asks for, if any, else all bodies
    all,     ///< all bodies, followed as they fly
    chosen,  ///< panned and zoomed by the user
};

struct ViewportState {
    std::unique_ptr<render::LiveView> view;
    std::shared_ptr<const RunSetup> setup;  // what `view` draws
    ViewOptions options;
    render::RangeMode range_mode = render::RangeMode::frame;
    bool fixed_range = false;
    std::array<double, 2> fixed{0, 1};  ///< [unit of the field, scene units]
    Framing framing = Framing::scene;
    std::optional<render::LiveCamera> camera;
    bool dirty = true;           ///< something else than the snapshot has changed
    std::filesystem::path file;  ///< of the scene whose view options these are
    unsigned texture = 0;
    std::shared_ptr<const Snapshot> drawn;
    long long draws = 0;  ///< pictures of the model so far
    std::array<int, 2> drawn_size{0, 0};
    render::Picked hovered;
};

/// A run beside the one that is shown, and its picture.
struct BesideView {
    std::unique_ptr<BesideRun> run;
    std::unique_ptr<render::LiveView> view{};
    std::shared_ptr<const RunSetup> setup{};  // what `view` draws
    std::shared_ptr<const Snapshot> drawn{};
    long long draws = -1;  // of the picture beside, when this one was drawn
    unsigned texture = 0;
};

struct PlotsState {
    Curves curves;
    std::vector<PlotInfo> plots;
    std::vector<HistoryColumn> columns;  // that `plots` is for
    int probe_changes = 0;               // likewise: ViewportMarks::probe_changes
    std::set<std::string> toggled;       // "PLOT/LABEL" of curves whose visibility differs from the first one
    std::set<std::string> folded;        // names of plots that are closed
    std::optional<std::array<double, 2>> time;  ///< shown, [time]; absent: all
    std::optional<double> cursor;               ///< time under the mouse
};

/// The window: what it shows and what can be done in it. Drawn once a frame; talks to the engine by commands,
/// snapshots and histories alone.
class Workbench {
  public:
    /// @param open_run reads recorded runs
    Workbench(render::Screen& screen_in, EngineOptions options, OpenRun open_run = {})
        : run(options, std::move(open_run)), screen(screen_in), threads_(options.threads) {}

    /// One frame of all panels, between Screen::begin_frame and Screen::end_frame.
    void frame();
    /// Whether the next frame would look like the last one if the user did nothing.
    [[nodiscard]] bool at_rest() const;
    /// Whether a run beside is on its way to the time of the one that is shown.
    [[nodiscard]] bool beside_busy() const;

    /// A number or text of the workbench by name, for scripts: "time", "status", "parameters.shank", ...
    using Value = std::variant<double, std::string>;
    [[nodiscard]] std::optional<Value> value(const std::string& name) const;
    [[nodiscard]] static std::vector<std::string> value_names();

    /// A scene picker that stands open would hide what it opens.
    void open(const std::filesystem::path& file) {
        pick_scene = false;
        run.open(file);
    }
    /// Another run of the scene, beside the one that is shown. @param overrides all that it is given.
    void add_beside(const std::filesystem::path& file, const std::vector<std::string>& overrides,
                    const std::string& label);
    /// Arranges the window like this, before its first frame.
    void use_layout(WindowLayout wanted);
    void do_command(const std::string& name);
    /// Shows a line for some seconds, e.g. where a screenshot went.
    void tell(std::string words);
    [[nodiscard]] const std::string& note() const { return note_; }

    LiveRun run;
    render::Screen& screen;
    ViewportState viewport;
    ViewportMarks marks;
    PlotsState plots;
    Exports exports;
    WindowLayout layout;
    Thumbnails thumbnails;               ///< of the scene picker
    std::optional<Reference> reference;  ///< the run that the present one is compared with
    std::vector<BesideView> beside;      ///< runs that share its clock
    Ghost ghost;                         ///< of the run before the design was changed
    TimelineState timeline;
    DesignPanel design;
    LessonState lesson;
    Timing timing;  ///< fed by whoever shows the frames
    WidgetNames names;
    bool panels = true, help = false, pick_scene = false;
    std::string pick_typed;  ///< what the scene picker begins with
    bool reload_by_itself = true;
    int step_count = 100;
    double until = 0;  ///< of "run until" [time]
    bool quit = false;
    std::filesystem::path opened;                     ///< scene that was remembered last
    std::optional<std::filesystem::path> screenshot;  ///< to be written after this frame
    long long frames = 0;

  private:
    int threads_;
    std::string note_;
    std::chrono::steady_clock::time_point note_until_;
};

}  // namespace percuss::app
