#include "live/recording.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace percuss::app {
namespace {

/// Frames asked for at the same time by those who show, compare and export.
constexpr std::size_t most_wanted = 4;

}  // namespace

Recording::Recording(const std::filesystem::path& file, const OpenRun& open, std::size_t bound)
    : source_(open(file)),
      times_(source_->frame_times()),
      history_(source_->history()),
      traces_(source_->traces()),
      bound_(bound) {
    if (times_.empty()) throw std::runtime_error(file.string() + ": the run has no complete frame yet");
    keep(0, source_->frame(0));
    thread_ = std::thread([this] { serve(); });
}

Recording::~Recording() {
    {
        const std::lock_guard lock(mutex_);
        stop_ = true;
    }
    asked_.notify_all();
    thread_.join();
}

std::int64_t Recording::index_at(double time) const {
    const auto after = std::upper_bound(times_.begin(), times_.end(), time * (1 + 1e-12));
    return std::max<std::int64_t>(after - times_.begin() - 1, 0);
}

std::shared_ptr<const Snapshot> Recording::frame_at(double time) {
    std::int64_t index = index_at(time);
    const std::lock_guard lock(mutex_);
    while (index > 0 && damaged_.contains(index)) --index;
    if (index != asked_for_) asked_.notify_all();  // the next one is read beforehand
    asked_for_ = index;
    if (const auto found = kept_.find(index); found != kept_.end()) {
        found->second.asked = ++asks_;
        return found->second.frame;
    }
    if (damaged_.contains(index)) return last_read_;
    std::erase(wanted_, index);
    wanted_.push_back(index);
    if (wanted_.size() > most_wanted) wanted_.erase(wanted_.begin());
    asked_.notify_all();
    return nullptr;
}

std::shared_ptr<const Snapshot> Recording::last_read() const {
    const std::lock_guard lock(mutex_);
    return last_read_;
}

bool Recording::reading() const {
    const std::lock_guard lock(mutex_);
    return !wanted_.empty();
}

std::size_t Recording::bytes() const {
    const std::lock_guard lock(mutex_);
    return bytes_;
}

void Recording::add_probe(const Probe& probe) {
    const std::lock_guard lock(mutex_);
    survey_.add(*last_read_->setup, probe);
    asked_.notify_all();
}

void Recording::remove_probe(const std::string& name) {
    const std::lock_guard lock(mutex_);
    survey_.remove(name);
}

bool Recording::reading_probes() const {
    const std::lock_guard lock(mutex_);
    return survey_.next(static_cast<std::int64_t>(times_.size())) >= 0;
}

std::vector<SetProbe> Recording::probes() const {
    const std::lock_guard lock(mutex_);
    return survey_.probes();
}

std::vector<std::string> Recording::take_messages() {
    const std::lock_guard lock(mutex_);
    return std::exchange(messages_, {});
}

std::int64_t Recording::next_to_read() const {
    if (!wanted_.empty()) return wanted_.back();
    const std::int64_t ahead = asked_for_ + 1;
    return ahead < static_cast<std::int64_t>(times_.size()) && !at_hand(ahead) ? ahead : -1;
}

void Recording::keep(std::int64_t index, std::shared_ptr<const Snapshot> frame) {
    const std::size_t size = memory_of(*frame);
    const bool was_asked_for = std::erase(wanted_, index) > 0;
    if (was_asked_for || !last_read_) last_read_ = frame;
    bytes_ += size;
    kept_[index] = {std::move(frame), size, ++asks_};
    while (bytes_ > bound_ && kept_.size() > 1) {
        auto oldest = kept_.end();
        for (auto entry = kept_.begin(); entry != kept_.end(); ++entry)
            if (entry->first != asked_for_ && entry->first != index &&
                (oldest == kept_.end() || entry->second.asked < oldest->second.asked))
                oldest = entry;
        if (oldest == kept_.end()) break;
        bytes_ -= oldest->second.bytes;
        kept_.erase(oldest);
    }
}

void Recording::survey(std::unique_lock<std::mutex>& lock, std::int64_t index) {
    std::shared_ptr<const Snapshot> frame;
    if (const auto found = kept_.find(index); found != kept_.end()) {
        frame = found->second.frame;
    } else if (!damaged_.contains(index)) {
        std::string fault;
        lock.unlock();
        try {
            frame = source_->frame(index);
        } catch (const std::exception& error) {
            fault = error.what();
        }
        lock.lock();
        if (!frame) {
            damaged_.insert(index);
            messages_.push_back(std::move(fault));
        }
    }
    survey_.take(index, frame.get());
}

void Recording::serve() {
    std::unique_lock lock(mutex_);
    while (!stop_) {
        const std::int64_t next = next_to_read();
        if (next < 0) {
            const std::int64_t surveyed = survey_.next(static_cast<std::int64_t>(times_.size()));
            if (surveyed >= 0)
                survey(lock, surveyed);
            else
                asked_.wait(lock);
            continue;
        }
        lock.unlock();
        std::shared_ptr<const Snapshot> frame;
        std::string fault;
        try {
            frame = source_->frame(next);
        } catch (const std::exception& error) {
            fault = error.what();
        }
        lock.lock();
        if (frame) {
            keep(next, std::move(frame));
        } else {
            std::erase(wanted_, next);
            damaged_.insert(next);
            messages_.push_back(std::move(fault));
        }
    }
}

}  // namespace percuss::app
