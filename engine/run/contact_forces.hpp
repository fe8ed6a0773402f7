#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "run/history.hpp"
#include "scene/scene.hpp"

namespace percuss {

/// What the force of a pair, or of what drives a body, comes to over a whole run, by direction (first, second)
/// [force].
struct ForceMeans {
    std::string name;  ///< of the pair or body
    std::array<double, 2> peak{0, 0};       ///< of largest magnitude in the moving average
    std::array<double, 2> peak_time{0, 0};  ///< [time]
    std::array<double, 2> residual{0, 0};   ///< mean over the last part of the run
};

/// Peaks and residual forces as [analysis] asks for them.
struct ContactAnalysis {
    double window = 0;                          ///< of the moving average [time]
    double residual_from = 0, residual_to = 0;  ///< [time]
    std::vector<ForceMeans> pairs;              ///< in the order of scene.contacts
    std::vector<ForceMeans> drives;             ///< of the bodies with prescribed motion
};
/// Directions without a column in the history stay 0. @pre the history has at least one row.
[[nodiscard]] ContactAnalysis analyse_contacts(const Scene& scene, const History& history);

/// What it takes to pull a body out by Coulomb's law: friction times the sum, over the pairs of the body, of
/// the magnitude of the residual force in the first direction (radial, of the full ring; x).
struct PullOutEstimate {
    double friction = 0;
    double normal_force = 0;                            ///< the sum [force]
    double force = 0;                                   ///< friction * normal_force [force]
    std::vector<std::pair<std::string, double>> parts;  ///< magnitude by pair [force]
};
[[nodiscard]] std::optional<PullOutEstimate> estimate_pull_out(const Scene& scene,
                                                               const ContactAnalysis& contacts);

}  // namespace percuss
