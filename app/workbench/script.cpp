#include "workbench/script.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <string_view>

#include <fmt/format.h>

#include "nearest_name.hpp"
#include "workbench/command_table.hpp"

namespace percuss::app {
namespace {

struct Verb {
    const char* name;
    std::size_t least, most;  // arguments
    const char* usage;
    const char* help;
};

constexpr std::size_t any = 1000;
constexpr std::array verbs{
    Verb{"open", 1, 1, "open FILE", "opens a scene"},
    Verb{"do", 1, 1, "do COMMAND", "a command of the help page (F1), e.g. run.toggle"},
    Verb{"click", 1, 3, "click WIDGET [X Y]",
         "at fractions of its width and height, from its upper left; default 0.5 0.5"},
    Verb{"double-click", 1, 3, "double-click WIDGET [X Y]", ""},
    Verb{"right-click", 1, 3, "right-click WIDGET [X Y]", ""},
    Verb{"move", 1, 3, "move WIDGET [X Y]", "rests the mouse on it"},
    Verb{"drag", 5, 5, "drag WIDGET X Y X Y", "presses at the first place, lets go at the second"},
    Verb{"wheel", 2, 4, "wheel WIDGET NOTCHES [X Y]", "positive: away from you"},
    Verb{"key", 1, 1, "key KEY", "e.g. Space, Ctrl+L, F1"},
    Verb{"type", 1, 1, "type TEXT", "into the field that was clicked"},
    Verb{"set", 2, 2, "set KEY VALUE", "a value of the scene, as --set"},
    Verb{"until", 1, 1, "until TIME", "the time of the command run.until, in scene units"},
    Verb{"resize", 2, 2, "resize W H", "the window [pixels]; a display may not grant it"},
    Verb{"frames", 1, 1, "frames N", "draws N frames"},
    Verb{"wait", 3, 3, "wait NAME OP VALUE", "until it holds; OP: = != < > <= >= contains"},
    Verb{"expect", 3, 3, "expect NAME OP VALUE", "fails when it does not hold"},
    Verb{"timeout", 1, 1, "timeout SECONDS", "of every wait from here on; 60 at the start"},
    Verb{"screenshot", 1, 1, "screenshot FILE.png", ""},
    Verb{"print", 1, 1, "print NAME", "a value of the workbench, on standard output"},
    Verb{"widgets", 0, 0, "widgets",
         "prints all widgets on the screen: left, top, right, bottom [pixels], name"},
};

const Verb* find_verb(const std::string& name) {
    const auto* found =
        std::find_if(verbs.begin(), verbs.end(), [&](const Verb& v) { return name == v.name; });
    return found == verbs.end() ? nullptr : found;
}

std::optional<double> number(const std::string& text) {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
    return value;
}

/// Words of a line; a '#' outside quotes ends it.
std::vector<std::string> words_of(std::string_view line) {
    std::vector<std::string> words;
    for (std::size_t at = 0; at < line.size();) {
        if (line[at] == '#') break;
        if (line[at] == ' ' || line[at] == '\t' || line[at] == '\r') {
            ++at;
            continue;
        }
        const bool quoted = line[at] == '"';
        const std::size_t begin = quoted ? at + 1 : at;
        const std::size_t end = std::min(line.find_first_of(quoted ? "\"" : " \t\r", begin), line.size());
        words.emplace_back(line.substr(begin, end - begin));
        at = quoted ? end + 1 : end;
    }
    return words;
}

/// What is wrong with an event; "" when nothing is.
std::string fault_of(const ScriptEvent& event) {
    const Verb* verb = find_verb(event.verb);
    if (verb == nullptr) {
        std::vector<std::string> names;
        for (const Verb& v : verbs) names.emplace_back(v.name);
        return fmt::format("unknown event '{}'{}", event.verb, suggest_name(event.verb, names));
    }
    const auto& arguments = event.arguments;
    const std::size_t count = arguments.size();
    if (count < verb->least || count > verb->most) return fmt::format("write: {}", verb->usage);
    if (event.verb == "do" && find_command(arguments[0]) == nullptr) {
        std::vector<std::string> names;
        for (const WorkbenchCommand& command : workbench_commands()) names.push_back(command.name);
        return fmt::format("unknown command '{}'{}", arguments[0], suggest_name(arguments[0], names));
    }
    if (event.verb == "key" && parse_key(arguments[0]).key == 0)
        return fmt::format("unknown key '{}'; write e.g. Space, Right, Ctrl+L, F1", arguments[0]);
    const bool numbers = event.verb == "click" || event.verb == "double-click" ||
                         event.verb == "right-click" || event.verb == "move" || event.verb == "drag" ||
                         event.verb == "wheel";
    if (numbers) {
        for (std::size_t i = 1; i < count; ++i)
            if (!number(arguments[i]))
                return fmt::format("'{}' is no number; write: {}", arguments[i], verb->usage);
        if (event.verb != "wheel" && event.verb != "drag" && count == 2)
            return fmt::format("write: {}", verb->usage);
        if (event.verb == "wheel" && count == 3) return fmt::format("write: {}", verb->usage);
    }
    if (event.verb == "resize")
        for (const std::string& side : arguments)
            if (const auto pixels = number(side);
                !pixels || *pixels < 1 || *pixels > 16384 || *pixels != std::floor(*pixels))
                return fmt::format("'{}' is no number of pixels from 1 to 16384", side);
    if ((event.verb == "frames" || event.verb == "timeout" || event.verb == "until") && !number(arguments[0]))
        return fmt::format("'{}' is no number", arguments[0]);
    if (event.verb == "wait" || event.verb == "expect") {
        constexpr std::array<std::string_view, 7> operators{"=", "!=", "<", ">", "<=", ">=", "contains"};
        if (std::find(operators.begin(), operators.end(), arguments[1]) == operators.end())
            return fmt::format("'{}' is no comparison; there are = != < > <= >= contains", arguments[1]);
    }
    return "";
}

std::string text_of(const Workbench::Value& value) {
    if (const auto* words = std::get_if<std::string>(&value)) return *words;
    return fmt::format("{:.12g}", std::get<double>(value));
}

bool holds(const Workbench::Value& value, const std::string& comparison, const std::string& wanted) {
    if (comparison == "contains") return text_of(value).find(wanted) != std::string::npos;
    const auto right = number(wanted);
    const auto* left = std::get_if<double>(&value);
    if (left == nullptr || !right) return (comparison == "=") == (text_of(value) == wanted);
    const bool equal = std::abs(*left - *right) <= 1e-9 * std::max(std::abs(*left), std::abs(*right));
    if (comparison == "=") return equal;
    if (comparison == "!=") return !equal;
    if (comparison == "<") return *left < *right;
    if (comparison == ">") return *left > *right;
    return equal || (comparison == "<=" ? *left < *right : *left > *right);
}

double fraction(const ScriptEvent& event, std::size_t index) {
    return event.arguments.size() > index ? *number(event.arguments[index]) : 0.5;
}

}  // namespace

std::vector<ScriptEvent> parse_script(const std::string& text, const std::string& file) {
    std::vector<ScriptEvent> events;
    int line = 0;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        ++line;
        std::vector<std::string> words = words_of(std::string_view(text).substr(begin, end - begin));
        begin = end + 1;
        if (words.empty()) continue;
        ScriptEvent event{line, words.front(), {words.begin() + 1, words.end()}};
        if (const std::string fault = fault_of(event); !fault.empty())
            throw ScriptError(fmt::format("{}:{}: {}", file, line, fault));
        events.push_back(std::move(event));
    }
    return events;
}

