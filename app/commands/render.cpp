#include <algorithm>
#include <numeric>
#include <optional>

#include <fmt/format.h>

#include "commands.hpp"
#include "drawing.hpp"
#include "exit_status.hpp"
#include "finished_run.hpp"
#include "options.hpp"
#include "output.hpp"
#include "progress.hpp"
#include "record/run_file.hpp"
#include "run/fields.hpp"

namespace percuss::app {
namespace {

struct RenderOptions {
    std::string run;
    std::optional<std::string> field, range, window, size, film, out;
    std::vector<long long> frames;
    bool all = false, force = false;
};

ViewOptions view_of(const RenderOptions& options, const Scene& scene) {
    ViewOptions view = scene.view;
    if (options.field) {
        try {
            view.field = find_field(scene, *options.field).name;
        } catch (const std::invalid_argument& error) {
            throw UsageError(fmt::format("--field: {}", error.what()));
        }
        view.range.reset();  // the scene's range belongs to the scene's field
    }
    if (options.range) {
        view.range = parse_numbers<2>("--range", *options.range);
        if ((*view.range)[0] >= (*view.range)[1])
            throw UsageError("--range: the first number must be the smaller");
    }
    if (options.window) {
        const auto window = parse_numbers<4>("--window", *options.window);
        if (window[0] >= window[2] || window[1] >= window[3]) {
            throw UsageError("--window: write min0,min1,max0,max1 with min below max");
        }
        view.window = window;
    }
    if (options.size) view.size = parse_size(*options.size);
    return view;
}

/// Which frames to draw: as asked, negative ones from the end; all for --all or a film; else the last.
std::vector<long long> chosen_frames(const RenderOptions& options, long long count) {
    std::vector<long long> frames(static_cast<std::size_t>(count));
    std::iota(frames.begin(), frames.end(), 0);
    if (count == 0) throw UsageError("the run has no complete frame");
    if (options.all || (options.film && options.frames.empty())) return frames;
    if (options.frames.empty()) return {count - 1};
    frames = options.frames;
    for (long long& frame : frames) {
        const long long asked = frame;
        if (frame < 0) frame += count;
        if (frame < 0 || frame >= count) {
            throw UsageError(fmt::format("--frame {}: the run has frames 0 to {}", asked, count - 1));
        }
    }
    return frames;
}

int render_run(const RenderOptions& options) {
    if (options.film) check_film(*options.film, options.force);
    const std::filesystem::path file = run_file_of(options.run);
    const RunFile run(file);
    const ViewOptions view = view_of(options, run.setup()->scene);
    const std::vector<long long> frames = chosen_frames(options, run.frames());

    DrawingTargets targets;
    if (options.film) targets.film = *options.film;
    // A film alone needs no pictures beside it.
    if (options.out || !options.film)
        targets.folder = options.out.value_or((file.parent_path() / "redrawn").string());
    if (targets.folder && !options.force) {
        for (const long long frame : frames) {
            const auto picture = *targets.folder / frame_name(frame);
            if (!std::filesystem::exists(picture)) continue;
            throw UsageError(
                fmt::format("{}: the picture exists; choose another --out, or replace it with --force",
                            picture.string()));
        }
    }
    const auto history = run.history();
    const auto start = std::chrono::steady_clock::now();
    Drawing drawing(run.setup(), view, targets);
    for (const long long frame : frames) drawing.add(*run.frame(frame), history.get(), frame);
    drawing.finish();
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
    fmt::print("{} of {} frames drawn in {}\n", frames.size(), run.frames(), short_duration(spent.count()));
    if (targets.folder) {
        const auto [first, last] = std::minmax_element(frames.begin(), frames.end());
        fmt::print("{}{}\n", (*targets.folder / frame_name(*first)).string(),
                   frames.size() > 1 ? fmt::format(" (to {})", frame_name(*last)) : "");
    }
    if (targets.film) fmt::print("{}\n", targets.film->string());
    return exit_status::ok;
}

}  // namespace

void add_render(CLI::App& app, Job& job) {
    auto options = std::make_shared<RenderOptions>();
    CLI::App& command = *app.add_subcommand(
        "render", "Draw a recorded run anew: other field, range, window; nothing is solved again");
    command.footer("Also for a run that was killed, up to its last complete frame, or that still goes on.");
    command.add_option("RUN", options->run, "directory of a run, or its run.h5")->required();
    command.add_option("--field", options->field,
                       "what colours the mesh, e.g. stress.axial, velocity.magnitude");
    command.add_option("--range", options->range, "colour range in scene units")->type_name("LOW,HIGH");
    command.add_option("--window", options->window, "shown region in scene units (r,z or x,y)")
        ->type_name("MIN0,MIN1,MAX0,MAX1");
    command.add_option("--size", options->size, "pixels")->type_name("WxH");
    command.add_option("--out", options->out, "directory for the pictures; default: redrawn/ beside run.h5")
        ->type_name("DIR");
    command.add_option("--film", options->film, "make a film of all frames")->type_name("FILE.mp4");
    CLI::Option* frame = command
                             .add_option("--frame", options->frames,
                                         "frame to draw, -1 for the last; may be repeated; default: the last")
                             ->type_name("N")
                             ->expected(1)
                             ->take_all();
    command.add_flag("--all", options->all, "draw all frames")->excludes(frame);
    command.add_flag("--force", options->force, "replace pictures and films of the same names");
    command.callback([&job, options] { job = [options] { return render_run(*options); }; });
}

}  // namespace percuss::app
