#pragma once

#include <chrono>
#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>

#include "run/snapshot.hpp"

namespace percuss::app {

/// Hands frames from the engine's thread to the one that records and draws. Bounded by memory: a recorder
/// that cannot keep up slows the run instead of filling the memory, but a run whose frames all fit never
/// waits, and keeps its caches warm.
class FrameQueue {
  public:
    using Frame = std::shared_ptr<const Snapshot>;

    /// @param capacity what all frames in the queue may take [bytes]; two are taken whatever their size.
    explicit FrameQueue(std::size_t capacity) : capacity_(capacity) {}

    /// Waits for room; drops the frame once the queue is closed.
    void push(Frame frame) {
        const std::size_t size = memory_of(*frame);
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [&] { return closed_ || frames_.size() < 2 || size_ + size <= capacity_; });
        if (closed_) return;
        size_ += size;
        frames_.push_back(std::move(frame));
        changed_.notify_all();
    }

    /// The oldest frame; null when none came within `patience` or when the queue is closed and empty.
    [[nodiscard]] Frame pop(std::chrono::milliseconds patience) {
        std::unique_lock lock(mutex_);
        changed_.wait_for(lock, patience, [&] { return closed_ || !frames_.empty(); });
        if (frames_.empty()) return nullptr;
        Frame frame = std::move(frames_.front());
        frames_.pop_front();
        size_ -= memory_of(*frame);
        changed_.notify_all();
        return frame;
    }

    /// No more frames will come (or be waited for); those in the queue can still be taken.
    void close() {
        const std::lock_guard lock(mutex_);
        closed_ = true;
        changed_.notify_all();
    }

    [[nodiscard]] bool drained() const {
        const std::lock_guard lock(mutex_);
        return closed_ && frames_.empty();
    }

  private:
    const std::size_t capacity_;
    mutable std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<Frame> frames_;
    std::size_t size_ = 0;  // of all frames_ [bytes]
    bool closed_ = false;
};

}  // namespace percuss::app
