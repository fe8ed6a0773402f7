#include <immintrin.h>

#define PERCUSS_ISA avx512
#include "peak_loops.hpp"

namespace percuss::benchmarks {

Peak measure_peak_avx512() {
    return {
        avx512::fused_rate<__m512d>([](__m512d a, __m512d b, __m512d c) { return _mm512_fmadd_pd(a, b, c); }),
        avx512::separate_rate<__m512d>(), &avx512::sweep<__m512d>};
}

}  // namespace percuss::benchmarks
