#pragma once

#include <string>
#include <vector>

#include "study/evaluation.hpp"

namespace percuss::app {

/// Wall time of a case by phase of the step [s].
struct CasePhases {
    double elements = 0, contact = 0, other = 0;
};
[[nodiscard]] CasePhases phases_of(const CaseResult& result);

/// "3.5 %", "0.012 %"
[[nodiscard]] std::string percent(double part);
/// "12.3 ms", "4.56 s", "2:05 min"
[[nodiscard]] std::string time_text(double seconds);
/// What became of a case that did not finish: "diverged: element 7 ...", "" when it did.
[[nodiscard]] std::string trouble(const CaseResult& result);

/// A row a case, the header first: values of the axes, errors of the quantities, time, spread of the
/// repetitions, phases, memory, steps, elements.
[[nodiscard]] std::vector<std::vector<std::string>> study_rows(const Study& study,
                                                               const std::vector<CaseResult>& results,
                                                               const Evaluation& evaluation);
/// All numbers of all cases.
[[nodiscard]] std::string study_csv(const Study& study, const std::vector<CaseResult>& results,
                                    const Evaluation& evaluation);
/// For each design and quantity: reference, its uncertainty, the cheapest case within the tolerance. The
/// header first.
[[nodiscard]] std::vector<std::vector<std::string>> cheapest_rows(const Study& study,
                                                                  const std::vector<CaseResult>& results,
                                                                  const Evaluation& evaluation);
/// Observed orders: a row a series, a column a quantity. The header alone when there are none.
[[nodiscard]] std::vector<std::vector<std::string>> order_rows(const Study& study,
                                                               const Evaluation& evaluation);

/// What the study says, in sentences: what a step, a mesh, a method buys, all else at the scene's own
/// settings.
[[nodiscard]] std::vector<std::string> conclusions(const Study& study, const std::vector<CaseResult>& results,
                                                   const Evaluation& evaluation);

}  // namespace percuss::app
