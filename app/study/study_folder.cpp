#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "exit_status.hpp"
#include "output.hpp"
#include "study/study.hpp"

namespace percuss::app {

void StudyFolder::check(bool force) const {
    namespace fs = std::filesystem;
    if (!fs::exists(path_)) return;
    if (!fs::is_directory(path_))
        throw UsageError(fmt::format("--out {}: there is a file of this name", path_.string()));
    if (!force && !fs::is_empty(path_) && !fs::exists(plan()))
        throw UsageError(
            fmt::format("--out {}: the directory is not empty and holds no study; choose another, "
                        "or write into it with --force",
                        path_.string()));
}

void StudyFolder::write_plan(const Study& study) const {
    std::filesystem::create_directories(cases());
    nlohmann::ordered_json all = nlohmann::ordered_json::object();
    for (const StudyCase& each : study.cases)
        all[each.key] = {{"label", each.label}, {"overrides", each.overrides}};
    const nlohmann::ordered_json plan{{"file", study.scene.file},
                                      {"text", study.scene.text},
                                      {"columns", study.columns},
                                      {"repeat", study.repeat},
                                      {"cases", std::move(all)}};
    write_text_file(this->plan(), plan.dump(1) + "\n");
}

}  // namespace percuss::app
