#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "study/evaluation.hpp"
#include "study/study_figures.hpp"

namespace percuss::app {

/// What the page says about how it was made.
struct StudyCircumstances {
    std::string command,
        executor;  ///< "percuss study scenes/rods.toml", "2 processes at a time, each pinned to a core"
    std::string machine;
};

/// One page of HTML that needs nothing beside it: conclusions, cheapest settings, figures, orders, all cases.
/// @param pictures PNG files of the figures, in their order. @throws RenderError when one cannot be read.
[[nodiscard]] std::string study_page(const Study& study, const std::vector<CaseResult>& results,
                                     const Evaluation& evaluation, const std::vector<StudyFigure>& figures,
                                     const std::vector<std::filesystem::path>& pictures,
                                     const StudyCircumstances& circumstances);

}  // namespace percuss::app
