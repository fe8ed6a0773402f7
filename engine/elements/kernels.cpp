#include "elements/kernels.hpp"

namespace percuss {

KernelSet find_kernel_baseline(const KernelChoice& choice);
KernelSet find_plastic_kernel_baseline(const KernelChoice& choice);
#ifdef PERCUSS_X86_KERNELS
KernelSet find_kernel_avx2(const KernelChoice& choice);
KernelSet find_plastic_kernel_avx2(const KernelChoice& choice);
KernelSet find_kernel_avx512(const KernelChoice& choice);
KernelSet find_plastic_kernel_avx512(const KernelChoice& choice);
#endif

InstructionSet best_instruction_set() {
#ifdef PERCUSS_X86_KERNELS
    if (__builtin_cpu_supports("x86-64-v4")) return InstructionSet::avx512;
    if (__builtin_cpu_supports("x86-64-v3")) return InstructionSet::avx2;
#endif
    return InstructionSet::baseline;
}

std::string_view name_of(InstructionSet set) {
    switch (set) {
        case InstructionSet::avx512: return "AVX-512";
        case InstructionSet::avx2: return "AVX2";
        case InstructionSet::baseline: break;
    }
    return "scalar";
}

KernelSet find_kernel(const KernelChoice& choice, InstructionSet set) {
    const bool plastic = choice.law != PlasticLaw::none;
#ifdef PERCUSS_X86_KERNELS
    if (set == InstructionSet::avx512) return plastic ? find_plastic_kernel_avx512(choice) : find_kernel_avx512(choice);
    if (set == InstructionSet::avx2) return plastic ? find_plastic_kernel_avx2(choice) : find_kernel_avx2(choice);
#else
    static_cast<void>(set);
#endif
    return plastic ? find_plastic_kernel_baseline(choice) : find_kernel_baseline(choice);
}

}  // namespace percuss
