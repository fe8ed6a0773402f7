#pragma once

#include <atomic>
#include <thread>
#include <vector>

namespace percuss {

/// A few threads that run the same function on different parts, over and over, with little latency. Waiting
/// threads spin for a moment, then yield, so that a busy machine is not made busier, and sleep when nothing
/// comes for longer.
class Team {
  public:
    /// @param size threads including the caller, at least 1.
    explicit Team(int size);
    ~Team();
    Team(const Team&) = delete;
    Team& operator=(const Team&) = delete;

    [[nodiscard]] int size() const { return static_cast<int>(helpers_.size()) + 1; }
    /// Calls work(part) for part 0 .. size() - 1, part 0 on the caller, and returns when all are done. `work`
    /// must not throw.
    template <class Work>
    void run(const Work& work) {
        if (helpers_.empty()) {
            work(0);
        } else {
            run_all(&work, [](const void* what, int part) { (*static_cast<const Work*>(what))(part); });
        }
    }

  private:
    using Call = void (*)(const void*, int);
    void run_all(const void* work, Call call);
    void serve(int part);

    std::vector<std::thread> helpers_;
    const void* work_ = nullptr;  // of the present round
    Call call_ = nullptr;
    std::atomic<unsigned> round_{0};
    std::atomic<int> busy_{0};
    std::atomic<bool> closing_{false};
};

}  // namespace percuss
