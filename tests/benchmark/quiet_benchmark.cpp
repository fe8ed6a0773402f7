#include <benchmark/benchmark.h>

#include "rods.hpp"
#include "solver.hpp"

namespace percuss::benchmarks {
namespace {

/// On one core; range 1: whether what is at rest is left out.
void run(benchmark::State& state, const Scene& scene) {
    for (auto _ : state) {
        state.PauseTiming();
        Solver solver(scene, 1);
        if (state.range(1) == 0) solver.visit_all();
        state.ResumeTiming();
        while (!solver.finished())
            if (solver.step()) state.SkipWithError("the run diverged");
    }
}

/// From impact until the wave is at the far end of the rod of 200 mm, which takes 38.7 us.
Scene rods_until_the_wave_is_through(const benchmark::State& state) {
    Scene scene = rods(static_cast<int>(state.range(0)));
    scene.duration = 0.0387;
    return scene;
}

void rods_wave(benchmark::State& state) { run(state, rods_until_the_wave_is_through(state)); }

/// The same rod, struck by a thin plate.
void struck_bar(benchmark::State& state) {
    Scene scene = rods_until_the_wave_is_through(state);
    Block& plate = scene.bodies[0].blocks[0];
    plate.corners[0].y() = plate.corners[1].y() = -4;
    plate.divisions[1] = 2 * static_cast<int>(state.range(0)) / 5;
    run(state, scene);
}

BENCHMARK(rods_wave)
    ->ArgsProduct({{5, 20}, {0, 1}})
    ->ArgNames({"radial", "skip"})
    ->Unit(benchmark::kMillisecond);
BENCHMARK(struck_bar)
    ->ArgsProduct({{5, 20}, {0, 1}})
    ->ArgNames({"radial", "skip"})
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace percuss::benchmarks
