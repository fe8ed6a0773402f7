#pragma once

#include <optional>
#include <string>
#include <vector>

#include "study/pareto.hpp"
#include "study/richardson.hpp"
#include "study/study.hpp"

namespace percuss::app {

/// What the cases of one design are judged by, for one quantity.
struct Reference {
    std::optional<double> value;  ///< absent for histories, and when there is none
    double uncertainty = 0;       ///< relative, as errors are
    bool exact = false;
    std::string how;                 ///< "exact", "Richardson from three levels, order 1.9", ...
    std::optional<std::size_t> own;  ///< the case that is its own reference: it has no error
};

/// How fast a quantity comes nearer to its limit.
struct ObservedOrder {
    std::size_t axis = 0;  ///< that is refined
    std::string series;    ///< the values of the other axes
    std::size_t quantity = 0;
    double order = 0;
};

/// Cases that differ only in what changes nothing of the true answer: all methods, meshes, steps of one
/// design.
struct Design {
    std::string label;                                 ///< "" when there is only one
    std::vector<std::size_t> cases;                    ///< places in Study::cases
    std::vector<Reference> references;                 ///< one a quantity
    std::vector<std::vector<std::size_t>> fronts;      ///< one a quantity: the Pareto front of its cases
    std::vector<std::optional<std::size_t>> cheapest;  ///< one a quantity: within its tolerance
};

/// All that a study says.
struct Evaluation {
    /// [case][quantity]; absent: not finished, or the case has no such number.
    std::vector<std::vector<std::optional<double>>> values;
    std::vector<std::vector<std::optional<double>>> errors;  ///< relative
    std::vector<Design> designs;
    std::vector<ObservedOrder> orders;
};

/// @param results one a case. @throws UsageError for a quantity that no finished case has, naming the
/// nearest.
[[nodiscard]] Evaluation evaluate(const Study& study, const std::vector<CaseResult>& results);

/// The axis whose finest end the reference is taken from: the mesh, without one the step.
[[nodiscard]] std::optional<std::size_t> refined_axis(const Study& study);
/// The first axis of a kind that has several values.
[[nodiscard]] std::optional<std::size_t> axis_of_kind(const Study& study, AxisKind kind);

/// The case at these places of all axes.
[[nodiscard]] std::size_t case_at(const Study& study, const std::vector<std::size_t>& at);

/// "step 0.9, joint": the values of all axes but one, those with a single value left out.
[[nodiscard]] std::string label_without(const Study& study, const std::vector<std::size_t>& at,
                                        std::size_t left_out);

/// Size of cells or steps along a refined axis, up to a factor: elements^(-1/2), or 1/steps. 0 without a
/// result.
[[nodiscard]] double level_size(const Study& study, std::size_t axis, const CaseResult& result);

/// @throws UsageError for a number of summary.json that this finished case lacks, unless it may come later:
/// when a body stops, when a pair touches.
void check_summary_keys(const Study& study, const CaseResult& result);

}  // namespace percuss::app
