// What each command does, on the engine thread.
#include <cmath>
#include <exception>
#include <limits>
#include <stdexcept>
#include <utility>

#include "run/engine_thread.hpp"
#include "run/in_flight.hpp"
#include "scene/parse.hpp"

namespace percuss {
namespace {

constexpr double forever = std::numeric_limits<double>::infinity();
constexpr auto no_limit = std::numeric_limits<std::int64_t>::max();

template <class... Handlers>
struct Overloaded : Handlers... {
    using Handlers::operator()...;
};

}  // namespace

void Engine::Impl::start(double until, std::int64_t count, bool with_pace) {
    if (state == RunStatus::finished || state == RunStatus::diverged) {
        say("the run has ended; reset it to run again");
        return;
    }
    if (count <= 0 || reached(until)) return;
    try {
        if (run->resume()) begin_branch();
    } catch (const SceneError& error) {
        for (const std::string& line : error.messages()) say(line);
        return;
    }
    pause_at = until;
    steps_left = count;
    if (state != RunStatus::running || !paced) pace.start(solver().time(), Pace::Clock::now());
    paced = with_pace;
    state = RunStatus::running;
    status = state;
}

void Engine::Impl::begin_branch() {
    frames = 0;
    skip_reached_frames();
    if (kept_frames) kept_frames = kept_frames->up_to(solver().time());
    kept_frame = multiple_of_kept_frames();
    publish(true);
}

void Engine::Impl::say(std::string text) {
    const std::lock_guard lock(mutex);
    messages.push_back(std::move(text));
}

void Engine::Impl::take_over(Scene changed) {
    scene = std::move(changed);
    auto copy = std::make_shared<const Scene>(scene);
    const std::lock_guard lock(mutex);
    scene_as_set = std::move(copy);
}

void Engine::Impl::set(const command::Set& command) {
    std::vector<std::string> overrides = scene.overrides;
    overrides.push_back(command.key + "=" + command.value);
    try {
        Scene changed = parse_scene(scene.text, scene.file, overrides);
        // Of a figure the key tells what is drawn and what is sampled.
        const bool harmless = effect_of_change(command.key) == ChangeEffect::none;
        change(std::move(changed), harmless);
    } catch (const SceneError& error) {
        for (const std::string& line : error.messages()) say(line);
    } catch (const std::exception& error) {
        say(command.key + " = " + command.value + ": " + error.what());
    }
}

void Engine::Impl::change(Scene changed, bool harmless) {
    switch (harmless ? ChangeEffect::none : effect_of_change(scene, changed)) {
        case ChangeEffect::none:
            break;
        case ChangeEffect::next_step:
            run->change(in_flight(changed));
            break;
        case ChangeEffect::rebuild:
            replace_run(changed);
            take_over(std::move(changed));
            begin_run();
            return;
    }
    take_over(std::move(changed));
}

void Engine::Impl::add_probe(const Probe& probe) {
    try {
        run->probes().add(*solver().setup(), probe);
    } catch (const std::invalid_argument& error) {
        say(error.what());
    }
}

void Engine::Impl::replace_run(const Scene& of) {
    const std::vector<SetProbe> set_probes = run->probes().probes();
    run = make_run(of);
    for (const SetProbe& set_probe : set_probes) add_probe(set_probe.probe);
}

void Engine::Impl::set_speed(std::optional<double> wanted) {
    if (wanted && !(*wanted > 0 && std::isfinite(*wanted))) {
        say("a speed is a number above 0");
        return;
    }
    pace.set_target(wanted, solver().time(), Pace::Clock::now());
    const std::lock_guard lock(mutex);
    target_speed = wanted;
}

bool Engine::Impl::seek_is_superseded() {
    if (!commands_waiting.load(std::memory_order_acquire)) return false;
    const std::lock_guard lock(mutex);
    if (commands.empty()) return false;
    const Command& next = commands.front();
    return std::holds_alternative<command::Seek>(next) || std::holds_alternative<command::Reset>(next) ||
           std::holds_alternative<command::Stop>(next);
}

void Engine::Impl::seek(double to) {
    if (!run->states()) {
        say("no states are kept to go back to");
        return;
    }
    if (std::isnan(to)) {
        say("a moment to go to is a number");
        return;
    }
    if (state == RunStatus::running) {
        state = RunStatus::paused;
        publish(true);
    }
    if (!run->end()) {
        state_at_end = state;
        failure_at_end = failure;
    }
    state = RunStatus::paused;
    failure = {};
    const bool there = run->seek(to, [this] { return seek_is_superseded(); });
    if (!run->end()) {
        state = state_at_end;
        failure = failure_at_end;
    }
    publish(there);
}

void Engine::Impl::obey(const Command& command) {
    const bool counting = state == RunStatus::running && steps_left < no_limit;
    std::visit(
        Overloaded{[&](const command::Run& what) { start(what.until.value_or(forever), no_limit, true); },
                   [&](const command::Steps& steps) {
                       start(forever, steps.count + (counting ? steps_left : 0), false);
                   },
                   [&](const command::Pause&) {
                       if (state == RunStatus::running) state = RunStatus::paused;
                       publish(true);
                   },
                   [&](const command::Reset&) {
                       replace_run(scene);
                       begin_run();
                   },
                   [&](const command::Seek& where) { seek(where.time); },
                   [&](const command::Set& what) { set(what); },
                   [&](const command::Change& what) {
                       try {
                           change(*what.scene, false);
                       } catch (const SceneError& error) {
                           for (const std::string& line : error.messages()) say(line);
                       }
                   },
                   [&](const command::SetSpeed& what) { set_speed(what.speed); },
                   [&](const command::AddProbe& what) {
                       add_probe(what.probe);
                       publish(state != RunStatus::running);
                   },
                   [&](const command::RemoveProbe& what) {
                       run->probes().remove(what.name);
                       publish(state != RunStatus::running);
                   },
                   [&](const command::Stop&) {
                       if (state == RunStatus::running) state = RunStatus::paused;
                       publish(true);
                       stop = true;
                   }},
        command);
}

}  // namespace percuss
