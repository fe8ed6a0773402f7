#pragma once

#include <optional>
#include <string>
#include <vector>

#include "figures/scheme_page.hpp"

namespace percuss::app {

/// What cases are made of: all schemes with all steps with all values.
struct SchemeGrid {
    std::vector<std::string> schemes;  ///< empty: every one that the scene can take
    std::vector<double> steps;         ///< fractions of the critical step; empty: the scene's own
    std::string key;                   ///< of `values`, "" without
    std::vector<std::string> values;
};

/// A scene as it is to be run.
struct SchemeCase {
    Scene scene;
    std::string scheme, variant, label;
};

/// @throws UsageError naming the scheme that does not exist or that the scene cannot take; SceneError.
[[nodiscard]] std::vector<SchemeCase> make_cases(const std::string& file,
                                                 const std::vector<std::string>& overrides,
                                                 const SchemeGrid& grid);

/// Runs it to its end or its divergence. Nothing when it was interrupted.
[[nodiscard]] std::optional<CaseRun> run_case(const SchemeCase& of, int threads);

}  // namespace percuss::app
