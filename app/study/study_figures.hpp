#pragma once

#include <string>
#include <vector>

#include "figures/page.hpp"
#include "study/evaluation.hpp"

namespace percuss::app {

/// A picture of a study and what it shows.
struct StudyFigure {
    std::string name;  ///< of its file, without .png
    std::string caption;
    render::Page page;
};

/// Of each design: error against time for each quantity, with the Pareto front; error against the size of
/// cells or steps; the histories, with one axis varied at a time. What a study has no numbers for is left
/// out.
[[nodiscard]] std::vector<StudyFigure> study_figures(const Study& study,
                                                     const std::vector<CaseResult>& results,
                                                     const Evaluation& evaluation);

}  // namespace percuss::app
