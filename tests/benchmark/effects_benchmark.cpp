#include <functional>

#include <benchmark/benchmark.h>

#include "rods.hpp"
#include "run/history.hpp"
#include "run/history_columns.hpp"
#include "solver.hpp"
#include "thread_clock.hpp"

namespace percuss::benchmarks {
namespace {

/// A scene that calls for one effect beside what the first of these calls for: two bars of one-point quads
/// with hourglass stiffness that stretch evenly, without contact.
struct Effect {
    const char* name;
    std::vector<std::string> overrides;
    bool history = false;  ///< a row of it is kept at every step
};

std::vector<std::string> of_each_body(const std::string& key_and_value) {
    return {"body.striker." + key_and_value, "body.rod." + key_and_value};
}

const std::string flows_at = "material.steel.plastic={yield=",
                  hardens = ",linear=0.5,saturation=0.1,rate=10}";

const std::vector<Effect> effects{
    {"none", {}},
    {"no hourglass stiffness", of_each_body("hourglass=0")},
    {"bulk viscosity", {"material.steel.viscosity={linear=0.06,quadratic=1.2}"}},
    {"plasticity, none flows", {flows_at + "100" + hardens}},
    {"plasticity, all flow", {flows_at + "1e-6" + hardens}},
    {"tabulated hardening, all flow", {"material.steel.plastic={points=[[0,1e-6],[1,0.5]]}"}},
    {"Johnson-Cook, all flow",
     {"material.steel.johnson_cook={yield=1e-6,hardening=0.3,exponent=0.3,rate_factor=0.02,reference_rate=1e-"
      "3,"
      "melting_temperature=1800,heat_capacity=450}"}},
    {"body force", of_each_body("body_force=[0,-0.00981]")},
    {"mean-dilatation quads", of_each_body("element=\"mean-dilatation quad\"")},
    {"history of every step", {}, true},
};

/// 12,000 elements on one core; time is that of the thread.
void effect(benchmark::State& state, const Effect& of) {
    constexpr int warm_up = 20, steps = 100;
    Scene scene = rods(20, of.overrides);
    scene.contacts.clear();
    scene.probes.clear();
    scene.figures.clear();
    scene.energy_growth_limit = 1e9;  // of a start that the scene does not know
    Solver solver(scene, 1);
    SolverState start = solver.save();
    for (Node& node : start.nodes) {
        node.v[0] = -0.1 * node.x[0];
        node.v[1] = 0.3 * node.x[1];
    }
    double elements = 0, seconds = 0;
    for (auto _ : state) {
        solver.restore(start);
        History history(history_columns(scene));
        const auto step = [&] {
            if (solver.step()) state.SkipWithError("the run diverged");
            if (of.history) history.append(solver.history_row());
        };
        for (int n = 0; n < warm_up; ++n) step();
        const double begin = thread_seconds();
        for (int n = 0; n < steps; ++n) step();
        const double spent = thread_seconds() - begin;
        state.SetIterationTime(spent);
        seconds += spent;
        elements += steps * static_cast<double>(solver.statistics(false).cells);
    }
    state.counters["ns_per_element_step"] = 1e9 * seconds / elements;
    state.counters["element_steps"] = elements / seconds;
}

const bool registered = [] {
    for (const Effect& of : effects)
        benchmark::RegisterBenchmark(("effect/" + std::string(of.name)).c_str(),
                                     [&of](benchmark::State& state) { effect(state, of); })
            ->UseManualTime()
            ->Unit(benchmark::kMillisecond);
    return true;
}();

}  // namespace
}  // namespace percuss::benchmarks
