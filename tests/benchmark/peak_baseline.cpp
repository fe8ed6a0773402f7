#define PERCUSS_ISA baseline
#include "peak_loops.hpp"

namespace percuss::benchmarks {

Peak measure_peak_baseline() {
    const double rate = baseline::separate_rate<double>();
    return {rate, rate, &baseline::sweep<double>};
}

}  // namespace percuss::benchmarks
