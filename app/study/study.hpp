#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "study/case_result.hpp"
#include "study/grid.hpp"

namespace percuss::app {

/// One case of a study, before it is run.
struct StudyCase {
    std::vector<std::size_t> at;  ///< its values: a place in Variation::values for each axis
    std::vector<std::string> overrides;
    std::string key;             ///< of what it depends on: scene text, values, program, columns
    std::string label;           ///< "step 0.9, mesh 2, joint"
    std::optional<Scene> scene;  ///< absent when it cannot be read
    std::string fault;           ///< then why
};

/// A scene over a grid of settings.
struct Study {
    Scene scene;  ///< as it is without the grid
    std::vector<Variation> axes;
    std::vector<StudyQuantity> quantities;
    std::vector<std::string> columns;  ///< histories that the cases keep, beside "time"
    std::vector<StudyCase> cases;      ///< in the order of combine()
    int repeat = 0;  ///< runs of each case for its time; 0: three to twenty, within some 2 s
};

/// What was asked for on the command line.
struct StudyRequest {
    std::string file;
    std::vector<std::string> overrides;  ///< of all cases
    std::vector<std::string> vary;  ///< "KEY=1,2"; of a key that the scene's [study] varies, instead of it
    std::vector<std::string> quantities;  ///< "PATH" or "PATH=EXACT"; any: instead of the scene's
    std::optional<double> tolerance;      ///< of all quantities
    int repeat = 0;
};

/// Reads the scene and all cases. @throws UsageError, SceneError: for a value that no case can be read with,
/// for a quantity that is no history column of the scene although it looks like one.
[[nodiscard]] Study make_study(const StudyRequest& request);

/// Whether the quantity is a history, else it is a number of summary.json. Where both have the name, it is
/// the number unless the quantity says otherwise.
[[nodiscard]] bool is_history(const StudyQuantity& quantity, const Study& study);

/// Where a study keeps what it needs to go on, and what it leaves.
class StudyFolder {
  public:
    explicit StudyFolder(std::filesystem::path path) : path_(std::move(path)) {}
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }
    [[nodiscard]] std::filesystem::path plan() const { return path_ / "plan.json"; }
    [[nodiscard]] std::filesystem::path cases() const { return path_ / "cases"; }
    [[nodiscard]] std::filesystem::path result(const std::string& key) const {
        return cases() / (key + ".json");
    }
    [[nodiscard]] std::filesystem::path log(const std::string& key) const { return cases() / (key + ".log"); }

    /// @throws UsageError when something else is there, and `force` is not set.
    void check(bool force) const;
    /// Makes the folder, and writes what run_planned_case reads.
    void write_plan(const Study& study) const;

  private:
    std::filesystem::path path_;
};

/// Runs one case of a plan in this process and writes its result. @param cpu that the process is pinned to,
/// -1: none. @returns exit status.
int run_planned_case(const StudyFolder& folder, const std::string& key, int cpu);

}  // namespace percuss::app
