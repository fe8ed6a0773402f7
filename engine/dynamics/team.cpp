#include "dynamics/team.hpp"

namespace percuss {
namespace {

constexpr int spins =
    2000;  // some microseconds: longer than the serial part between two rounds of a small step
constexpr int yields = 2000;  // about a millisecond: longer than the taking of a snapshot

/// @returns whether `done` came true before patience ran out.
template <class Condition>
bool wait_a_while(Condition done) {
    for (int turn = 0; turn < spins + yields; ++turn) {
        if (done()) return true;
        if (turn >= spins) std::this_thread::yield();
    }
    return false;
}

}  // namespace

Team::Team(int size) {
    for (int part = 1; part < size; ++part) helpers_.emplace_back([this, part] { serve(part); });
}

Team::~Team() {
    closing_.store(true, std::memory_order_relaxed);
    round_.fetch_add(1, std::memory_order_release);
    round_.notify_all();
    for (auto& helper : helpers_) helper.join();
}

void Team::run_all(const void* work, Call call) {
    work_ = work;
    call_ = call;
    busy_.store(static_cast<int>(helpers_.size()), std::memory_order_relaxed);
    round_.fetch_add(1, std::memory_order_release);
    round_.notify_all();  // costs a load when nobody sleeps
    call(work, 0);
    while (!wait_a_while([this] { return busy_.load(std::memory_order_acquire) == 0; })) {
    }
}

void Team::serve(int part) {
    for (unsigned seen = 0;; ++seen) {
        if (!wait_a_while([&] { return round_.load(std::memory_order_acquire) != seen; }))
            round_.wait(seen, std::memory_order_acquire);
        if (closing_.load(std::memory_order_relaxed)) return;
        call_(work_, part);
        busy_.fetch_sub(1, std::memory_order_release);
    }
}

}  // namespace percuss
