// The elastic kernels for one instruction set; the build sets the compiler's target for this file.
#define PERCUSS_ISA avx512
#include "elements/kernel_table.hpp"

namespace percuss {

KernelSet find_kernel_avx512(const KernelChoice& choice) { return avx512::kernel_of_geometry<avx512::Elastic, avx512::Double8>(choice); }

}  // namespace percuss
