#pragma once

#include <array>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "run/in_flight.hpp"
#include "scene/scene.hpp"

namespace percuss {

/// A value by which the design of a scene can be varied: a number, or a choice of words.
struct DesignValue {
    std::string key;    ///< as in --set and command::Set, "material.steel.young"
    std::string group;  ///< "parameters", "run", "material steel", "body rod", "contact hit"
    std::string title;  ///< "Young's modulus"
    std::string unit;   ///< its label, "" when dimensionless
    std::string help;   ///< what it does, in a sentence; "" where the title says it
    double number = 0;
    /// Where it is looked for; absent: no bounds that a slider could show.
    std::optional<std::array<double, 2>> range;
    double least = -std::numeric_limits<double>::infinity();  ///< that the scene accepts, or just below
    std::vector<std::string> choices;                         ///< not empty: one of these words
    std::string choice;
    std::string expression;  ///< "= 2*modulus" when it follows from parameters, else ""
    ChangeEffect effect = ChangeEffect::rebuild;
};

/// The values of a scene that a design varies, [parameters] first; only what the scene calls for. An effect
/// is that of a small change of the present value: what is 0 may need a new run where what is not does not.
/// That of a parameter is the strongest among all that follows from it. @pre the scene was parsed.
[[nodiscard]] std::vector<DesignValue> design_values(const Scene& scene);

}  // namespace percuss
