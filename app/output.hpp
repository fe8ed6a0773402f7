#pragma once

#include <filesystem>
#include <functional>
#include <string>

namespace percuss::app {

/// The directory that a run leaves its results in.
class OutputDirectory {
  public:
    /// Checks only, makes nothing. @throws UsageError when `path` is a file, or holds something and `force`
    /// is not set.
    OutputDirectory(std::filesystem::path path, bool force);
    ~OutputDirectory();  ///< takes a directory away that it made and that stayed empty
    OutputDirectory(const OutputDirectory&) = delete;
    OutputDirectory& operator=(const OutputDirectory&) = delete;

    /// Makes it; removes what an earlier run of percuss left in it, and nothing else. @throws
    /// filesystem_error.
    void make();
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }
    [[nodiscard]] std::filesystem::path run_file() const { return path_ / "run.h5"; }
    [[nodiscard]] std::filesystem::path history_file() const { return path_ / "history.csv"; }
    [[nodiscard]] std::filesystem::path summary_file() const { return path_ / "summary.json"; }
    [[nodiscard]] std::filesystem::path frames() const { return path_ / "frames"; }
    [[nodiscard]] std::filesystem::path figures() const { return path_ / "figures"; }

  private:
    std::filesystem::path path_;
    bool made_ = false;
};

/// "000042.png"
[[nodiscard]] std::string frame_name(long long index);

/// Runs `write` on a name beside `file`, then renames: the file's own name never holds half a result.
void write_whole(const std::filesystem::path& file,
                 const std::function<void(const std::filesystem::path& aside)>& write);

/// Writes a small text whole. @throws std::runtime_error naming the file.
void write_text_file(const std::filesystem::path& file, const std::string& text);

}  // namespace percuss::app
