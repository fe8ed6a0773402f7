#include <algorithm>
#include <chrono>
#include <fstream>
#include <iterator>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "commands.hpp"
#include "exit_status.hpp"
#include "finished_run.hpp"
#include "image.hpp"
#include "nearest_name.hpp"
#include "options.hpp"
#include "output.hpp"
#include "recorded_run.hpp"
#include "scene/named_schemes.hpp"
#include "scene/parse.hpp"
#include "ui/screen.hpp"
#include "workbench/lessons.hpp"
#include "workbench/script.hpp"
#include "workbench/workbench.hpp"

namespace percuss::app {
namespace {

using Clock = std::chrono::steady_clock;
constexpr double frame_period = 1.0 / 60;  // [s]

struct ViewCommand {
    std::string scene;
    std::optional<std::string> size, layout;
    std::vector<std::string> overrides, beside;
    std::optional<std::string> script;
    bool headless = false, dark = false;
    double scale = 0;  // percent; 0: as the display says
    int threads = 1;
};

std::vector<ScriptEvent> read_script(const std::string& file) {
    std::ifstream in(file, std::ios::binary);
    if (!in || std::filesystem::is_directory(file)) throw UsageError(fmt::format("{}: cannot be read", file));
    return parse_script({std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()}, file);
}

/// The file that the window's layout is remembered in. Scripts have none unless they are given one.
std::optional<std::filesystem::path> file_of_layout(const ViewCommand& command) {
    if (command.layout) return *command.layout;
    return command.headless || command.script ? std::nullopt : layout_file();
}

WindowLayout remembered(const std::optional<std::filesystem::path>& file) {
    try {
        return file ? read_layout(*file) : WindowLayout{};
    } catch (const LayoutError& error) {
        fmt::print(stderr, "percuss: {}; the window looks as at first\n", error.what());
        return {};
    }
}

/// Writes the window's layout when it has changed, soon after: a crash then loses little.
class LayoutKeeper {
  public:
    explicit LayoutKeeper(std::filesystem::path file) : file_(std::move(file)) {}

    /// @param at_once when the window closes; else once in some seconds.
    void remember(WindowLayout layout, std::array<int, 2> size, bool at_once) {
        const Clock::time_point now = Clock::now();
        if (given_up_ || (!at_once && now < next_)) return;
        next_ = now + std::chrono::seconds(2);
        if (size[0] >= 64 && size[1] >= 64) layout.window = size;  // not that of an icon
        std::string text = layout_text(layout);
        if (text == written_) return;
        try {
            if (file_.has_parent_path()) std::filesystem::create_directories(file_.parent_path());
            write_text_file(file_, text);
            written_ = std::move(text);
        } catch (const std::exception& error) {
            fmt::print(stderr, "percuss: the window's layout is not remembered: {}\n", error.what());
            given_up_ = true;
        }
    }

