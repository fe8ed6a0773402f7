#include <algorithm>
#include <chrono>
#include <cstdio>
#include <optional>

#include <fmt/format.h>

#include "commands.hpp"
#include "drawing.hpp"
#include "exit_status.hpp"
#include "figures/draw_run.hpp"
#include "interrupt.hpp"
#include "options.hpp"
#include "output.hpp"
#include "progress.hpp"
#include "record/run_file.hpp"
#include "record/summary.hpp"
#include "report.hpp"
#include "session.hpp"
#include "study/accuracy.hpp"

namespace percuss::app {
namespace {

using Clock = std::chrono::steady_clock;

struct RunOptions {
    SceneOptions scene;
    std::string out;
    std::optional<double> frames;
    std::optional<std::string> film;
    bool no_render = false, force = false, strict = false;
    int threads = 1;
};

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Adds the wall time of its scope to a sum.
class Stopwatch {
  public:
    explicit Stopwatch(double& sum) : sum_(sum) {}
    ~Stopwatch() { sum_ += seconds_since(start_); }
    Stopwatch(const Stopwatch&) = delete;
    Stopwatch& operator=(const Stopwatch&) = delete;

  private:
    double& sum_;
    Clock::time_point start_ = Clock::now();
};

/// Records and draws the frames of a run on the thread that owns the OpenGL context.
class Recorder {
  public:
    Recorder(const OutputDirectory& out, std::shared_ptr<const RunSetup> setup,
             std::shared_ptr<const History> history, const std::vector<Trace>& traces,
             std::optional<DrawingTargets> drawing)
        : history_(std::move(history)), writer_(out.run_file(), setup, history_->columns(), traces) {
        if (drawing) drawing_.emplace(setup, setup->scene.view, std::move(*drawing));
    }

    void add(const Snapshot& frame) {
        // The end may fall on a multiple of the interval; that of a diverged run says why all the same.
        if (frame.step == last_step_ && frame.status != RunStatus::diverged) return;
        last_step_ = frame.step;
        {
            const Stopwatch watch(record_seconds);
            writer_.add_history(*history_);
            writer_.add_frame(frame);
        }
        const Stopwatch watch(render_seconds);
        if (drawing_) drawing_->add(frame, history_.get(), frames_);
        ++frames_;
    }

    void finish_histories(const OutputDirectory& out, const Scene& scene) {
        {
            const Stopwatch watch(record_seconds);
            writer_.add_history(*history_);
            write_whole(out.history_file(), [&](const std::filesystem::path& aside) {
                write_history_csv(aside, *history_, scene.units, scene.record.history_every);
            });
        }
        const Stopwatch watch(render_seconds);
        if (drawing_) drawing_->finish();
    }

    void finish(const std::string& summary) {
        writer_.finish(summary);
        drawing_.reset();
    }
    [[nodiscard]] long long frames() const { return frames_; }

    double record_seconds = 0, render_seconds = 0;

