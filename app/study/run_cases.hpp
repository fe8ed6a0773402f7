#pragma once

#include <optional>
#include <vector>

#include "study/study.hpp"

namespace percuss::app {

/// How the cases of a study are run.
struct HowToRun {
    bool slurm = false;
    std::size_t jobs = 0;  ///< at a time; 0: one a core
    bool again = false;    ///< those that are there, too
};

/// Runs the cases that have no result yet, tells how far it is on stderr, and collects all. Nothing when it
/// was interrupted. @throws UsageError for a quantity that the first case has not.
[[nodiscard]] std::optional<std::vector<CaseResult>> run_cases(const Study& study, const StudyFolder& folder,
                                                               const HowToRun& how);

/// out/NAME-study of a scene file NAME.toml.
[[nodiscard]] StudyFolder usual_study_folder(const std::filesystem::path& scene_file);

}  // namespace percuss::app
