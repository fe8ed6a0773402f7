#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "study/study.hpp"

namespace percuss::app {

/// What executors tell while they work.
struct ExecutorNews {
    std::string ended;    ///< key of a case that came to its end, "" when none did since the last news
    std::string failure;  ///< why it left no result, "" when it left one
    std::size_t running = 0;
};
using Listener = std::function<void(const ExecutorNews& news)>;

/// Runs cases in processes of their own, each pinned to a processor of its own. @param jobs at a time, at
/// most as many as there are places(). @returns false when it was interrupted.
bool run_locally(const StudyFolder& folder, const std::vector<std::string>& keys, std::size_t jobs,
                 const Listener& listener);

/// Processors that this process may use, one of each core: threads that share a core would slow each other
/// down.
[[nodiscard]] std::vector<int> places();

/// Hands the cases to a Slurm array by sbatch and waits for it; an interrupt cancels the array. The folder
/// must be one that the nodes see, too. @param jobs at a time, 0: as Slurm likes.
/// @throws std::runtime_error when sbatch is missing or refuses.
bool run_by_slurm(const StudyFolder& folder, const std::vector<std::string>& keys, std::size_t jobs,
                  const Listener& listener);

/// The last line that a case wrote before it ended without a result.
[[nodiscard]] std::string last_words(const StudyFolder& folder, const std::string& key);

}  // namespace percuss::app