  private:
    std::shared_ptr<const History> history_;
    RunFileWriter writer_;
    std::optional<Drawing> drawing_;
    std::int64_t last_step_ = -1;
    long long frames_ = 0;
};

/// Takes frames until the engine rests. @returns whether it was interrupted.
bool follow(Session& session, Recorder& recorder, const Scene& scene, std::int64_t cells) {
    using namespace std::chrono_literals;
    const InterruptGuard guard;
    bool interrupted = false;
    const Clock::time_point start = Clock::now();
    const bool terminal = stderr_is_terminal();
    Progress progress(scene.duration, cells, scene.units, terminal);
    Clock::time_point shown = start;
    const auto show = [&](const Snapshot& snapshot) {
        progress.show({snapshot.time, snapshot.step, seconds_since(start)});
        shown = Clock::now();
    };
    session.start();
    while (!session.frames().drained()) {
        const FrameQueue::Frame frame = session.frames().pop(50ms);
        if (frame) recorder.add(*frame);
        if (frame && !terminal) show(*frame);
        if (terminal && seconds_since(shown) > 0.1) show(*session.engine().snapshot());
        if (!interrupted && InterruptGuard::requested()) {
            interrupted = true;
            session.interrupt();
        }
    }
    const auto last = session.engine().snapshot();
    recorder.add(*last);
    show(*last);
    return interrupted;
}

/// A scene promises what it does as it is written; a step or a mesh set from outside may break that with good
/// right.
bool as_written(const Scene& scene) {
    return std::all_of(scene.overrides.begin(), scene.overrides.end(), [](const std::string& override_text) {
        return override_text.starts_with("expect.") || override_text.starts_with("view.");
    });
}

int run(const RunOptions& options) {
    const Clock::time_point start = Clock::now();
    if (options.no_render && options.film) throw UsageError("--film needs pictures: leave --no-render out");
    if (options.film) check_film(*options.film, options.force);
    Scene scene = load(options.scene);
    std::optional<AccuracyChoice> accuracy;
    if (scene.accuracy) {
        bool interrupted = false;
        accuracy = choose_accuracy(scene, interrupted);
        if (interrupted) return exit_status::interrupted;
    }
    if (accuracy) {
        fmt::print(accuracy->within ? stdout : stderr, "{}\n", accuracy->text);
        SceneOptions chosen = options.scene;
        chosen.overrides.insert(chosen.overrides.end(), accuracy->overrides.begin(),
                                accuracy->overrides.end());
        scene = load(chosen);
    }
    OutputDirectory out(options.out, options.force);
    const double interval = options.frames.value_or(scene.record.frames.value_or(scene.duration / 100));
    Session session(scene, interval, options.threads);
    const auto first = session.engine().snapshot();
    const std::int64_t cells = first->setup->mesh.cell_count();

    std::optional<DrawingTargets> drawing;
    if (!options.no_render) drawing = DrawingTargets{out.frames(), options.film};
    out.make();
    Recorder recorder(out, first->setup, session.engine().history(), session.engine().traces(),
                      std::move(drawing));
    const bool interrupted = follow(session, recorder, scene, cells);

    const auto last = session.engine().snapshot();
    recorder.finish_histories(out, scene);
    RunStatistics statistics = session.engine().statistics();
    statistics.seconds.record = recorder.record_seconds;
    statistics.seconds.render = recorder.render_seconds;
    statistics.total_seconds = seconds_since(start);
    auto summary = make_summary(*last->setup, statistics, *session.engine().history(), *last);
    if (accuracy) summary["accuracy"] = accuracy->record;
    recorder.finish(summary.dump(2));
    write_text_file(out.summary_file(), summary.dump(2) + "\n");

    print_results(*last, statistics);
    const bool judged =
        !interrupted && last->status != RunStatus::diverged && (options.strict || as_written(scene));
    const bool kept = !judged || print_promises(scene, summary);
    fmt::print("{}\n{}\n{}\n", out.run_file().string(), out.history_file().string(),
               out.summary_file().string());
    if (!options.no_render) {
        fmt::print("{} (to {})\n", (out.frames() / frame_name(0)).string(),
                   frame_name(recorder.frames() - 1));
    }
    if (options.film) fmt::print("{}\n", *options.film);
    if (!options.no_render)
        for (const auto& file : draw_declared_figures(out.run_file(), out.figures()))
            fmt::print("{}\n", file.string());
    if (last->status == RunStatus::diverged) return exit_status::run_failed;
    if (interrupted && last->status != RunStatus::finished) return exit_status::interrupted;
    return kept || !options.strict ? exit_status::ok : exit_status::promise_broken;
}

}  // namespace

void add_run(CLI::App& app, Job& job) {
    auto options = std::make_shared<RunOptions>();
    CLI::App& command = *app.add_subcommand("run", "Compute a scene, record it, draw it");
    command.footer(
        "DIR holds run.h5, history.csv, summary.json and frames/000000.png, ...; Ctrl-C ends a run early "
        "with complete files.");
    add_scene_options(command, options->scene);
    command.add_option("--out", options->out, "directory for the results; made if needed")
        ->type_name("DIR")
        ->required();
    command
        .add_option("--frames", options->frames, "simulated time between frames, in the scene's unit of time")
        ->type_name("DT")
        ->check(CLI::PositiveNumber);
    command.add_option("--film", options->film, "also make a film (mp4, through ffmpeg)")
        ->type_name("FILE.mp4");
    command.add_flag("--no-render", options->no_render, "record only, draw nothing");
    command
        .add_option("--threads", options->threads,
                    "threads that step the elements; results do not depend on it")
        ->type_name("N")
        ->check(CLI::Range(1, 256))
        ->capture_default_str();
    command.add_flag("--force", options->force, "replace an earlier run in DIR; other files in it stay");
    command.add_flag("--strict", options->strict,
                     "judge the scene's promises [expect] even with --set, exit with 3 when one is broken");
    command.callback([&job, options] { job = [options] { return run(*options); }; });
}

}  // namespace percuss::app
