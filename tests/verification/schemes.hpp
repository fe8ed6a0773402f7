#pragma once

#include <string>

#include "verification/run.hpp"

namespace percuss::testing {

inline constexpr const char* joint_problem = "[contact_solver]\nscheme = \"joint\"\n";

/// A pair of whole bodies without roles.
inline std::string bodies_pair(const std::string& name, const std::string& one, const std::string& other,
                               const std::string& scheme) {
    return fmt::format("[[contact]]\nname = \"{}\"\nbodies = [\"{}\", \"{}\"]\nscheme = \"{}\"\n", name, one,
                       other, scheme);
}

/// What loads, supports and initial momenta do not account for, relative to what was put in.
inline double momentum_error(const RunStatistics& s) {
    double most = 0;
    for (std::size_t d = 0; d < 2; ++d)
        most = std::max(most, std::abs(s.momentum_final[d] - s.momentum_initial[d] - s.external_impulse[d]));
    return most / (s.momentum_scale + s.external_impulse_gross);
}

}  // namespace percuss::testing
