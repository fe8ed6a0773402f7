#pragma once

#include <string>
#include <vector>

#include "figures/page.hpp"
#include "figures/run_figure.hpp"

namespace percuss::app {

/// One number of two runs.
struct Difference {
    std::string path;  ///< in summary.json: "contact.impact.peak_averaged.axial"
    std::string unit;
    double a = 0, b = 0;
    [[nodiscard]] double relative()
        const;  ///< b / a - 1: positive when b is the larger in magnitude; infinite when only a is 0
};

/// What two runs were given and what came of it: parameters, step, peaks and residual forces, final
/// velocities, extents, plastic strains, energies. Only numbers that both have.
[[nodiscard]] std::vector<Difference> compare_runs(const RecordedRun& a, const RecordedRun& b);

/// "path,unit,a,b,difference,relative", a line each.
[[nodiscard]] std::string differences_csv(const std::vector<Difference>& differences);

/// Both last meshes, force and velocity histories (the second run dashed), energies, and a table of the
/// differences.
/// @param names of the runs, as they were called. @throws UsageError when a run has no summary or other
/// units.
[[nodiscard]] render::Page make_comparison(const RecordedRun& a, const RecordedRun& b,
                                           const std::array<std::string, 2>& names);

}  // namespace percuss::app
