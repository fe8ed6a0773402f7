// The plastic kernels for one instruction set; the build sets the compiler's target for this file.
#define PERCUSS_ISA avx512
#include "elements/kernel_table.hpp"
#include "materials/johnson_cook.hpp"
#include "materials/tabulated.hpp"
#include "materials/voce.hpp"

namespace percuss {

KernelSet find_plastic_kernel_avx512(const KernelChoice& choice) {
    using namespace avx512;
    if (choice.law == PlasticLaw::voce) return kernel_of_geometry<J2<Voce>, avx512::Double8>(choice);
    if (choice.law == PlasticLaw::tabulated)
        return kernel_of_geometry<J2<Tabulated>, avx512::Double8>(choice);
    return kernel_of_geometry<J2<JohnsonCookFlow>, avx512::Double8>(choice);
}

}  // namespace percuss
