#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "figures/figure.hpp"
#include "run/history.hpp"
#include "run/snapshot.hpp"

namespace percuss::app {

/// A finished (or killed) run as figures need it.
struct RecordedRun {
    std::string label;  ///< from its step: "Δt = 200 ns"
    std::shared_ptr<const RunSetup> setup;
    std::shared_ptr<const History> history;
    nlohmann::ordered_json summary;  ///< empty when the run did not finish
};
[[nodiscard]] RecordedRun load_recorded_run(const std::filesystem::path& run_file);

/// "Δt = 200 ns", "Δt = 0.9 of critical", with ", lagged" where stresses are taken at uncorrected positions.
[[nodiscard]] std::string step_label(const Scene& scene);

/// "contact.impact.axial" -> "contact force of impact, axial"; names that follow no pattern stay as they are.
[[nodiscard]] std::string column_title(const std::string& column);

struct FigureLayout {
    std::vector<std::string> columns;  ///< history columns
    bool together = false;             ///< all runs in one chart per column, else a chart a run
    bool exact = true;                 ///< draw the scene's exact answers
};
/// Charts of history columns against time; charts of one column share their range, so heights can be
/// compared.
/// @throws UsageError for a column that a run lacks.
[[nodiscard]] render::Figure make_figure(const std::vector<RecordedRun>& runs, const FigureLayout& layout);

}  // namespace percuss::app
