#include "study/run_cases.hpp"

#include <map>
#include <set>
#include <utility>

#include "study/evaluation.hpp"
#include "study/executor.hpp"
#include "study/study_progress.hpp"
#include "study/study_table.hpp"

namespace percuss::app {
namespace {

using Failures = std::map<std::string, std::string>;  // by key: why a case left no result

/// A result that is there and is all that was asked for.
bool usable(const Study& study, const std::optional<CaseResult>& result) {
    return result && (result->state != CaseState::finished || study.repeat == 0 ||
                      result->seconds.size() >= static_cast<std::size_t>(study.repeat));
}

/// @returns false when it was interrupted.
bool run_missing(const Study& study, const StudyFolder& folder, const HowToRun& how, Failures& failures) {
    std::vector<std::string> keys;
    std::map<std::string, std::string> labels;
    std::set<std::string> distinct;
    for (const StudyCase& each : study.cases) {
        if (!each.scene || !distinct.insert(each.key).second) continue;
        if (!how.again && usable(study, read_case_result(folder.result(each.key)))) continue;
        keys.push_back(each.key);
        labels[each.key] = each.label;
    }
    StudyProgress progress(study.cases.size(), study.cases.size() - keys.size());
    if (keys.empty()) return true;
    bool checked = false;
    const auto listen = [&](const ExecutorNews& news) {
        if (!news.failure.empty()) failures[news.ended] = news.failure;
        std::string what = news.failure;
        if (!news.ended.empty() && news.failure.empty())
            if (const auto result = read_case_result(folder.result(news.ended))) {
                what = trouble(*result);
                // A misspelt quantity is better told now than after all cases.
                if (result->state == CaseState::finished && !std::exchange(checked, true))
                    check_summary_keys(study, *result);
            }
        progress.show(news.ended.empty() ? "" : labels[news.ended], what, news.running);
    };
    return how.slurm ? run_by_slurm(folder, keys, how.jobs, listen)
                     : run_locally(folder, keys, how.jobs, listen);
}

}  // namespace

std::optional<std::vector<CaseResult>> run_cases(const Study& study, const StudyFolder& folder,
                                                 const HowToRun& how) {
    folder.write_plan(study);
    Failures failures;
    if (!run_missing(study, folder, how, failures)) return std::nullopt;
    std::vector<CaseResult> results;
    for (const StudyCase& each : study.cases) {
        CaseResult result;
        if (!each.scene) {
            result.state = CaseState::refused;
            result.message = each.fault;
        } else if (auto found = read_case_result(folder.result(each.key))) {
            result = std::move(*found);
        } else if (const auto failure = failures.find(each.key); failure != failures.end()) {
            result.message = failure->second;
        }
        results.push_back(std::move(result));
    }
    return results;
}

StudyFolder usual_study_folder(const std::filesystem::path& scene_file) {
    return StudyFolder(std::filesystem::path("out") / (scene_file.stem().string() + "-study"));
}

}  // namespace percuss::app
