#include <benchmark/benchmark.h>

#include "elements/kernels.hpp"
#include "machine_limits.hpp"
#include "mesh/build.hpp"
#include "rods.hpp"
#include "thread_clock.hpp"

namespace percuss::benchmarks {
namespace {

struct Case {
    const char* name;
    const char* element;  // as the scene file says it
    double flops;  // of one element and step, as the AVX-512 kernels are compiled; a division or root is one
    bool viscous;
};

constexpr Case cases[] = {
    {"one_point", "one-point quad", 299, false},
    {"one_point_viscous", "one-point quad", 317, true},
    {"mean_dilatation", "mean-dilatation quad", 848, false},
    {"triangle", "triangle", 153, false},
    {"averaged_triangle", "averaged triangle", 173, false},
};

bool is_triangle(const Case& of) { return std::string_view(of.element).ends_with("triangle"); }

std::vector<std::string> overrides_of(const Case& of) {
    std::vector<std::string> overrides;
    for (const char* body : {"striker", "rod"}) {
        overrides.push_back(std::string("body.") + body + ".element=\"" + of.element + "\"");
        if (is_triangle(of)) overrides.push_back(std::string("body.") + body + ".pattern=\"diagonal\"");
    }
    if (of.viscous) overrides.push_back("material.steel.viscosity={linear=0.06,quadratic=1.2}");
    return overrides;
}

/// The forces of all elements of the rods, in slow uniform motion, on one core.
void element_forces(benchmark::State& state, const Case& of, InstructionSet set, int radial) {
    const Scene scene = rods(radial, overrides_of(of));
    const Mesh mesh = build_mesh(scene);
    const std::vector<std::array<bool, 2>> held(mesh.nodes.size(), {false, false});
    AlignedVector<Node> nodes;
    for (const Vec2& x : mesh.nodes) nodes.push_back({{x.x(), x.y()}, {1e-6 * x.x(), 1e-6 * x.y()}});
    std::vector<Batch> batches;
    double cells = 0;
    for (std::int32_t body = 0; body < static_cast<std::int32_t>(scene.bodies.size()); ++body) {
        batches.push_back(make_batch(scene, mesh, body, held));
        Batch& batch = batches.back();
        batch.kernel = find_kernel(
            {batch.kind, batch.geometry, batch.kind == ElementKind::quad_one_point, of.viscous}, set);
        cells += batch.count;
    }
    KernelSums sums;
    const double start = thread_seconds();
    for (auto _ : state)
        for (Batch& batch : batches) {
            average_volumes(batch, nodes.data());
            batch.kernel.forces(batch, nodes.data(), 1e-4, 0, batch.blocks(), sums);
        }
    const double seconds = thread_seconds() - start;
    benchmark::DoNotOptimize(sums);

    const double updates = cells * static_cast<double>(state.iterations());
    const double flops = updates * of.flops / seconds;
    state.counters["elements"] = cells;
    state.counters["element_steps"] = benchmark::Counter(updates, benchmark::Counter::kIsRate);
    state.counters["of_multiply_add_peak"] = flops / peak_of(set).multiply_add;
    state.counters["of_separate_peak"] = flops / peak_of(set).separate;
}

const bool registered = [] {
    for (const Case& of : cases)
        for (const InstructionSet set :
             {InstructionSet::baseline, InstructionSet::avx2, InstructionSet::avx512})
            for (const int radial : {5, 20}) {
                if (set > best_instruction_set()) continue;
                const std::string name = std::string("element_forces/") + of.name + "/" +
                                         std::string(name_of(set)) + "/" +
                                         std::to_string(30 * radial * radial * (is_triangle(of) ? 2 : 1));
                benchmark::RegisterBenchmark(
                    name.c_str(), [=](benchmark::State& state) { element_forces(state, of, set, radial); });
            }
    return true;
}();

}  // namespace
}  // namespace percuss::benchmarks
