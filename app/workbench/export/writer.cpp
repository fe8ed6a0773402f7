#include "workbench/export/writer.hpp"

#include <exception>
#include <utility>

namespace percuss::app {

Writer::~Writer() {
    {
        const std::lock_guard lock(mutex_);
        ends_ = true;
    }
    posted_.notify_one();
    if (thread_.joinable()) thread_.join();
}

void Writer::post(Chore chore) {
    {
        const std::lock_guard lock(mutex_);
        chores_.push_back(std::move(chore));
        ++waiting_;
    }
    if (!thread_.joinable()) thread_ = std::thread([this] { work(); });
    posted_.notify_one();
}

std::vector<Writer::Result> Writer::take_results() {
    const std::lock_guard lock(mutex_);
    waiting_ -= results_.size();
    return std::exchange(results_, {});
}

std::size_t Writer::waiting() const {
    const std::lock_guard lock(mutex_);
    return waiting_;
}

void Writer::work() {
    for (std::unique_lock lock(mutex_);;) {
        posted_.wait(lock, [this] { return ends_ || !chores_.empty(); });
        if (chores_.empty()) return;
        const Chore chore = std::move(chores_.front());
        chores_.pop_front();
        lock.unlock();
        Result result;
        try {
            result = {true, chore()};
        } catch (const std::exception& error) {
            result = {false, error.what()};
        }
        lock.lock();
        results_.push_back(std::move(result));
    }
}

}  // namespace percuss::app
