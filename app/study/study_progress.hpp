#pragma once

#include <chrono>
#include <cstddef>
#include <string>

namespace percuss::app {

/// Keeps stderr informed of a study: on a terminal one line rewritten in place, elsewhere a line for each
/// case.
class StudyProgress {
  public:
    /// @param there cases that need not be run.
    StudyProgress(std::size_t cases, std::size_t there);
    ~StudyProgress();  ///< ends the line
    StudyProgress(const StudyProgress&) = delete;
    StudyProgress& operator=(const StudyProgress&) = delete;

    /// @param ended label of a case that came to its end, "" when none did. @param trouble why it did not
    /// finish.
    void show(const std::string& ended, const std::string& trouble, std::size_t running);

  private:
    std::size_t cases_, there_, done_ = 0;
    bool terminal_, line_open_ = false;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace percuss::app
