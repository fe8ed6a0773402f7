#pragma once

#include <ostream>
#include <string>

#include "verification/run.hpp"

namespace percuss::testing {

inline constexpr const char* joint_problem = "[contact_solver]\nscheme = \"joint\"\n";

/// A contact scheme as scenes choose it.
struct SchemeChoice {
    const char* name;
    const char* rows;       ///< scheme of the pair
    const char* pair = "";  ///< more keys of the pair
    const char* solver = joint_problem;
    double growth = 1e-5;  ///< of the energy, that blocks which bounce and slide may show
};
inline std::ostream& operator<<(std::ostream& out, const SchemeChoice& scheme) { return out << scheme.name; }

/// A pair of whole bodies without roles.
inline std::string bodies_pair(const std::string& name, const std::string& one, const std::string& other,
                               const std::string& scheme) {
    return fmt::format("[[contact]]\nname = \"{}\"\nbodies = [\"{}\", \"{}\"]\nscheme = \"{}\"\n", name, one,
                       other, scheme);
}

inline std::string bodies_pair(const std::string& name, const std::string& one, const std::string& other,
                               const SchemeChoice& scheme) {
    return scheme.solver + bodies_pair(name, one, other, std::string(scheme.rows)) + scheme.pair;
}

/// What loads, supports and initial momenta do not account for, relative to what was put in.
inline double momentum_error(const RunStatistics& s) {
    double most = 0;
    for (std::size_t d = 0; d < 2; ++d)
        most = std::max(most, std::abs(s.momentum_final[d] - s.momentum_initial[d] - s.external_impulse[d]));
    return most / (s.momentum_scale + s.external_impulse_gross);
}

}  // namespace percuss::testing
