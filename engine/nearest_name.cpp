#include "nearest_name.hpp"

#include <algorithm>
#include <cctype>
#include <numeric>

namespace percuss {
namespace {

/// Levenshtein distance, case-insensitive: a capital is no slip worth a longer list.
std::size_t edit_distance(std::string_view a, std::string_view b) {
    const auto lower = [](char c) { return std::tolower(static_cast<unsigned char>(c)); };
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i + 1;
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t substituted = diagonal + (lower(a[i]) == lower(b[j]) ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({substituted, row[j] + 1, row[j + 1] + 1});
        }
    }
    return row.back();
}

}  // namespace

std::string nearest_name(std::string_view wanted, std::span<const std::string> names) {
    // Names are short; a cut bounds the work that a hostile scene can ask for.
    const auto cut = wanted.substr(0, 200);
    const auto nearest = std::min_element(names.begin(), names.end(), [&](const auto& a, const auto& b) {
        return edit_distance(cut, a) < edit_distance(cut, b);
    });
    return nearest == names.end() ? std::string() : *nearest;
}

std::string suggest_name(std::string_view wanted, std::span<const std::string> names) {
    const std::string nearest = nearest_name(wanted, names);
    if (nearest.empty()) return "; there are none";
    const std::size_t slip = 1 + std::min(wanted.size(), nearest.size()) / 3;
    if (edit_distance(wanted.substr(0, 200), nearest) <= slip && nearest.size() > 1)
        return "; did you mean '" + nearest + "'?";
    std::string list = "; valid: ";
    for (std::size_t i = 0; i < names.size(); ++i) list += (i == 0 ? "" : ", ") + names[i];
    return list;
}

}  // namespace percuss
