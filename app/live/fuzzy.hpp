#pragma once

#include <string>
#include <vector>

namespace percuss::app {

/// The candidates that have the letters of `typed` in this order, whatever the case and whatever stands
/// between them; those where they stand closest together first, then the shorter, then as given.
[[nodiscard]] std::vector<std::string> fuzzy_matches(const std::string& typed,
                                                     const std::vector<std::string>& candidates);

}  // namespace percuss::app
