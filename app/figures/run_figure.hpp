#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "figures/figure.hpp"
#include "record/run_file.hpp"
#include "run/history.hpp"
#include "run/snapshot.hpp"

namespace percuss::app {

/// The moments of a run that figures can show, in order of time.
struct RunFrames {
    std::vector<double> times;                                         ///< [time]
    std::function<std::shared_ptr<const Snapshot>(std::size_t)> read;  ///< the moment at times[i]
    [[nodiscard]] std::size_t size() const { return times.size(); }
    [[nodiscard]] std::shared_ptr<const Snapshot> operator[](std::size_t index) const { return read(index); }
};

/// A run as figures need it: finished, killed, or still going on in a window.
struct RecordedRun {
    std::string label;  ///< from its step: "Δt = 200 ns"
    std::shared_ptr<const RunSetup> setup;
    std::shared_ptr<const History> history;
    nlohmann::ordered_json summary;  ///< empty when the run did not finish
    RunFrames frames;
    std::vector<Trace> traces;
};
/// @param overrides set before the recorded scene is read again: other titles, ranges, times of its figures.
[[nodiscard]] RecordedRun load_recorded_run(const std::filesystem::path& run_file,
                                            const std::vector<std::string>& overrides = {});

/// What a figure sampled during the run. @throws UsageError when the run has no such trace.
[[nodiscard]] const Trace& trace_of(const RecordedRun& run, const std::string& figure);

/// "Δt = 200 ns", "Δt = 0.9 of critical", with ", lagged" where stresses are taken at uncorrected positions.
[[nodiscard]] std::string step_label(const Scene& scene);

/// "contact.impact.axial" -> "contact force of impact, axial"; names that follow no pattern stay as they are.
[[nodiscard]] std::string column_title(const std::string& column);

/// The exact answer that the scene declares for a history column; null when it declares none.
[[nodiscard]] const ExactHistory* exact_of(const Scene& scene, const std::string& column);

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
