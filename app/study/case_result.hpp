#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace percuss::app {

enum class CaseState {
    finished,
    diverged,
    refused,  ///< the scene cannot be read or built with these values
    failed,   ///< its process ended without a result
};
[[nodiscard]] const char* state_name(CaseState state);

/// What one case came to.
struct CaseResult {
    CaseState state = CaseState::failed;
    std::string message;             ///< why it did not finish
    nlohmann::ordered_json summary;  ///< of its fastest run; empty when refused or failed
    std::vector<double> seconds;     ///< of stepping, of each repetition
    double core_share = 1;     ///< processor time over wall time while it ran: below 1 others were in the way
    double memory = 0;         ///< largest resident set of its process [MB]
    double memory_before = 0;  ///< the same before the scene was built [MB]
    std::map<std::string, std::vector<double>> histories;  ///< "time" and the columns asked for

    [[nodiscard]] double best_seconds() const;
    /// (slowest - fastest)/fastest of the repetitions; absent for one.
    [[nodiscard]] std::optional<double> spread() const;
    [[nodiscard]] std::optional<double> number(const std::string& path) const;  ///< of the summary
};

void write_case_result(const CaseResult& result, const std::filesystem::path& file);
/// Nothing when the file is not there or is not whole.
[[nodiscard]] std::optional<CaseResult> read_case_result(const std::filesystem::path& file);

}  // namespace percuss::app
