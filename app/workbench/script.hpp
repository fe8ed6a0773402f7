#pragma once

#include <chrono>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "ui/input.hpp"
#include "workbench/workbench.hpp"

namespace percuss::app {

/// A script that cannot be read, or whose expectation does not hold: "FILE:LINE: why".
class ScriptError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// One line of a script: a verb and its arguments.
struct ScriptEvent {
    int line = 0;
    std::string verb;
    std::vector<std::string> arguments;
};

/// Reads a script: one event a line, blank lines and what follows '#' are left out, an argument with spaces
/// stands between double quotes. @throws ScriptError for a verb, command or key that there is not, or missing
/// arguments.
[[nodiscard]] std::vector<ScriptEvent> parse_script(const std::string& text, const std::string& file);

/// What scripts can say, one line a verb; part of the program's help.
[[nodiscard]] std::string script_help();

/// Plays a script as mouse, keyboard and commands, some frames an event.
class ScriptPlayer {
  public:
    ScriptPlayer(std::vector<ScriptEvent> events, std::string file)
        : events_(std::move(events)), file_(std::move(file)) {}

    /// Call before each frame: what to do in it. @throws ScriptError.
    [[nodiscard]] const render::ScriptedInput& before_frame(Workbench& workbench);
    [[nodiscard]] bool done() const { return next_ >= events_.size(); }

  private:
    /// @returns whether the event is over; otherwise a frame is drawn before it is called again.
    bool advance(const ScriptEvent& event, Workbench& workbench);
    bool press(const ScriptEvent& event, Workbench& workbench, bool right, int clicks);
    bool drag(const ScriptEvent& event, Workbench& workbench);
    bool wait(const ScriptEvent& event, Workbench& workbench);
    /// Puts the mouse on a widget. @returns false while there is no such widget.
    bool point_at(const ScriptEvent& event, const Workbench& workbench, double across, double down);
    [[noreturn]] void fail(const ScriptEvent& event, const std::string& why) const;

    std::vector<ScriptEvent> events_;
    std::string file_;
    std::size_t next_ = 0;
    int stage_ = 0;    // frames that the present event has had
    int missing_ = 0;  // of them, those in which its widget was not there
    double timeout_ = 60;
    std::chrono::steady_clock::time_point since_ = std::chrono::steady_clock::now();
    render::ScriptedInput input_;
};

}  // namespace percuss::app
