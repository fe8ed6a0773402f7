#include "machine_limits.hpp"

#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "thread_clock.hpp"

namespace percuss::benchmarks {
namespace {

Peak measure(InstructionSet set) {
#ifdef PERCUSS_X86_KERNELS
    if (set == InstructionSet::avx512) return measure_peak_avx512();
    if (set == InstructionSet::avx2) return measure_peak_avx2();
#else
    static_cast<void>(set);
#endif
    return measure_peak_baseline();
}

double measure_bandwidth(std::size_t bytes) {
    AlignedVector<double> data(bytes / sizeof(double), 1.0);
    const Sweep sweep = peak_of(best_instruction_set()).sweep;
    const std::size_t sweeps = std::max<std::size_t>(4, (std::size_t{256} << 20) / bytes);
    double best = 0;
    for (int repeat = 0; repeat < 5; ++repeat) {
        const double start = thread_seconds();
        for (std::size_t turn = 0; turn < sweeps; ++turn) sweep(data.data(), data.size());
        best = std::max(best, 2.0 * static_cast<double>(bytes) * static_cast<double>(sweeps) /
                                  (thread_seconds() - start));
    }
    return best;
}

}  // namespace

const Peak& peak_of(InstructionSet set) {
    static std::map<InstructionSet, Peak> known;
    const auto found = known.find(set);
    return found != known.end() ? found->second : known.emplace(set, measure(set)).first->second;
}

double bandwidth(std::size_t bytes) {
    static std::map<std::size_t, double> known;
    const auto found = known.find(bytes);
    return found != known.end() ? found->second
                                : known.emplace(bytes, measure_bandwidth(bytes)).first->second;
}

void print_machine_limits() {
    fmt::print("one core of this machine, measured now:\n");
    for (const InstructionSet set :
         {InstructionSet::baseline, InstructionSet::avx2, InstructionSet::avx512}) {
        if (set > best_instruction_set()) break;
        const Peak& peak = peak_of(set);
        fmt::print(
            "  {:<8} {:6.1f} Gflop/s multiply-add, {:6.1f} Gflop/s as separate multiplications and "
            "additions\n",
            name_of(set), peak.multiply_add / 1e9, peak.separate / 1e9);
    }
    for (const auto& [name, bytes] :
         {std::pair{"L2, 512 KiB", std::size_t{512} << 10}, std::pair{"L3, 8 MiB", std::size_t{8} << 20},
          std::pair{"memory, 256 MiB", std::size_t{256} << 20}})
        fmt::print("  {:<16} {:6.1f} GB/s read and written\n", name, bandwidth(bytes) / 1e9);
    fmt::print("\n");
}

}  // namespace percuss::benchmarks
