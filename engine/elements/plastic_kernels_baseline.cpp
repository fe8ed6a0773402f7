// The plastic kernels for one instruction set; the build sets the compiler's target for this file.
#define PERCUSS_ISA baseline
#include "elements/kernel_table.hpp"
#include "materials/johnson_cook.hpp"
#include "materials/tabulated.hpp"
#include "materials/voce.hpp"

namespace percuss {

KernelSet find_plastic_kernel_baseline(const KernelChoice& choice) {
    using namespace baseline;
    if (choice.law == PlasticLaw::voce) return kernel_of_geometry<J2<Voce>, double>(choice);
    if (choice.law == PlasticLaw::tabulated) return kernel_of_geometry<J2<Tabulated>, double>(choice);
    return kernel_of_geometry<J2<JohnsonCookFlow>, double>(choice);
}

}  // namespace percuss
