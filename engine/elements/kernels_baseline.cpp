// The elastic kernels for one instruction set; the build sets the compiler's target for this file.
#define PERCUSS_ISA baseline
#include "elements/kernel_table.hpp"

namespace percuss {

KernelSet find_kernel_baseline(const KernelChoice& choice) { return baseline::kernel_of_geometry<baseline::Elastic, double>(choice); }

}  // namespace percuss
