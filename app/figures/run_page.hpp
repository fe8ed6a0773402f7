#pragma once

#include <optional>
#include <string>
#include <vector>

#include "figures/page.hpp"
#include "figures/run_figure.hpp"

namespace percuss::app {

/// A figure of one run, ready to be drawn, and its numbers for other programs.
struct RunPage {
    render::Page page;
    std::optional<std::string> csv;  ///< of figures whose numbers are in no history column
};

/// @throws UsageError when the run lacks what the figure shows.
[[nodiscard]] RunPage make_run_page(const RecordedRun& run, const FigureSpec& figure);

// One file a kind of figure.
[[nodiscard]] RunPage make_history_page(const RecordedRun& run, const FigureSpec& figure);
[[nodiscard]] RunPage make_mesh_page(const RecordedRun& run, const FigureSpec& figure);
[[nodiscard]] RunPage make_space_time_page(const RecordedRun& run, const FigureSpec& figure);
[[nodiscard]] RunPage make_surface_forces_page(const RecordedRun& run, const FigureSpec& figure);
[[nodiscard]] RunPage make_clamping_page(const RecordedRun& run, const FigureSpec& figure);
[[nodiscard]] RunPage make_energy_page(const RecordedRun& run, const FigureSpec& figure);

/// The scene's figures, and one of each kind that it does not declare and that needs nothing sampled during
/// the run: forces, velocities, mesh, clamping, energy.
[[nodiscard]] std::vector<FigureSpec> all_figures(const RecordedRun& run);

/// The frame nearest to a time. @throws UsageError when the run has no frame.
[[nodiscard]] std::shared_ptr<const Snapshot> frame_near(const RunFrames& frames, double time);

/// "title [unit]", or the title alone where there is no unit.
[[nodiscard]] std::string titled(const std::string& title, const std::string& unit);
/// The run's time axis.
[[nodiscard]] DisplayUnit time_unit(const RecordedRun& run);
/// Shown times in display units: what the figure asks for, else the whole run.
[[nodiscard]] std::array<double, 2> time_range(const RecordedRun& run, const FigureSpec& figure);
/// "z" or "r", "x", "y".
[[nodiscard]] std::string coordinate_name(const Scene& scene, std::size_t direction);

}  // namespace percuss::app
