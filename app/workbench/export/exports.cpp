#include "workbench/export/exports.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>
#include <utility>

#include <fmt/format.h>
#include <imgui.h>

#include "context/context.hpp"
#include "figures/draw_run.hpp"
#include "figures/run_page.hpp"
#include "live/probe_curves.hpp"
#include "output.hpp"
#include "scene/edit_text.hpp"
#include "scene/parse.hpp"
#include "workbench/export/moments_film.hpp"
#include "workbench/export/plot_files.hpp"

namespace percuss::app {
namespace {

namespace fs = std::filesystem;

std::string write_picture(const fs::path& file, const render::Image& image) {
    if (file.has_parent_path()) fs::create_directories(file.parent_path());
    write_whole(file, [&](const fs::path& aside) { render::write_png(image, aside); });
    return file.string();
}

bool is_drawn(const Workbench& w) { return w.viewport.view && w.viewport.drawn; }

/// "view.KEY=VALUE" for what the picture shows differently from the scene.
void append_view(const Scene& scene, const ViewportState& shown, std::vector<std::string>& overrides) {
    const ViewOptions &now = shown.options, &then = scene.view;
    const auto add = [&](const char* key, const std::string& value) {
        overrides.push_back(fmt::format("view.{}={}", key, value));
    };
    const auto flag = [&](const char* key, bool ViewOptions::*option) {
        if (now.*option != then.*option) add(key, now.*option ? "true" : "false");
    };
    if (now.field != then.field) add("field", fmt::format("\"{}\"", now.field));
    if (now.colour_map != then.colour_map) add("colour_map", fmt::format("\"{}\"", now.colour_map));
    if (now.range && now.range != then.range)
        add("range", fmt::format("[{}, {}]", (*now.range)[0], (*now.range)[1]));
    flag("edges", &ViewOptions::edges);
    flag("mirror", &ViewOptions::mirror);
    flag("forces", &ViewOptions::forces);
    flag("velocities", &ViewOptions::velocities);
}

}  // namespace

/// The figures of a run that are drawn one a frame of the window.
struct Exports::Figures {
    RecordedRun run;
    std::vector<FigureSpec> specs;
    fs::path folder;
    std::size_t next = 0;
};

Exports::Exports() = default;
Exports::~Exports() = default;

fs::path Exports::free_name(const std::string& suffix) {
    const std::string stem = settings.name.empty() ? "percuss" : settings.name;
    const fs::path with = stem + suffix;
    fs::path file = with;
    // Names that are given away may not be on the disk yet.
    for (int i = 2; fs::exists(file) || given_.contains(file); ++i) {
        file = with;
        file.replace_filename(fmt::format("{}-{}{}", with.stem().string(), i, with.extension().string()));
    }
    given_.insert(file);
    return file;
}

void Exports::fail(Workbench& w, const std::string& why) {
    faults_.push_back(why);
    w.tell(why);
}

void Exports::tell_written(Workbench& w, const std::string& file) {
    written_.push_back(file);
    w.tell(fmt::format("written: {}", file));
}

void Exports::save_scene(Workbench& w) {
    if (!w.run.snapshot()) return;
    const Scene& scene = w.run.snapshot()->setup->scene;
    // What the run was built with, then what was set since: it acts in flight and stands in no set-up.
    std::vector<std::string> overrides = scene.overrides;
    for (std::string& later : w.run.overrides()) overrides.push_back(std::move(later));
    if (settings.with_view) append_view(scene, w.viewport, overrides);
    fs::path file = settings.scene;
    if (file.extension() != ".toml") file += ".toml";
    if (!settings.replace && (fs::exists(file) || given_.contains(file)))
        return fail(w, fmt::format("{}: there is one already; choose another name, or tick 'replace'",
                                   file.string()));
    settings.replace = false;
    try {
        std::string text = edit_scene_text(scene.text, scene.file, overrides);
        if (!w.run.probes().empty()) {
            text += "\n" + probes_as_scene_text(w.run.probes());
            static_cast<void>(parse_scene(text, scene.file));  // probes may be written otherwise in it
        }
        writer_.post([file, text = std::move(text)] {
            if (file.has_parent_path()) fs::create_directories(file.parent_path());
            write_text_file(file, text);
            return file.string();
        });
        given_.insert(file);
        settings.scene = free_scene_name(file_, given_).string();
    } catch (const std::exception& error) {
        fail(w, error.what());
    }
}

void Exports::save_picture(Workbench& w) {
    if (!is_drawn(w)) return;
    try {
        const int factor = std::clamp(settings.factor, 1, 8);
        ViewCopy view(w, {factor * w.viewport.drawn_size[0], factor * w.viewport.drawn_size[1]});
        auto image = std::make_shared<render::Image>(view.draw(w, w.viewport.drawn));
        writer_.post([image, file = free_name(".png")] { return write_picture(file, *image); });
    } catch (const std::exception& error) {
        fail(w, error.what());
    }
}

void Exports::save_plot(Workbench& w, const PlotInfo& plot, PlotFormat format) {
    if (!w.run.snapshot() || !w.run.history()) return;
    PlotContents contents = format == PlotFormat::csv ? contents_of(w, plot) : drawn_contents_of(w, plot);
    if (std::all_of(contents.runs.begin(), contents.runs.end(),
                    [](const PlotRun& run) { return run.begin == run.end; }))
        return fail(w, fmt::format("{}: no curve is shown that could be written", plot.title));
    if (format == PlotFormat::csv) {
        writer_.post([contents = std::move(contents), file = free_name("-" + plot.name + ".csv")] {
            if (file.has_parent_path()) fs::create_directories(file.parent_path());
            write_plot_csv(file, contents);
            return file.string();
        });
        return;
    }
    try {
        auto image = std::make_shared<render::Image>(render::draw_figure(
            w.screen.context(), figure_of(contents, w.run.snapshot()->setup->scene.title)));
        writer_.post(
            [image, file = free_name("-" + plot.name + ".png")] { return write_picture(file, *image); });
    } catch (const std::exception& error) {
        fail(w, error.what());
    }
}

void Exports::save_open_plots(Workbench& w, PlotFormat format) {
    for (const PlotInfo& plot : w.plots.plots)
        if (!w.plots.folded.contains(plot.name)) save_plot(w, plot, format);
}

void Exports::begin_figures(Workbench& w) {
    if (!w.run.snapshot() || !w.run.history() || working()) return;
    if (w.run.history()->rows() < 2) return fail(w, "the run has no histories yet to draw figures of");
    const auto newest = w.run.newest();
    RunFrames frames{w.run.timeline().frames, nullptr};
    if (!w.run.recorded()) {
        std::erase_if(frames.times, [&](double time) { return time >= newest->time; });
        frames.times.push_back(newest->time);
    }
    frames.read = [newest, moments = w.run.moments(), recorded = w.run.recorded(),
                   times = frames.times](std::size_t i) {
        if (!recorded && i + 1 == times.size()) return newest;
        auto frame = moments(times[i]);
        while (recorded && !frame) {  // a read takes milliseconds
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
            frame = moments(times[i]);
        }
        return frame ? frame : newest;
    };
    const Scene& scene = newest->setup->scene;
    figures_ = std::make_unique<Figures>(
        Figures{{step_label(scene), newest->setup, w.run.history(), {}, std::move(frames), w.run.traces()},
                {},
                free_name("-figures")});
    figures_->specs = all_figures(figures_->run);
}

void Exports::draw_next_figure(Workbench& w) {
    if (!figures_) return;
    Figures& job = *figures_;
    const FigureSpec& figure = job.specs[job.next];
    try {
        RunPage made = make_run_page(job.run, figure);
        auto image = std::make_shared<render::Image>(render::draw_page(w.screen.context(), made.page));
        const fs::path file = job.folder / (figure.name + ".png");
        writer_.post([image, file, csv = std::move(made.csv)] {
            write_picture(file, *image);
            if (csv) write_text_file(fs::path(file).replace_extension(".csv"), *csv);
            return file.string();
        });
    } catch (const std::exception& error) {
        fail(w, fmt::format("figure '{}': {}", figure.name, error.what()));
    }
    if (++job.next == job.specs.size()) figures_.reset();
}

void Exports::begin_film(Workbench& w, bool film) {
    if (!is_drawn(w) || working()) return;
    const double end = std::max(w.run.timeline().end, w.run.snapshot()->time);
    const double from = std::clamp(settings.from, 0.0, end),
                 to = std::clamp(settings.to.value_or(end), from, end);
    const int count = std::clamp(settings.count, 1, 100000);
    std::vector<double> times;
    for (int i = 0; i < count; ++i) times.push_back(count > 1 ? from + (to - from) * i / (count - 1) : to);
    std::array<int, 2> size = settings.size;
    for (std::size_t k = 0; k < 2; ++k) {
        if (size[k] <= 0) size[k] = w.viewport.drawn_size[k];
        size[k] = std::clamp(size[k], 64, 8192);
    }
    try {
        film_ = std::make_unique<MomentsFilm>(w, free_name(film ? ".mp4" : "-frames"), std::move(times), size,
                                              std::clamp(settings.frames_per_second, 0.1, 240.0));
    } catch (const std::exception& error) {
        fail(w, error.what());
    }
}

void Exports::cancel(Workbench& w) {
    if (!working()) return;
    figures_.reset();
    if (film_) film_->stream.cancel();
    w.tell("cancelled");
}

void Exports::follow_film(Workbench& w) {
    if (!film_) return;
    try {
        film_->advance(w);
    } catch (const std::exception& error) {
        film_->stream.cancel();
        fail(w, fmt::format("{}: {}", film_->stream.target().string(), error.what()));
    }
    const auto outcome = film_->stream.outcome();
    if (!outcome) return;
    if (outcome->written)
        tell_written(w, film_->stream.target().string());
    else if (!outcome->fault.empty())
        fail(w, outcome->fault);
    film_.reset();
}

void Exports::toggle_recording(Workbench& w) {
    if (recording_) {
        recording_->finish();
        ending_.push_back(std::move(recording_));
        return;
    }
    if (!is_drawn(w)) return;
    recording_ = std::make_unique<PictureStream>(free_name("-live.mp4"),
                                                 std::clamp(settings.frames_per_second, 0.1, 240.0));
    recording_due_ = clock_;
    recorded_draw_ = -1;
    recorded_size_ = {0, 0};
}

bool Exports::wants_frame(const Workbench& w) const {
    return recording_ && w.viewport.draws != recorded_draw_ && clock_ >= recording_due_ &&
           !recording_->full();
}

void Exports::take_frame(Workbench& w, const render::Image& window) {
    const WidgetNames::Rect* place = w.names.find("viewport");
    if (!recording_ || place == nullptr) return;
    const auto left =
        static_cast<std::size_t>(std::clamp((*place)[0], 0.0F, static_cast<float>(window.width)));
    const auto top =
        static_cast<std::size_t>(std::clamp((*place)[1], 0.0F, static_cast<float>(window.height)));
    const int width =
        std::min(static_cast<int>((*place)[2] - (*place)[0]), window.width - static_cast<int>(left));
    const int height =
        std::min(static_cast<int>((*place)[3] - (*place)[1]), window.height - static_cast<int>(top));
    if (width < 16 || height < 16) return;
    if (recorded_draw_ >= 0 && recorded_size_ != std::array{width, height}) {
        w.tell("the viewport has another size: the recording ends here");
        toggle_recording(w);
        return;
    }
    const auto row = 3 * static_cast<std::size_t>(width), full = 3 * static_cast<std::size_t>(window.width);
    render::Image image{width, height, std::vector<std::uint8_t>(row * static_cast<std::size_t>(height))};
    for (std::size_t y = 0; y < static_cast<std::size_t>(height); ++y)
        std::copy_n(window.pixels.data() + full * (top + y) + 3 * left, row, image.pixels.data() + row * y);
    recording_->add(std::move(image));
    recorded_size_ = {width, height};
    recorded_draw_ = w.viewport.draws;
    // Due times keep their beat; after a pause it begins anew.
    const double period = 1 / std::clamp(settings.frames_per_second, 0.1, 240.0);
    recording_due_ = std::max(recording_due_ + period, clock_);
}

void Exports::follow_recording(Workbench& w) {
    if (recording_ && recording_->outcome()) ending_.push_back(std::move(recording_));  // it failed
    std::erase_if(ending_, [&](const auto& stream) {
        const auto outcome = stream->outcome();
        if (!outcome) return false;
        if (outcome->written)
            tell_written(w, stream->target().string());
        else
            fail(w, fmt::format("{}: {}", stream->target().string(), outcome->fault));
        return true;
    });
}

void Exports::advance(Workbench& w) {
    clock_ += ImGui::GetIO().DeltaTime;
    if (file_ != w.run.file()) {
        file_ = w.run.file();
        settings.name = file_.stem().string();
        settings.scene = free_scene_name(file_, given_).string();
        settings.from = 0;
        settings.to.reset();
    }
    draw_next_figure(w);
    follow_film(w);
    follow_recording(w);
    for (const Writer::Result& result : writer_.take_results()) {
        if (result.written)
            tell_written(w, result.words);
        else
            fail(w, result.words);
    }
}

bool Exports::working() const { return film_ || figures_; }

double Exports::progress() const {
    if (film_) return film_->progress();
    return figures_ ? static_cast<double>(figures_->next) / static_cast<double>(figures_->specs.size()) : 1;
}

bool Exports::busy() const { return working() || !ending_.empty() || writer_.waiting() > 0; }

fs::path free_scene_name(const fs::path& scene, const std::set<fs::path>& given) {
    for (int i = 1;; ++i) {
        fs::path file = scene;
        file.replace_filename(fmt::format("{}-{}.toml", scene.stem().string(), i));
        if (!fs::exists(file) && !given.contains(file)) return file;
    }
}

}  // namespace percuss::app