std::string script_help() {
    std::string text;
    for (const Verb& verb : verbs) text += fmt::format("  {:<28} {}\n", verb.usage, verb.help);
    return text;
}

void ScriptPlayer::fail(const ScriptEvent& event, const std::string& why) const {
    throw ScriptError(fmt::format("{}:{}: {}", file_, event.line, why));
}

const render::ScriptedInput& ScriptPlayer::before_frame(Workbench& workbench) {
    input_.wheel = 0;
    input_.text.clear();
    while (!done()) {
        if (stage_ == 0) since_ = std::chrono::steady_clock::now();
        if (!advance(events_[next_], workbench)) {
            ++stage_;
            return input_;
        }
        ++next_;
        stage_ = missing_ = 0;
    }
    return input_;
}

bool ScriptPlayer::point_at(const ScriptEvent& event, const Workbench& workbench, double across,
                            double down) {
    const auto* place = workbench.names.find(event.arguments[0]);
    if (place == nullptr) {
        // A list opens a frame or two after the click; what is not there by then will not come.
        if (++missing_ > 30)
            fail(event, fmt::format("no widget '{}' on the screen{}", event.arguments[0],
                                    suggest_name(event.arguments[0], workbench.names.all())));
        return false;
    }
    const auto [left, top, right, bottom] = *place;
    input_.mouse = {left + static_cast<float>(across) * (right - left),
                    top + static_cast<float>(down) * (bottom - top)};
    return true;
}

