// The elastic kernels for one instruction set; the build sets the compiler's target for this file.
#define PERCUSS_ISA avx2
#include "elements/kernel_table.hpp"

namespace percuss {

KernelSet find_kernel_avx2(const KernelChoice& choice) { return avx2::kernel_of_geometry<avx2::Elastic, avx2::Double4>(choice); }

}  // namespace percuss
