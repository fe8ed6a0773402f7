#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "live/curves.hpp"
#include "live/live_run.hpp"
#include "run/probes.hpp"

namespace percuss::app {

/// A probe of the window as plots and pictures read it.
struct ProbeCurve {
    Probe probe;
    std::vector<ProbeReading> readings;  ///< where, one a quantity
    std::shared_ptr<Curves> curves;      ///< column 0 is time, k + 1 the quantity k
};

/// The curves of the window's probes. Of recorded runs they have every frame. Of others: before a probe was
/// set they are read off the kept moments of the run, where the velocity of a node is half a step older; from
/// then on they have every step.
class ProbeCurves {
  public:
    /// Takes over what came since the last call. @returns whether there are other probes or places now.
    bool follow(const LiveRun& run);
    [[nodiscard]] const std::vector<ProbeCurve>& all() const { return all_; }

  private:
    struct Source {
        std::shared_ptr<const History> rows;
        bool begun = false;  // it had rows when the past was read
    };
    std::shared_ptr<const RunSetup> setup_;
    std::vector<ProbeCurve> all_;
    std::vector<Source> sources_;
};

/// What the readings of a probe show at the kept moments before `until`: rows of time and values, in one
/// sequence [time].
[[nodiscard]] std::vector<double> kept_readings(const LiveRun& run, const std::vector<ProbeReading>& readings,
                                                double until);

/// What a reading shows at a moment.
[[nodiscard]] double value_of(const Snapshot& snapshot, const ProbeReading& reading);
/// Where it is then [length].
[[nodiscard]] std::array<double, 2> place_of(const Snapshot& snapshot, const ProbeReading& reading);

/// Adds each curve to the plot of its quantity, "probes.QUANTITY".
void add_probe_plots(const std::vector<ProbeCurve>& probes, std::vector<PlotInfo>& plots);

/// A name that neither the scene nor the window has: "p1", "p2", ...
[[nodiscard]] std::string free_probe_name(const Scene& scene, const std::vector<Probe>& probes);
/// The probes as [[probe]] tables of a scene file.
[[nodiscard]] std::string probes_as_scene_text(const std::vector<Probe>& probes);

}  // namespace percuss::app
