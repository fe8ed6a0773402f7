#pragma once

#include <array>
#include <optional>

#include "workbench/workbench.hpp"

namespace percuss::app {

// What the plots show, for the screen and for files alike.

[[nodiscard]] bool shown(const PlotsState& state, const PlotInfo& plot, const CurveInfo& curve);
/// The reference's column for a curve, unless the reference is the present run itself.
[[nodiscard]] std::optional<std::size_t> reference_column(const Workbench& w, const CurveInfo& curve);
/// The column for a curve of a run beside the present one.
[[nodiscard]] std::optional<std::size_t> beside_column(const Workbench& w, const BesideRun& run,
                                                       const CurveInfo& curve);
/// From, to: as zoomed, else all that the runs have [time].
[[nodiscard]] std::array<double, 2> shown_times(const Workbench& w);
/// Events are counted over at least this long: one of the units that times are shown in [time].
[[nodiscard]] double rate_window(const Workbench& w);
/// In which a plot's numbers read best; a rate is per unit of the time axis.
[[nodiscard]] DisplayUnit unit_of(const Workbench& w, const PlotInfo& plot, double largest);

/// Least and greatest of what a plot shows within these times, with a little room; zero is kept in sight when
/// it is near. @param width that rates are drawn on [pixels].
[[nodiscard]] std::array<double, 2> shown_values(Workbench& w, const PlotInfo& plot,
                                                 const std::array<double, 2>& times, float width);
/// The history that a curve is of.
[[nodiscard]] Curves& curves_of(PlotsState& state, const CurveInfo& curve);
/// Points that a rate is drawn with on so many pixels.
[[nodiscard]] int parts_of_rate(float width);

}  // namespace percuss::app