bool ScriptPlayer::press(const ScriptEvent& event, Workbench& workbench, bool right, int clicks) {
    const int stage = stage_ - missing_;
    if (stage == 0) {
        const double across = fraction(event, 1), down = fraction(event, 2);
        point_at(event, workbench, across, down);
        return false;
    }
    bool& button = right ? input_.right_pressed : input_.pressed;
    button = stage % 2 == 1 && stage < 2 * clicks;
    return stage > 2 * clicks;  // a frame has been drawn after the button was let go
}

bool ScriptPlayer::drag(const ScriptEvent& event, Workbench& workbench) {
    constexpr int moves = 6;
    const int stage = stage_ - missing_;
    const double x0 = fraction(event, 1), y0 = fraction(event, 2), x1 = fraction(event, 3),
                 y1 = fraction(event, 4);
    if (stage == 0) {
        point_at(event, workbench, x0, y0);
        return false;
    }
    const double part = std::clamp((stage - 1.0) / moves, 0.0, 1.0);
    if (stage <= moves + 1) point_at(event, workbench, x0 + part * (x1 - x0), y0 + part * (y1 - y0));
    input_.pressed = stage <= moves + 2;
    return stage > moves + 4;
}

bool ScriptPlayer::wait(const ScriptEvent& event, Workbench& workbench) {
    const auto value = workbench.value(event.arguments[0]);
    if (value && holds(*value, event.arguments[1], event.arguments[2])) return true;
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - since_).count();
    if (seconds > timeout_)
        fail(event,
             fmt::format("waited {:g} s for {} {} {}; it is {}", timeout_, event.arguments[0],
                         event.arguments[1], event.arguments[2], value ? text_of(*value) : "not there"));
    return false;
}

bool ScriptPlayer::advance(const ScriptEvent& event, Workbench& workbench) {
    const std::string& verb = event.verb;
    const auto& arguments = event.arguments;
    const int stage = stage_ - missing_;
    if (verb == "click") return press(event, workbench, false, 1);
    if (verb == "double-click") return press(event, workbench, false, 2);
    if (verb == "right-click") return press(event, workbench, true, 1);
    if (verb == "drag") return drag(event, workbench);
    if (verb == "wait") return wait(event, workbench);
    if (verb == "move") {
        if (stage == 0) point_at(event, workbench, fraction(event, 1), fraction(event, 2));
        return stage > 2;
    }
    if (verb == "wheel") {
        if (stage == 0) point_at(event, workbench, fraction(event, 2), fraction(event, 3));
        if (stage == 1) input_.wheel = static_cast<float>(*number(arguments[1]));
        return stage > 2;
    }
    if (verb == "key") {
        const KeyChord chord = parse_key(arguments[0]);
        input_.ctrl = chord.ctrl && stage < 2;
        input_.keys.clear();
        if (stage == 1) input_.keys.push_back(chord.key);
        return stage > 2;
    }
    if (verb == "frames") return stage >= static_cast<int>(*number(arguments[0]));
    if (verb == "screenshot") {
        if (stage == 0) workbench.screenshot = arguments[0];
        return stage > 0;
    }
    if (verb == "expect") {
        const auto value = workbench.value(arguments[0]);
        if (!value)
            fail(event, fmt::format("there is no value '{}' now{}", arguments[0],
                                    suggest_name(arguments[0], Workbench::value_names())));
        if (!holds(*value, arguments[1], arguments[2]))
            fail(event, fmt::format("expected {} {} {}; it is {}", arguments[0], arguments[1], arguments[2],
                                    text_of(*value)));
        return true;
    }
    if (verb == "timeout") {
        timeout_ = *number(arguments[0]);
        return true;
    }
    if (verb == "print") {
        const auto value = workbench.value(arguments[0]);
        fmt::print("{} = {}\n", arguments[0], value ? text_of(*value) : "not there");
        return true;
    }
    if (verb == "widgets") {
        for (const std::string& name : workbench.names.all()) {
            const auto [left, top, right, bottom] = *workbench.names.find(name);
            fmt::print("widget {:.0f} {:.0f} {:.0f} {:.0f} {}\n", left, top, right, bottom, name);
        }
        return true;
    }
    // The rest acts at once and is seen in the next frame.
    if (stage == 0) {
        if (verb == "open") workbench.open(arguments[0]);
        if (verb == "do") workbench.do_command(arguments[0]);
        if (verb == "set") workbench.run.set(arguments[0], arguments[1]);
        if (verb == "resize")
            workbench.screen.resize(
                {static_cast<int>(*number(arguments[0])), static_cast<int>(*number(arguments[1]))});
        if (verb == "until") workbench.until = *number(arguments[0]);
        if (verb == "type") input_.text = arguments[0];
    }
    return stage > 0;
}

}  // namespace percuss::app
