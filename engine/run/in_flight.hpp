#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "scene/scene.hpp"

namespace percuss {

/// What it takes to change a value of the scene while its run is under way.
enum class ChangeEffect {
    none,       ///< the run does not read it: views, records, promises, what figures look like
    next_step,  ///< it acts from the next step on
    rebuild,    ///< the run begins anew
};

/// What a key alone tells. @param key as in command::Set and --set, "model.step.courant". What may rebuild
/// does; whether the key exists is not asked.
[[nodiscard]] ChangeEffect effect_of_change(std::string_view key);

/// The values of a scene that its run takes up at the next step: those that no stored state has a meaning
/// by. Elastic constants are none of them, for stresses were gathered with them; nor is what decides which
/// code runs: an effect that the scene does not call for cannot be turned on.
struct InFlight {
    struct OfBody {
        std::optional<BulkViscosity> viscosity;
        double hourglass = 0;
        std::array<double, 2> body_force{0, 0};  ///< [acceleration]
        std::vector<EdgeLoad> loads;
        bool operator==(const OfBody&) const = default;
    };
    StepSize step;
    ContactSolver contact_solver;
    std::vector<double> friction;  ///< per contact pair, coefficient
    std::vector<OfBody> bodies;
    bool operator==(const InFlight&) const = default;
};
[[nodiscard]] InFlight in_flight(const Scene& scene);

/// What it takes to go on with `after` in the run of `before`.
[[nodiscard]] ChangeEffect effect_of_change(const Scene& before, const Scene& after);

}  // namespace percuss
