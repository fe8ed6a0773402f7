#pragma once

#include <array>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "live/min_max_pyramid.hpp"
#include "run/history.hpp"
#include "scene/scene.hpp"

namespace percuss::app {

class Curves;

/// A curve of a plot: a column of the history under a short name.
struct CurveInfo {
    std::size_t column = 0;
    std::string label;                 ///< "piston-nail", "washer", "kinetic"
    bool shown = true;                 ///< when the plot is first drawn
    std::shared_ptr<Curves> own = {};  ///< whose column it is; null: of the run's history
};

struct PlotInfo {
    std::string
        name;  ///< of widgets: "forces.axial", "velocities.axial", "energies", "step", "probes.von_mises"
    std::string title;  ///< "axial contact force on the master body"
    Quantity quantity = Quantity::dimensionless;
    std::vector<CurveInfo> curves;
    bool folded = false;  ///< when the plots are first drawn
    /// The columns count events: what is drawn is how many come in a unit of time (rate_at). The quantity
    /// says nothing then.
    bool rate = false;
};

/// The plots that a scene's histories give: contact forces and velocities by direction, energies, step, and
/// those of probes, one a quantity.
[[nodiscard]] std::vector<PlotInfo> plots_of(const Scene& scene, const std::vector<HistoryColumn>& columns);

/// Histories as plots read them, full rate; only new rows are copied, of the columns that are looked at. Of
/// old rows beyond some hundred thousand only the extremes of groups stay (MinMaxPyramid).
class Curves {
  public:
    /// Takes what was appended since the last call; another history begins anew.
    /// @param past then stands before its rows: rows of as many numbers as it has columns, in one sequence.
    void follow(std::shared_ptr<const History> history, std::vector<double> past = {});
    [[nodiscard]] std::size_t rows() const { return times_.size(); }
    [[nodiscard]] const MinMaxPyramid& times() const { return times_; }
    /// Valid until the next follow().
    [[nodiscard]] const MinMaxPyramid& column(std::size_t index);
    /// First row at or after this time; rows() when there is none.
    [[nodiscard]] std::size_t row_at(double time) const;

  private:
    [[nodiscard]] std::vector<double> past_column(std::size_t index) const;
    void append(std::size_t column, std::size_t begin, std::size_t end, MinMaxPyramid& to) const;

    std::shared_ptr<const History> history_;
    std::vector<double> past_;
    std::size_t past_rows_ = 0;
    MinMaxPyramid times_;
    std::map<std::size_t, MinMaxPyramid> columns_;
};

struct CurvePoint {
    double time = 0, value = 0;
};
/// What a plot of [from, to] draws of a curve: all points when they are few, else at most two in each of
/// `parts` equal spans of time, the least and the greatest, in the order that keeps the line short. One point
/// beyond either end is kept, so that lines reach the edges.
void decimate(const Curves& curves, const MinMaxPyramid& values, double from, double to, int parts,
              std::vector<CurvePoint>& points);

/// Drops the points of a line, of ascending x, that it passes within `tolerance` in y without them (Reumann &
/// Witkam's strip with the ends held). A jump up and down at one x stays unless it is no higher than that.
void straighten(std::vector<std::array<float, 2>>& line, float tolerance);

/// How many events come in a unit of time: the mean over `window` about `time`, cut at the ends of the curve
/// [1/time]. @param counts of all events so far, by row; the run begins with none.
[[nodiscard]] double rate_at(const Curves& curves, const MinMaxPyramid& counts, double time, double window);
/// What a plot of [from, to] draws of it: one point in each of `parts` equal spans of time. The window is at
/// least as wide as those, so that no event falls between two points.
void rates(const Curves& curves, const MinMaxPyramid& counts, double from, double to, int parts,
           double window, std::vector<CurvePoint>& points);

}  // namespace percuss::app
