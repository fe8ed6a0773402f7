#include "live/fuzzy.hpp"

#include <algorithm>
#include <cctype>
#include <optional>
#include <tuple>

namespace percuss::app {
namespace {

char lower(char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); }

/// Length of the shortest part that holds all letters in order.
std::optional<std::size_t> spread(const std::string& typed, const std::string& text) {
    if (typed.empty()) return 0;
    std::optional<std::size_t> best;
    for (std::size_t begin = 0; begin < text.size(); ++begin) {
        std::size_t letter = 0, at = begin;
        for (; at < text.size() && letter < typed.size(); ++at)
            if (lower(text[at]) == lower(typed[letter])) ++letter;
        if (letter < typed.size()) break;
        best = std::min(best.value_or(at - begin), at - begin);
    }
    return best;
}

}  // namespace

std::vector<std::string> fuzzy_matches(const std::string& typed, const std::vector<std::string>& candidates) {
    std::vector<std::tuple<std::size_t, std::size_t, std::size_t>> found;  // spread, length, index
    for (std::size_t i = 0; i < candidates.size(); ++i)
        if (const auto wide = spread(typed, candidates[i]))
            found.emplace_back(*wide, typed.empty() ? 0 : candidates[i].size(), i);
    std::sort(found.begin(), found.end());
    // A folder lists what is in it by name.
    if (typed.ends_with('/'))
        std::sort(found.begin(), found.end(), [&](const auto& a, const auto& b) {
            return std::tie(std::get<0>(a), candidates[std::get<2>(a)]) <
                   std::tie(std::get<0>(b), candidates[std::get<2>(b)]);
        });
    std::vector<std::string> matches;
    for (const auto& [wide, length, index] : found) matches.push_back(candidates[index]);
    return matches;
}

}  // namespace percuss::app
