#include "scene/input_limits.hpp"

#include <algorithm>

namespace percuss {
namespace {

constexpr std::size_t most_bytes = 8'000'000;
constexpr int most_dots = 64;

/// First position after the string or comment that begins at `at`.
std::size_t skip(std::string_view text, std::size_t at) {
    const char quote = text[at];
    if (quote == '#') return std::min(text.find('\n', at), text.size());
    const std::string three(3, quote);
    const bool several_lines = text.substr(at, 3) == three;
    for (at += several_lines ? 3 : 1; at < text.size(); ++at) {
        if (text[at] == '\\' && quote == '"') {
            ++at;
        } else if (!several_lines && (text[at] == quote || text[at] == '\n')) {
            return at + 1;
        } else if (several_lines && text.substr(at, 3) == three) {
            at += 3;
            // Up to two quotes may stand before the closing three.
            for (int i = 0; i < 2 && at < text.size() && text[at] == quote; ++i) ++at;
            return at;
        }
    }
    return text.size();
}

}  // namespace

std::optional<std::pair<Place, std::string>> fault_of_input(std::string_view text) {
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    if (text.size() > most_bytes)
        return std::pair(Place{1, 1}, "the scene has " + std::to_string(text.size()) + " bytes; at most " +
                                          std::to_string(most_bytes) + " are read");
    int dots = 0;
    const auto fault = [&](std::size_t at, std::string message) {
        const auto before = text.substr(0, at);
        const auto line = 1 + std::count(before.begin(), before.end(), '\n');
        // npos + 1 is 0, the beginning of the first line.
        const auto column = at - (before.rfind('\n') + 1) + 1;
        return std::pair(Place{static_cast<int>(line), static_cast<int>(column)}, std::move(message));
    };
    for (std::size_t at = text.starts_with(byte_order_mark) ? byte_order_mark.size() : 0; at < text.size();) {
        const char c = text[at];
        if (c == '"' || c == '\'' || c == '#') {
            at = skip(text, at);
            continue;
        }
        if (static_cast<unsigned char>(c) > 127)
            return fault(at, "a character beyond ASCII outside quotes; write it inside \"...\"");
        if (c == '.' && ++dots > most_dots)
            return fault(
                at, "a key of more than " + std::to_string(most_dots) + " dots; the deepest key has 5 parts");
        if (std::string_view("=,[]{}\n").find(c) != std::string_view::npos) dots = 0;
        ++at;
    }
    return std::nullopt;
}

}  // namespace percuss
