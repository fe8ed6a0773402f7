#pragma once

#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "study/study.hpp"

namespace percuss::app {

/// The step and mesh that a scene's [accuracy] comes to.
struct AccuracyChoice {
    std::vector<std::string> overrides;  ///< that choose them, as --set
    bool within = false;                 ///< whether the case keeps the tolerance; else it is the nearest one
    std::string text;                    ///< what was chosen and why, a sentence
    nlohmann::ordered_json record;       ///< the same for summary.json
};

/// Of the scene's [study], with all but steps and meshes as the scene has them: the cheapest case within the
/// tolerance, else the nearest. Cases that `percuss study` has left in its usual folder are not run again.
/// Nothing when --set leaves no choice. @param interrupted is set when the user ended it; then nothing, too.
/// @throws UsageError when no case finishes or the quantity does not exist.
[[nodiscard]] std::optional<AccuracyChoice> choose_accuracy(const Scene& scene, bool& interrupted);

}  // namespace percuss::app
