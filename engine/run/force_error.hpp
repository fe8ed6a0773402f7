#pragma once

#include <span>
#include <utility>
#include <vector>

namespace percuss {

/// Points (time, value) of a piecewise-linear function; a jump is two points at one time, outside the points
/// it is 0.
using TimePoints = std::vector<std::pair<double, double>>;

/// I(t) = integral of a piecewise-linear function from minus infinity to t; exact, jumps included.
class RunningIntegral {
  public:
    /// @param points times must not decrease. @throws std::invalid_argument when they do or there are none.
    explicit RunningIntegral(TimePoints points);
    [[nodiscard]] double operator()(double time) const;

  private:
    TimePoints points_;
    std::vector<double> until_;  // integral up to each point
};

/// A history of contact impulses as a function of time: C_n dt belongs to [t_n - dt/2, t_n + dt/2], so the
/// force is constant between the midpoints of the rows' times. The first and last rows reach half a step
/// beyond themselves.
/// @param time,force one number a row, at least two rows.
[[nodiscard]] TimePoints force_between_midpoints(std::span<const double> time, std::span<const double> force);

/// Relative L2 error of a force history against an exact one: both running integrals are averaged over a
/// centred window, and || computed - exact || / || exact || is taken over 0 <= t <= duration (to where the
/// record still fills the window). A window of one step compares the impulses as they are; a longer one
/// forgives oscillation within it.
/// @param window [time]; 0 or less: one mean step. @throws std::invalid_argument for fewer than two rows, or
/// an exact answer that is 0 throughout.
[[nodiscard]] double force_error(std::span<const double> time, std::span<const double> force,
                                 const TimePoints& exact, double window, double duration);

/// As force_error, against another run's history.
[[nodiscard]] double history_error(std::span<const double> time, std::span<const double> values,
                                   std::span<const double> reference_time, std::span<const double> reference,
                                   double window, double duration);

/// First nonzero force over the exact answer's largest value (by magnitude): how far the first instant
/// overshoots, dtc/(2 dt) for two equal rods. 0 when the force is zero throughout.
[[nodiscard]] double first_sample(std::span<const double> force, const TimePoints& exact);

}  // namespace percuss
