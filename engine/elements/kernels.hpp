#pragma once

#include <string_view>

#include "elements/batch.hpp"

namespace percuss {

enum class InstructionSet { baseline, avx2, avx512 };

/// The widest instruction set that this processor and this build have.
[[nodiscard]] InstructionSet best_instruction_set();
[[nodiscard]] std::string_view name_of(InstructionSet set);

enum class PlasticLaw { none, voce, tabulated, johnson_cook };  ///< as in Plasticity

/// What decides which kernel serves a batch. All of it is fixed when the scene loads, so no kernel tests it.
struct KernelChoice {
    ElementKind kind = ElementKind::quad_one_point;
    Geometry geometry = Geometry::axisymmetric;
    bool hourglass = false;  ///< one-point quads only
    bool viscous = false;
    PlasticLaw law = PlasticLaw::none;  ///< not with plane stress
};

/// The compiled combination. `baseline` is the scalar reference; all sets give the same bits.
[[nodiscard]] KernelSet find_kernel(const KernelChoice& choice, InstructionSet set);

}  // namespace percuss
