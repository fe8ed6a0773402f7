#include <benchmark/benchmark.h>

#include "rods.hpp"
#include "run/history.hpp"
#include "run/history_columns.hpp"
#include "solver.hpp"

namespace percuss::benchmarks {
namespace {

/// The whole scene from impact to 60 us on one core, ledger on and histories kept at every step.
void whole_rods(benchmark::State& state) {
    const Scene scene = rods(static_cast<int>(state.range(0)));
    double steps = 0, contact = 0, all = 0, elements = 0;
    for (auto _ : state) {
        state.PauseTiming();
        Solver solver(scene, 1);
        History history(history_columns(scene));
        state.ResumeTiming();
        while (!solver.finished()) {
            if (solver.step()) state.SkipWithError("the run diverged");
            history.append(solver.history_row());
        }
        const RunStatistics statistics = solver.statistics(false);
        steps += static_cast<double>(statistics.steps * statistics.cells);
        contact += statistics.seconds.contact_search + statistics.seconds.contact_solve;
        elements += statistics.seconds.elements;
        all += statistics.step_seconds;
    }
    state.counters["element_steps"] = benchmark::Counter(steps, benchmark::Counter::kIsRate);
    state.counters["contact_share"] = contact / all;
    state.counters["element_share"] = elements / all;
}

BENCHMARK(whole_rods)->Arg(5)->Arg(20)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace percuss::benchmarks
