#pragma once

#include <string>

namespace percuss {

/// A cell of a CSV: names come from scenes, and a comma or quote in one must not shift the columns.
[[nodiscard]] inline std::string csv_cell(const std::string& cell) {
    if (cell.find_first_of(",\"\n") == std::string::npos) return cell;
    std::string result = "\"";
    for (const char c : cell) result.append(c == '"' ? 2 : 1, c);
    return result + '"';
}

}  // namespace percuss
