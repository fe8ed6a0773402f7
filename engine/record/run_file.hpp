#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>

#include "run/history.hpp"
#include "run/snapshot.hpp"
#include "run/trace.hpp"

namespace percuss {

class RecordError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// Writes run.h5: scene text, overrides, version, machine, mesh, frames, histories, at last the summary.
/// Each frame is complete on disk before its count is raised, so a killed run leaves a readable file.
class RunFileWriter {
  public:
    /// @throws RecordError when the file exists or cannot be made.
    RunFileWriter(const std::filesystem::path& file, std::shared_ptr<const RunSetup> setup,
                  const std::vector<HistoryColumn>& columns, const std::vector<Trace>& traces = {});
    ~RunFileWriter();
    RunFileWriter(const RunFileWriter&) = delete;
    RunFileWriter& operator=(const RunFileWriter&) = delete;

    void add_frame(const Snapshot& snapshot);
    /// Appends the rows that came since the last call, every scene.record.history_every-th of them, and those
    /// of the traces.
    void add_history(const History& history);
    void finish(const std::string& summary_json);

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

/// Reads a run.h5 back, also one whose run was killed. @throws RecordError naming file and reason.
class RunFile {
  public:
    explicit RunFile(const std::filesystem::path& file);
    ~RunFile();
    [[nodiscard]] std::shared_ptr<const RunSetup> setup() const;
    [[nodiscard]] std::int64_t frames() const;
    [[nodiscard]] std::vector<double> frame_times() const;  ///< of all frames [time]
    [[nodiscard]] std::shared_ptr<const Snapshot> frame(std::int64_t index) const;
    [[nodiscard]] std::shared_ptr<const History> history() const;
    [[nodiscard]] std::vector<Trace> traces() const;
    [[nodiscard]] std::string summary() const;  ///< JSON text, "" when the run did not finish

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

/// Writes history.csv: header "name [unit]", one line a row, 17 significant digits.
void write_history_csv(const std::filesystem::path& file, const History& history, const Units& units,
                       int every = 1);

}  // namespace percuss
