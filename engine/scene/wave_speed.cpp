#include <array>
#include <cmath>
#include <string_view>

#include <fmt/format.h>

#include "scene/readers.hpp"

namespace percuss {
namespace {

struct Candidate {
    std::string_view unit;
    double si;
};

constexpr std::array<Candidate, 4> density_units{
    {{"kg/m^3", 1}, {"g/cm^3", 1e3}, {"kg/mm^3", 1e9}, {"t/mm^3", 1e12}}};
constexpr std::array<Candidate, 3> modulus_units{{{"Pa", 1}, {"MPa", 1e6}, {"GPa", 1e9}}};

bool between(double low, double value, double high) { return low <= value && value <= high; }

/// What the writer may have meant, when `value` in another unit falls in the range of solids; else "".
template <std::size_t N>
std::string slip(std::string_view key, double value, double si, const std::string& declared,
                 const std::array<Candidate, N>& units, double low, double high) {
    if (between(low, value * si, high)) return "";
    for (const auto& unit : units)
        if (between(low, value * unit.si, high))
            return fmt::format("{} = {} looks like {}, which is {:.6g} {}", key, value, unit.unit,
                               value * unit.si / si, declared);
    return "";
}

}  // namespace

void check_wave_speed(const Units& units, const Material& material, const Place& place, Faults& faults) {
    const double speed = std::sqrt(material.young / material.density) * units.si(Quantity::velocity);
    if (between(50, speed, 20'000)) return;
    std::string hint = slip("density", material.density, units.si(Quantity::density),
                            units.label(Quantity::density), density_units, 100, 25'000);
    const std::string modulus = slip("young", material.young, units.si(Quantity::stress),
                                     units.label(Quantity::stress), modulus_units, 1e8, 1.5e12);
    if (!hint.empty() && !modulus.empty()) hint += " and ";
    hint += modulus;
    if (hint.empty())
        hint = fmt::format("check density [{}] and young [{}]", units.label(Quantity::density),
                           units.label(Quantity::stress));
    faults.warning(
        place,
        fmt::format("material '{}' has a wave speed of {:.3g} m/s in the declared units {}, {}, {}, where 50 "
                    "to 20000 m/s are usual; {}",
                    material.name, speed, units.length_name(), units.time_name(), units.mass_name(), hint));
}

}  // namespace percuss
