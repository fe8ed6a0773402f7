#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace percuss::app {

/// Writes files on a thread of its own, one after another, so that the window does not wait for disks.
class Writer {
  public:
    /// Writes and returns what was written, to be told; what it throws is told as a fault.
    using Chore = std::function<std::string()>;
    struct Result {
        bool written = false;
        std::string words;  ///< the file, or the fault
    };

    Writer() = default;
    ~Writer();  ///< writes what was posted, then ends
    Writer(const Writer&) = delete;
    Writer& operator=(const Writer&) = delete;

    void post(Chore chore);
    [[nodiscard]] std::vector<Result> take_results();  ///< since the last call, oldest first
    [[nodiscard]] std::size_t waiting() const;         ///< posted, and its result not yet taken

  private:
    void work();

    mutable std::mutex mutex_;
    std::condition_variable posted_;
    std::deque<Chore> chores_;
    std::vector<Result> results_;
    std::size_t waiting_ = 0;
    bool ends_ = false;
    std::thread thread_;  // begun with the first chore
};

}  // namespace percuss::app
