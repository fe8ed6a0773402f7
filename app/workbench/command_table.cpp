#include "workbench/command_table.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <imgui.h>

#include "ui/input.hpp"
#include "workbench/lessons.hpp"
#include "workbench/viewport_actions.hpp"
#include "workbench/workbench.hpp"

namespace percuss::app {
namespace {

void toggle_run(Workbench& w) {
    if (!w.run.live() && !w.run.recorded()) {
        if (w.run.playing())
            w.run.stop_playing();
        else
            w.run.play();
    } else if (w.run.status() == RunStatus::running)
        w.run.pause();
    else
        w.run.run();
}

/// percuss-20240131-120000.png, or the like with a number when it is there.
std::filesystem::path free_name() {
    const std::string stem = fmt::format("percuss-{:%Y%m%d-%H%M%S}", fmt::localtime(std::time(nullptr)));
    std::filesystem::path file = stem + ".png";
    for (int i = 2; std::filesystem::exists(file); ++i) file = fmt::format("{}-{}.png", stem, i);
    return file;
}

template <bool ViewOptions::*option>
void toggle_option(Workbench& w) {
    w.viewport.options.*option = !(w.viewport.options.*option);
    w.viewport.dirty = true;
}

template <bool ViewOptions::*option>
bool option_on(const Workbench& w) {
    return w.viewport.options.*option;
}

/// What is shown now stays as the reference; the same command drops it.
void toggle_reference(Workbench& w) {
    if (w.reference)
        w.reference.reset();
    else if (w.run.snapshot())
        w.reference.emplace(Reference{w.run.history(), w.run.moments(), {}, w.run.snapshot()});
}

void frame_model(Workbench& w, Framing framing) {
    stop_following(w);
    w.viewport.framing = framing;
    w.viewport.camera.reset();
    w.viewport.dirty = true;
}

/// The element that failed, with some of its neighbours.
void frame_failure(Workbench& w) {
    const auto& now = w.run.newest();
    if (!now || !w.viewport.view || now->failed_cell < 0) return;
    w.run.go_live();
    std::array<double, 4> box{HUGE_VAL, HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
    for (const std::int32_t node : now->setup->mesh.cells[static_cast<std::size_t>(now->failed_cell)]) {
        if (node < 0) continue;
        const auto at = 2 * static_cast<std::size_t>(node);
        const auto point = w.viewport.view->plane()(now->position[at], now->position[at + 1]);
        for (std::size_t k = 0; k < 2; ++k) {
            box[k] = std::min(box[k], point[k]);
            box[k + 2] = std::max(box[k + 2], point[k]);
        }
    }
    const double room = 2 * std::max(box[2] - box[0], box[3] - box[1]);
    w.viewport.camera = w.viewport.view->around({box[0] - room, box[1] - room, box[2] + room, box[3] + room});
    w.viewport.framing = Framing::chosen;
    w.viewport.dirty = true;
}

/// What is under the mouse, told when there is nothing.
bool points_at_body(Workbench& w) {
    if (w.viewport.hovered.body >= 0) return true;
    w.tell("rest the mouse on a body in the picture first");
    return false;
}

void probe_here(Workbench& w) {
    if (points_at_body(w)) add_probe_at(w, w.viewport.hovered, w.viewport.options.field);
}

void toggle_follow(Workbench& w) {
    if (w.marks.followed)
        stop_following(w);
    else if (points_at_body(w))
        follow_node(w, w.viewport.hovered.node);
}

void toggle_pairs(Workbench& w) {
    using Pairs = ViewportMarks::Pairs;
    w.marks.pairs = w.marks.pairs == Pairs::none ? Pairs::all : Pairs::none;
}

void copy_probes(Workbench& w) {
    const std::string text = probes_as_scene_text(w.run.probes());
    if (!text.empty()) ImGui::SetClipboardText(text.c_str());
    w.tell(text.empty() ? "no probe has been put here" : "the probes are on the clipboard");
}

void zoom_text(Workbench& w, double factor) {
    w.layout.scale = std::clamp(factor == 0 ? 1 : w.screen.scale() * factor, 0.75, 2.5);
    w.screen.set_scale(*w.layout.scale);
    w.viewport.dirty = true;
}

}  // namespace

const std::vector<WorkbenchCommand>& workbench_commands() {
    static const std::vector<WorkbenchCommand> table{
        {"run.toggle", "Run or pause", "Space",
         "Lets the engine step, or holds it; after the end, runs again. Plays what is looked back at.",
         toggle_run,
         [](const Workbench& w) { return w.run.status() == RunStatus::running || w.run.playing(); }},
        {"run.step", "One step", "Right",
         "Advances the scene by one time step; looking back: to the next kept moment.",
         [](Workbench& w) {
             if (w.run.live())
                 w.run.step(1);
             else
                 w.run.look_step(1);
         }},
        {"run.steps", "Several steps", "", "Advances by the number of steps in the field beside it.",
         [](Workbench& w) { w.run.step(std::max(1, w.step_count)); }},
        {"run.until", "Run until", "",
         "Runs and pauses at the first step that reaches the time in the field.",
         [](Workbench& w) { w.run.run(w.until); }},
        {"run.reset", "Reset", "R", "Back to time 0, with new histories.",
         [](Workbench& w) { w.run.reset(); }},
        {"run.full-speed", "As fast as can be", "", "Takes back the speed that the run was held to.",
         [](Workbench& w) { w.run.set_speed(std::nullopt); }},
        {"time.back", "One moment back", "Left",
         "Shows the kept moment before the one that is shown; the run goes on or waits, undisturbed.",
         [](Workbench& w) { w.run.look_step(-1); }},
        {"time.live", "Newest moment", "End", "Shows the newest moment of the run again, and follows it.",
         [](Workbench& w) { w.run.go_live(); }},
        {"time.branch", "Go on from here", "",
         "Runs on from the moment that is looked back at; says first what that drops, and asks.",
         [](Workbench& w) { w.run.ask_branch(); }},
        {"time.branch-confirm", "Drop the rest and go on", "",
         "The answer yes to the question that the command before asks.",
         [](Workbench& w) { w.run.confirm_branch(); }},
        {"time.branch-cancel", "Keep all", "", "The answer no.", [](Workbench& w) { w.run.cancel_branch(); }},
        {"scene.open", "Open a scene", "Ctrl+O", "Chooses another scene by a few letters of its name.",
         [](Workbench& w) { w.pick_scene = true; }},
        {"scene.reload", "Reload", "Ctrl+L", "Reads the scene's file anew and keeps the values set here.",
         [](Workbench& w) { w.run.reload(); }},
        {"scene.watch", "Reload by itself", "", "Reads the scene's file anew whenever it changes on disk.",
         [](Workbench& w) { w.reload_by_itself = !w.reload_by_itself; },
         [](const Workbench& w) { return w.reload_by_itself; }},
        {"scene.file-values", "Values of the file", "",
         "Takes back all values that were set in the design panel.",
         [](Workbench& w) { w.run.forget_settings(); }},
        {"scene.save", "Save scene as", "Ctrl+S",
         "Writes the scene with the values set here, comments and layout kept, to the file named in the "
         "export panel.",
         [](Workbench& w) { w.exports.save_scene(w); }},
        {"compare.add", "Beside", "",
         "Puts this design beside the one that goes on being changed: a run of its own at the same time, "
         "with its "
         "picture and its curves.",
         [](Workbench& w) {
             if (w.run.recorded() || !w.run.snapshot())
                 w.tell("runs of a scene stand beside each other; this is none");
             else
                 w.add_beside(w.run.file(), w.run.overrides(), label_of(w.run));
         }},
        {"compare.clear", "None beside", "", "Takes away the runs beside this one.",
         [](Workbench& w) { w.beside.clear(); }},
        {"lesson.list", "Lessons", "",
         "Chooses one of the lessons: scenes with a question and a control to move.",
         [](Workbench& w) { list_lessons(w); }},
        {"lesson.next", "Next lesson", "", "Opens the lesson after this one; without one the first.",
         [](Workbench& w) { open_lesson(w, 1); }},
        {"lesson.previous", "Previous", "", "Opens the lesson before this one.",
         [](Workbench& w) { open_lesson(w, -1); }},
        {"lesson.answer", "Answer", "", "Shows the answer to the lesson's question, or hides it.",
         [](Workbench& w) { w.lesson.answered = !w.lesson.answered; },
         [](const Workbench& w) { return w.lesson.answered; }},
        {"reference.toggle", "Keep as reference", "B",
         "Keeps this run to compare the next ones with: outline and curves beneath theirs, peaks in a table; "
         "again: drops it.",
         toggle_reference, [](const Workbench& w) { return w.reference.has_value(); }},
        {"view.fit", "Fit all", "F", "Shows all bodies and follows them.",
         [](Workbench& w) { frame_model(w, Framing::all); }},
        {"view.scene", "The scene's window", "Home",
         "Shows the part of the model that the scene's [view] names.",
         [](Workbench& w) { frame_model(w, Framing::scene); }},
        {"view.failure", "Show the failed element", "",
         "Zooms to the element that a diverged run's message names.", frame_failure},
        {"view.drop-ghost", "Drop the ghost", "",
         "Takes away the outline of the run before the design was changed.",
         [](Workbench& w) { w.ghost = {}; }},
        {"view.edges", "Element edges", "E", "Draws the edges of the elements, where they are not too dense.",
         toggle_option<&ViewOptions::edges>, option_on<&ViewOptions::edges>},
        {"view.forces", "Contact forces", "C", "Draws the contact forces of the last step as arrows.",
         toggle_option<&ViewOptions::forces>, option_on<&ViewOptions::forces>},
        {"view.velocities", "Velocities", "V",
         "Draws an arrow and a label for the mean velocity of each body.",
         toggle_option<&ViewOptions::velocities>, option_on<&ViewOptions::velocities>},
        {"view.mirror", "Both halves", "M", "Draws the mirror image at the other side of the axis, too.",
         toggle_option<&ViewOptions::mirror>, option_on<&ViewOptions::mirror>},
        {"view.pairs", "Contact surfaces", "S",
         "Marks master nodes and slave sides of the contact pairs; the list beside it chooses one pair.",
         toggle_pairs, [](const Workbench& w) { return w.marks.pairs != ViewportMarks::Pairs::none; }},
        {"view.follow", "Follow a node", "N",
         "The picture moves with the node under the mouse, until this is done again.", toggle_follow,
         [](const Workbench& w) { return w.marks.followed.has_value(); }},
        {"probe.here", "Probe here", "P",
         "Reads the field shown at the place under the mouse: a curve, at each step from now on.",
         probe_here},
        {"probe.clear", "Remove probes", "", "Removes all probes that were put in this window.",
         remove_all_probes},
        {"probe.copy", "Copy probes", "",
         "Copies the probes of this window as [[probe]] tables of a scene file to the clipboard.",
         copy_probes},
        {"plots.all", "Plots: all times", "A", "Takes back the zoom of the plots' time axis.",
         [](Workbench& w) { w.plots.time.reset(); }},
        {"export.panel", "Export panel", "Ctrl+E",
         "Opens the part of the panel on the left that writes files.",
         [](Workbench& w) {
             w.panels = true;
             w.exports.settings.to_panel = 2;
         }},
        {"export.picture", "Picture", "",
         "Writes what the viewport shows to NAME.png, larger by the factor in the export panel.",
         [](Workbench& w) { w.exports.save_picture(w); }},
        {"export.film", "Film", "", "Makes NAME.mp4 of the run so far, drawn as the viewport shows it.",
         [](Workbench& w) { w.exports.begin_film(w, true); }},
        {"export.sequence", "Sequence", "",
         "The same as numbered pictures, NAME-frames/000000.png and so on.",
         [](Workbench& w) { w.exports.begin_film(w, false); }},
        {"export.figures", "Figures", "",
         "Draws the scene's figures, and one of each kind that any run has, into NAME-figures/.",
         [](Workbench& w) { w.exports.begin_figures(w); }},
        {"export.cancel", "Cancel", "", "Ends the film or figures under way.",
         [](Workbench& w) { w.exports.cancel(w); }},
        {"export.record", "Record", "",
         "Films what the viewport shows from now on to NAME-live.mp4; again: ends it. What does not change "
         "takes no time in the film.",
         [](Workbench& w) { w.exports.toggle_recording(w); },
         [](const Workbench& w) { return w.exports.recording(); }},
        {"export.plots-csv", "Plots as CSV", "",
         "Writes the curves of each open plot, every step within the times shown, to NAME-PLOT.csv.",
         [](Workbench& w) { w.exports.save_open_plots(w, PlotFormat::csv); }},
        {"export.plots-png", "Plots as PNG", "", "Draws each open plot for print to NAME-PLOT.png.",
         [](Workbench& w) { w.exports.save_open_plots(w, PlotFormat::png); }},
        {"panels.toggle", "Panels", "Tab", "Hides all panels but the picture, or shows them again.",
         [](Workbench& w) { w.panels = !w.panels; }, [](const Workbench& w) { return w.panels; }},
        {"window.dark", "Dark", "", "Light letters on dark panels; the picture stays on white.",
         [](Workbench& w) {
             w.layout.dark = !w.screen.dark();
             w.screen.set_dark(*w.layout.dark);
         },
         [](const Workbench& w) { return w.screen.dark(); }},
        {"window.larger", "Larger text", "Ctrl++", "Letters and widgets a quarter larger.",
         [](Workbench& w) { zoom_text(w, 1.25); }},
        {"window.smaller", "Smaller text", "Ctrl+-", "Letters and widgets a fifth smaller.",
         [](Workbench& w) { zoom_text(w, 0.8); }},
        {"window.normal", "Normal text", "Ctrl+0", "Letters of 15 pixels.",
         [](Workbench& w) { zoom_text(w, 0); }},
        {"window.screenshot", "Screenshot", "Ctrl+P", "Writes the window as it is to percuss-DATE-TIME.png.",
         [](Workbench& w) { w.screenshot = free_name(); }},
        {"help", "Help", "F1", "Shows this page.", [](Workbench& w) { w.help = !w.help; },
         [](const Workbench& w) { return w.help; }},
        {"quit", "Quit", "Ctrl+Q", "Closes the window; nothing is saved.",
         [](Workbench& w) { w.quit = true; }},
    };
    return table;
}

const WorkbenchCommand* find_command(std::string_view name) {
    const auto& table = workbench_commands();
    const auto found =
        std::find_if(table.begin(), table.end(), [&](const WorkbenchCommand& c) { return c.name == name; });
    return found == table.end() ? nullptr : &*found;
}

KeyChord parse_key(std::string_view text) {
    KeyChord chord;
    constexpr std::string_view ctrl = "Ctrl+";
    if (text.starts_with(ctrl)) {
        chord.ctrl = true;
        text.remove_prefix(ctrl.size());
    }
    chord.key = render::key_number(std::string(text));
    return chord;
}

}  // namespace percuss::app
