#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace percuss {

/// The name nearest to `wanted` by edit distance (Levenshtein), "" when `names` is empty.
[[nodiscard]] std::string nearest_name(std::string_view wanted, std::span<const std::string> names);

/// "; did you mean 'x'?" when a name is near enough to be a slip of the pen, else "; valid: a, b, c".
[[nodiscard]] std::string suggest_name(std::string_view wanted, std::span<const std::string> names);

}  // namespace percuss
