#pragma once

#include <optional>
#include <string>
#include <vector>

namespace percuss::app {

/// What `percuss compare` was asked for; which of both kinds is clear from what A is.
struct CompareOptions {
    std::string a, b, out;
    std::optional<std::string> csv;
    std::optional<double> least;         ///< of two runs: smallest difference listed [percent]
    std::vector<std::string> schemes;    ///< of a scene, as are those below
    std::vector<double> steps;           ///< fractions of the critical step
    std::optional<std::string> vary;     ///< "parameters.NAME=1,2,3"
    std::vector<std::string> overrides;  ///< as --set
    int threads = 1;
    bool force = false;
};

/// Two recorded runs on one page. @returns exit status. @throws UsageError.
int compare_two_runs(const CompareOptions& options);
/// One scene by several schemes, steps and values on one page. @returns exit status, run_failed when a case
/// diverged. @throws UsageError, SceneError.
int compare_schemes(const CompareOptions& options);
/// @throws UsageError when it is there and must not be replaced.
void check_free(const std::string& file, bool force);

}  // namespace percuss::app