  private:
    std::filesystem::path file_;
    std::string written_;
    Clock::time_point next_;
    bool given_up_ = false;
};

std::unique_ptr<render::Screen> make_screen(const ViewCommand& command, const WindowLayout& layout) {
    const auto size =
        command.size ? parse_size(*command.size) : layout.window.value_or(std::array{1280, 720});
    const double scale = command.scale > 0 ? command.scale / 100 : layout.scale.value_or(0);
    if (command.headless) return render::make_offscreen(size, scale);
    try {
        return render::make_window("percuss", size, scale);
    } catch (const render::RenderError& error) {
        throw render::RenderError(
            fmt::format("{}; without a display there are 'percuss run', 'render', 'figures' and 'view "
                        "--headless --script FILE'",
                        error.what()));
    }
}

void write_screenshot(Workbench& workbench, const render::Screen& screen) {
    if (!workbench.screenshot) return;
    const std::filesystem::path file = *std::exchange(workbench.screenshot, std::nullopt);
    try {
        write_whole(file,
                    [&](const std::filesystem::path& aside) { render::write_png(screen.grabbed(), aside); });
        workbench.tell(fmt::format("written: {}", file.string()));
    } catch (const std::exception& error) {
        workbench.tell(error.what());
    }
}

/// Leaves the processor to the engine until the next frame is due; asleep when there is nothing to show.
void rest(render::Screen& screen, const Workbench& workbench, Clock::time_point frame_began, bool scripted) {
    const double left = frame_period - std::chrono::duration<double>(Clock::now() - frame_began).count();
    const bool waits = workbench.run.building() || workbench.exports.busy() ||
                       workbench.run.status() == RunStatus::running || workbench.run.playing() ||
                       workbench.beside_busy() || workbench.run.reading();
    if (scripted) {
        if (waits && left > 0) screen.rest(left);
    } else if (workbench.at_rest()) {
        screen.rest(0.1);
    } else if (left > 0) {
        screen.rest(left);
    }
}

/// Puts runs beside the one that is opened: "scheme=NAME", or a value as --set.
void add_beside(Workbench& workbench, const ViewCommand& command) {
    for (const std::string& wanted : command.beside) {
        const auto equals = wanted.find('=');
        if (equals == std::string::npos || equals == 0)
            throw UsageError(fmt::format("--beside {}: write scheme=NAME or KEY=VALUE", wanted));
        const std::string key = wanted.substr(0, equals), value = wanted.substr(equals + 1);
        std::vector<std::string> all = command.overrides;
        if (key != "scheme") {
            all.push_back(wanted);
            static_cast<void>(load_scene(command.scene, all));
            workbench.add_beside(command.scene, all, key.substr(key.rfind('.') + 1) + " " + value);
            continue;
        }
        const NamedScheme* scheme = find_scheme(value);
        if (scheme == nullptr)
            throw UsageError(
                fmt::format("--beside: unknown scheme '{}'{}", value, suggest_name(value, scheme_names())));
        for (std::string& setting : scheme_overrides(*scheme, load_scene(command.scene, command.overrides)))
            all.push_back(std::move(setting));
        static_cast<void>(load_scene(command.scene, all));
        workbench.add_beside(command.scene, all, value);
    }
}

int view(const ViewCommand& command) {
    if (command.headless && !command.script)
        throw UsageError("view --headless draws nothing that anybody sees; give it --script FILE");
    if (std::filesystem::path(command.scene).extension() == ".h5" ||
        std::filesystem::is_directory(command.scene)) {
        static_cast<void>(run_file_of(command.scene));
        for (const auto& [given, option] :
             {std::pair(&command.overrides, "--set"), std::pair(&command.beside, "--beside")})
            if (!given->empty())
                throw UsageError(fmt::format("{}: a recorded run stays as it was; {} is for scenes",
                                             command.scene, option));
    }
    std::optional<ScriptPlayer> player;
    if (command.script) player.emplace(read_script(*command.script), *command.script);
    const auto layout_kept = file_of_layout(command);
    WindowLayout layout = remembered(layout_kept);
    const std::unique_ptr<render::Screen> screen = make_screen(command, layout);
    EngineOptions options;
    options.threads = command.threads;
    options.history_memory = std::size_t{256} << 20;  // a window may stay open for days
    Workbench workbench(*screen, std::move(options), open_recorded_run);
    workbench.use_layout(std::move(layout));
    if (command.dark) screen->set_dark(true);
    if (layout_kept) workbench.thumbnails.keep_in(thumbnail_folder());
    if (command.scene == "lessons" && !std::filesystem::exists(command.scene))
        list_lessons(workbench);
    else if (command.scene.empty())
        workbench.pick_scene = !player;
    else
        workbench.run.open(command.scene, command.overrides);
    std::optional<LayoutKeeper> keeper;
    if (layout_kept) keeper.emplace(*layout_kept);
    add_beside(workbench, command);
    while (!workbench.quit) {
        const Clock::time_point began = Clock::now();
        const render::ScriptedInput* input = player ? &player->before_frame(workbench) : nullptr;
        if (player && player->done()) break;
        if (!screen->begin_frame(input)) break;
        workbench.frame();
        const bool record = workbench.exports.wants_frame(workbench);
        screen->end_frame(record || workbench.screenshot.has_value());
        workbench.timing.count(
            workbench.run, began, Clock::now(),
            workbench.viewport.drawn && workbench.viewport.drawn == workbench.run.snapshot());
        if (record) workbench.exports.take_frame(workbench, screen->grabbed());
        write_screenshot(workbench, *screen);
        if (keeper) keeper->remember(workbench.layout, screen->size(), false);
        rest(*screen, workbench, began, player.has_value());
    }
    if (keeper) keeper->remember(workbench.layout, screen->size(), true);
    return exit_status::ok;
}

}  // namespace

void add_view(CLI::App& app, Job& job) {
    auto options = std::make_shared<ViewCommand>();
    CLI::App& command =
        *app.add_subcommand("view", "Open a window on a scene that runs, or on a recorded run");
    command.footer(fmt::format(
        "In the window F1 lists all keys and commands. A script is a text file, one event a line:\n{}"
        "NAME is one of {}.\nIts screenshots and expectations are the same in a window and with "
        "--headless; exit status 1 when\nan expectation does not hold.",
        script_help(), fmt::join(Workbench::value_names(), ", ")));
    command.add_option(
        "SCENE", options->scene,
        "scene file, e.g. scenes/nail.toml, or a recorded run: its directory or run.h5; without "
        "one the window asks for it, with the word lessons for one of the lessons");
    command.add_option("--set", options->overrides, "override a value of the scene; may be repeated")
        ->type_name("KEY=VALUE")
        ->expected(1)
        ->take_all();
    command
        .add_option("--beside", options->beside,
                    "another run of the scene beside it, at the same time: scheme=NAME (see 'percuss compare "
                    "--help') or KEY=VALUE as --set; may be repeated")
        ->type_name("KEY=VALUE")
        ->expected(1)
        ->take_all();
    command
        .add_option("--size", options->size,
                    "of the window [pixels]; default: as it was left, 1280x720 at first")
        ->type_name("WxH");
    command
        .add_option("--layout", options->layout,
                    "file that remembers panels, folded plots, letters, window and recent scenes; "
                    "default: $XDG_STATE_HOME/percuss/window.json, none with --script")
        ->type_name("FILE.json");
    command
        .add_option("--scale", options->scale, "of text and widgets [percent]; default: as the display says")
        ->check(CLI::Range(75.0, 250.0));
    command.add_option("--threads", options->threads, "of the engine")
        ->check(CLI::Range(1, 1024))
        ->capture_default_str();
    command.add_flag("--dark", options->dark, "light letters on dark panels");
    command.add_option("--script", options->script, "play this script, then close")->type_name("FILE");
    command.add_flag("--offscreen,--headless", options->headless,
                     "no window and no display: a script draws into memory");
    command.callback([&job, options] { job = [options] { return view(*options); }; });
}

}  // namespace percuss::app
