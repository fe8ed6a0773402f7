#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scene/place.hpp"

namespace percuss {

/// The cases of a lesson's figure: each scheme with each step and each value.
struct Comparison {
    std::vector<std::string> schemes;  ///< named_schemes.hpp; empty: all that the scene can take
    std::vector<double> steps;         ///< fractions of the critical step; empty: the scene's own
    std::vector<double> values;        ///< of the lesson's control, a parameter; empty: the scene's own
    bool operator==(const Comparison&) const = default;
};

/// What a scene teaches, and how.
struct Lesson {
    std::string title, text, question;
    std::string control;  ///< what the reader moves: "scheme", "model.step.courant", "parameters.NAME", ...
    std::string look_for, answer;
    std::optional<Comparison> compare;  ///< the lesson's figure
    Place place;
    bool operator==(const Lesson&) const = default;
};

}  // namespace percuss
