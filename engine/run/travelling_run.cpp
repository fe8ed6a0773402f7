#include "run/travelling_run.hpp"

#include <algorithm>
#include <utility>

namespace percuss {
namespace {

/// Steps between kept states at first: stepping again from one to the next is not felt.
constexpr std::int64_t steps_between_states = 64;
/// A diverged run goes back to its last good step from no further than this.
constexpr std::int64_t steps_between_safe_states = 256;

}  // namespace

TravellingRun::TravellingRun(const Scene& scene, int threads, std::size_t state_memory,
                             std::size_t history_memory)
    : solver_(std::make_unique<Solver>(scene, threads)),
      record_(*solver_->setup(), history_memory),
      probes_(history_memory / 16),
      wanted_(solver_->in_force()) {
    if (state_memory > 0) states_ = std::make_shared<StateHistory>(state_memory, steps_between_states);
}

std::optional<double> TravellingRun::end() const {
    if (!end_) return std::nullopt;
    return end_->solver.time;
}

std::shared_ptr<const KeptState> TravellingRun::keep() const {
    return std::make_shared<const KeptState>(KeptState{solver_->save(), record_.progress()});
}

void TravellingRun::keep_if_due() {
    const std::int64_t step = solver_->steps();
    const bool due = states_ && states_->due(step);
    if (!due && safe_ && step < safe_->solver.step + steps_between_safe_states) return;
    safe_ = keep();
    if (due) states_->add(step, solver_->time(), safe_, memory_of(*safe_));
}

std::optional<Divergence> TravellingRun::step() {
    keep_if_due();
    const double time = solver_->time();
    const std::int64_t failed = solver_->steps();
    record_.before_step(*solver_);
    if (!probes_.none()) probes_.before_step(*solver_);
    auto divergence = solver_->step();
    record_.after_step(*solver_, time, !divergence);
    if (!divergence && !probes_.none()) probes_.after_step(*solver_, time);
    if (!divergence) return std::nullopt;
    // Back to the last step whose stresses are known to be sound.
    solver_->restore(safe_->solver);
    while (solver_->steps() < failed - 1) {
        take_up_change();
        if (!solver_->step()) continue;
        solver_->restore(safe_->solver);
        break;
    }
    return divergence;
}

void TravellingRun::change(const InFlight& values) {
    auto shared = std::make_shared<const InFlight>(values);
    solver_->change(shared);
    wanted_ = std::move(shared);
    if (end_)
        tried_ = true;
    else
        note_change();
}

/// From the present step on the wanted values are in force.
void TravellingRun::note_change() {
    const std::int64_t now = solver_->steps();
    std::erase_if(changes_, [&](const Change& change) { return change.step >= now; });
    changes_.push_back({now, wanted_});
}

/// The values that were set at this very step, if any were.
void TravellingRun::take_up_change() {
    const std::int64_t now = solver_->steps();
    const auto change = std::lower_bound(changes_.begin(), changes_.end(), now,
                                         [](const Change& c, std::int64_t step) { return c.step < step; });
    if (change != changes_.end() && change->step == now) solver_->change(change->values);
}

void TravellingRun::leave_end() {
    end_ = keep();
    states_->set_newest(solver_->steps(), solver_->time(), end_, memory_of(*end_));
}

void TravellingRun::back_at_end() {
    end_.reset();
    record_so_far_.reset();
}

bool TravellingRun::seek(double time, const std::function<bool()>& give_up) {
    if (!end_) leave_end();
    const auto [kept, kept_time] = states_->at_or_before(std::max(time, 0.0));
    const bool on_the_way = record_so_far_ && !tried_ && !reached(time) && solver_->time() >= kept_time;
    if (!on_the_way) {
        solver_->restore(kept->solver);
        record_so_far_ = record_.from(kept->record);
    }
    travelled_ = true;
    tried_ = false;
    while (!reached(time) && solver_->steps() < end_->solver.step) {
        if (give_up()) return false;
        if (!step_again()) break;
    }
    if (solver_->steps() == end_->solver.step) back_at_end();
    return true;
}

/// @returns false when the step failed, which it did not do the first time.
bool TravellingRun::step_again() {
    take_up_change();
    const double time = solver_->time();
    record_so_far_->before_step(*solver_);
    if (solver_->step()) {
        solver_->restore(end_->solver);
        return false;
    }
    record_so_far_->after_step(*solver_, time, true);
    return true;
}

bool TravellingRun::resume() {
    if (travelled_) {
        solver_->change(wanted_);
        note_change();
        travelled_ = tried_ = false;
    }
    if (!end_) return false;
    record_ = std::move(*record_so_far_);
    probes_.branch(solver_->time());
    states_ = states_->up_to(solver_->time());
    safe_.reset();
    back_at_end();
    return true;
}

}  // namespace percuss
