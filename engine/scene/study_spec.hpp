#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scene/place.hpp"

namespace percuss {

/// What a varied key is to the answer.
enum class AxisKind {
    step,    ///< refines time: smaller values converge to one answer
    mesh,    ///< refines space, likewise: more elements
    method,  ///< another way to the same answer: contact scheme, element, viscosity
    design,  ///< another problem, with an answer of its own
};

/// One key of a scene and the values that a study gives it.
struct StudyAxis {
    std::string key;  ///< as in --set; "scheme": a named contact scheme; * for each of [[...]]
    std::vector<std::string> values;  ///< as in --set
    std::string name;                 ///< in tables and figures
    AxisKind kind = AxisKind::design;
    Place place;
    bool operator==(const StudyAxis&) const = default;
};

/// A number or history by which the cases of a study are judged.
struct StudyQuantity {
    std::string of;               ///< a history column, or a path in summary.json
    std::string name;             ///< in tables and figures
    std::optional<double> exact;  ///< the true number, where it is known; histories have [[exact]]
    std::optional<double> scale;  ///< what errors are relative to; absent: the reference itself
    double tolerance = 0.01;      ///< relative error within which the cheapest case is looked for
    bool history = false;         ///< the history, where a number of summary.json has the same name
    Place place;
    bool operator==(const StudyQuantity&) const = default;
};

/// The study that a scene proposes: all combinations of the values.
struct StudySpec {
    std::vector<StudyAxis> vary;
    std::vector<StudyQuantity> quantities;
    Place place;
    bool operator==(const StudySpec&) const = default;
};

/// How near a run should come: step and mesh are then chosen by the study.
struct AccuracyTarget {
    std::string quantity;     ///< as StudyQuantity::of
    double tolerance = 0.01;  ///< relative error
    Place place;
    bool operator==(const AccuracyTarget&) const = default;
};

/// What a key is to the answer when nothing says it: model.step.* refine time; a last part of "mesh" or
/// "divisions" refines space; schemes, elements, hourglass and viscosity are methods; all else is design.
[[nodiscard]] AxisKind usual_kind(const std::string& key);
/// How a key is called in tables when nothing says it: "step", "mesh", "scheme", "friction".
[[nodiscard]] std::string usual_name(const std::string& key);

}  // namespace percuss
