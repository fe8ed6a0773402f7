#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "figures/figure.hpp"
#include "workbench/workbench.hpp"

namespace percuss::app {

/// Curves of one run as a plot shows them.
struct PlotRun {
    std::shared_ptr<const History> history;
    std::string prefix;                ///< of its columns in files: "", "reference "
    std::size_t begin = 0, end = 0;    ///< rows within the time that is shown
    std::vector<std::size_t> columns;  ///< of the history
    std::vector<std::size_t> places;   ///< of these curves in the plot, which give their colours
};

/// What a plot shows: the visible curves of the present run and of the reference, within the time that is
/// shown.
struct PlotContents {
    PlotInfo plot;
    Units units;
    double duration = 0;                ///< of the scene, which the unit of time follows [time]
    std::array<double, 2> times{0, 1};  ///< shown [time]
    std::vector<PlotRun> runs;          ///< the present one first
    /// Of curves that have no rows in the history: before this only the least and greatest of some steps are
    /// known [time].
    std::optional<double> thinned_before{};
};
/// For a file that lists every row, where plots of rates give the counts that they are of.
[[nodiscard]] PlotContents contents_of(Workbench& w, const PlotInfo& plot);
/// For a picture, where they give the rates as they are drawn.
[[nodiscard]] PlotContents drawn_contents_of(Workbench& w, const PlotInfo& plot);

/// Every row, in scene units, a column a curve under "name [unit]" as in history.csv; a reference has a time
/// of its own.
/// @throws std::runtime_error naming the file.
void write_plot_csv(const std::filesystem::path& file, const PlotContents& contents);
/// For print; the reference is dashed. Says from when on every step is drawn, where that is not from the
/// start.
[[nodiscard]] render::Figure figure_of(const PlotContents& contents, const std::string& title);

}  // namespace percuss::app
