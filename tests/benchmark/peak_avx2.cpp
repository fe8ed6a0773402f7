#include <immintrin.h>

#define PERCUSS_ISA avx2
#include "peak_loops.hpp"

namespace percuss::benchmarks {

Peak measure_peak_avx2() {
    return {
        avx2::fused_rate<__m256d>([](__m256d a, __m256d b, __m256d c) { return _mm256_fmadd_pd(a, b, c); }),
        avx2::separate_rate<__m256d>(), &avx2::sweep<__m256d>};
}

}  // namespace percuss::benchmarks
