#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace percuss {

/// Moments of a run, evenly spaced, within a bound of memory: when it is reached, every second one is dropped
/// and only those on the wider grid are kept from then on, so that what is kept always covers the whole run.
/// The first and the newest are never dropped, even where those two alone exceed the bound.
///
/// Entries are immutable and shared: who holds one keeps it. One thread adds, any number of threads read;
/// nobody waits for long.
template <class Entry>
class ThinnedHistory {
  public:
    /// @param bound of the entries' memory [bytes]; @param stride places between entries at first, at
    /// least 1.
    ThinnedHistory(std::size_t bound, std::int64_t stride) : bound_(bound), stride_(stride) {
        assert(stride >= 1);
    }

    /// Whether the run has come to a place of the grid (a step, a multiple of an interval) that has no entry
    /// yet.
    [[nodiscard]] bool due(std::int64_t place) const {
        const std::lock_guard lock(mutex_);
        return is_due(place);
    }

    /// Appends the entry of a later time. @param time [time]; @param bytes that it takes.
    void add(std::int64_t place, double time, std::shared_ptr<const Entry> entry, std::size_t bytes) {
        std::vector<Slot> dropped;  // freed without the lock
        const std::lock_guard lock(mutex_);
        release_newest(dropped);
        append({place - place % stride_, time, bytes, true, std::move(entry)}, dropped);
    }

    /// Makes this the newest entry, whether one is due or not; if not, the next one displaces it. Entries
    /// that are not earlier go.
    void set_newest(std::int64_t place, double time, std::shared_ptr<const Entry> entry, std::size_t bytes) {
        std::vector<Slot> dropped;  // freed without the lock
        const std::lock_guard lock(mutex_);
        while (!slots_.empty() && slots_.back().time >= time) pop(dropped);
        release_newest(dropped);
        const bool due = is_due(place);
        append({due ? place - place % stride_ : place, time, bytes, due, std::move(entry)}, dropped);
    }

    /// The newest entry that is not later than `time`, with its own time; null when there is none [time].
    [[nodiscard]] std::pair<std::shared_ptr<const Entry>, double> at_or_before(double time) const {
        const std::lock_guard lock(mutex_);
        const auto after = std::upper_bound(slots_.begin(), slots_.end(), time,
                                            [](double t, const Slot& slot) { return t < slot.time; });
        if (after == slots_.begin()) return {nullptr, 0};
        return {std::prev(after)->entry, std::prev(after)->time};
    }

    /// The entries up to and with `time`, as a history of their own with the same bound and grid [time].
    [[nodiscard]] std::shared_ptr<ThinnedHistory> up_to(double time) const {
        const std::lock_guard lock(mutex_);
        auto part = std::make_shared<ThinnedHistory>(bound_, stride_);
        for (const Slot& slot : slots_) {
            if (slot.time > time) break;
            part->bytes_ += slot.bytes;
            part->slots_.push_back(slot);
        }
        return part;
    }

    [[nodiscard]] std::vector<double> times() const {  ///< of the entries, ascending [time]
        const std::lock_guard lock(mutex_);
        std::vector<double> times;
        for (const Slot& slot : slots_) times.push_back(slot.time);
        return times;
    }
    [[nodiscard]] std::size_t bytes() const {  ///< that the entries take
        const std::lock_guard lock(mutex_);
        return bytes_;
    }

  private:
    struct Slot {
        std::int64_t place;
        double time;
        std::size_t bytes;
        bool on_grid;
        std::shared_ptr<const Entry> entry;
    };

    [[nodiscard]] bool is_due(std::int64_t place) const {
        return slots_.empty() || place / stride_ > slots_.back().place / stride_;
    }

    void pop(std::vector<Slot>& dropped) {
        bytes_ -= slots_.back().bytes;
        dropped.push_back(std::move(slots_.back()));
        slots_.pop_back();
    }
    /// The newest entry will no longer be that: it goes unless it is on the grid or the first.
    void release_newest(std::vector<Slot>& dropped) {
        if (slots_.size() > 1 && !stays_on_grid(slots_.back())) pop(dropped);
    }
    [[nodiscard]] bool stays_on_grid(const Slot& slot) const {
        return slot.on_grid && slot.place % stride_ == 0;
    }
    void append(Slot slot, std::vector<Slot>& dropped) {
        bytes_ += slot.bytes;
        slots_.push_back(std::move(slot));
        while (bytes_ > bound_ && slots_.size() > 2) {
            stride_ *= 2;
            std::vector<Slot> kept;
            for (std::size_t k = 0; k < slots_.size(); ++k) {
                const bool stays = k == 0 || k + 1 == slots_.size() || stays_on_grid(slots_[k]);
                if (!stays) bytes_ -= slots_[k].bytes;
                (stays ? kept : dropped).push_back(std::move(slots_[k]));
            }
            slots_ = std::move(kept);
        }
    }

    mutable std::mutex mutex_;  // held while the list is touched, never while entries are made
    std::size_t bound_, bytes_ = 0;
    std::int64_t stride_;
    std::vector<Slot> slots_;
};

}  // namespace percuss
