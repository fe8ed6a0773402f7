#include "units.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "nearest_name.hpp"

namespace percuss {
namespace {

struct BaseUnit {
    std::string_view name;
    double si;
};

constexpr std::array<BaseUnit, 6> lengths{
    {{"m", 1}, {"cm", 1e-2}, {"mm", 1e-3}, {"um", 1e-6}, {"in", 0.0254}, {"ft", 0.3048}}};
constexpr std::array<BaseUnit, 4> times{{{"s", 1}, {"ms", 1e-3}, {"us", 1e-6}, {"ns", 1e-9}}};
constexpr std::array<BaseUnit, 5> masses{
    {{"t", 1e3}, {"kg", 1}, {"g", 1e-3}, {"mg", 1e-6}, {"lb", 0.45359237}}};

template <std::size_t N>
double base_si(std::string_view name, const std::array<BaseUnit, N>& units, std::string_view what) {
    std::vector<std::string> names;
    for (const auto& unit : units) {
        if (unit.name == name) return unit.si;
        names.emplace_back(unit.name);
    }
    throw std::invalid_argument("unknown unit of " + std::string(what) + " '" + std::string(name) + "'" +
                                suggest_name(name, names));
}

/// Exponents of length, time and mass, and the coherent SI name that takes prefixes ("" where none is usual).
struct Dimension {
    int length, time, mass;
    std::string_view si_name;
};

constexpr Dimension dimension(Quantity quantity) {
    switch (quantity) {
        case Quantity::dimensionless:
            return {0, 0, 0, ""};
        case Quantity::length:
            return {1, 0, 0, "m"};
        case Quantity::time:
            return {0, 1, 0, "s"};
        case Quantity::mass:
            return {0, 0, 1, ""};
        case Quantity::velocity:
            return {1, -1, 0, "m/s"};
        case Quantity::acceleration:
            return {1, -2, 0, ""};
        case Quantity::force:
            return {1, -2, 1, "N"};
        case Quantity::impulse:
            return {1, -1, 1, "N s"};
        case Quantity::angular_momentum:
            return {2, -1, 1, "N m s"};
        case Quantity::stress:
            return {-1, -2, 1, "Pa"};
        case Quantity::energy:
            return {2, -2, 1, "J"};
        case Quantity::density:
            return {-3, 0, 1, ""};
        case Quantity::rate:
            return {0, -1, 0, ""};
        case Quantity::temperature:
            return {0, 0, 0, ""};
    }
    return {0, 0, 0, ""};
}

constexpr std::array<std::string_view, 9> prefixes{"p", "n", "µ", "m", "", "k", "M", "G", "T"};
constexpr int no_prefix = 4;

/// n where factor = 1000^n, when that is so and a prefix for it exists.
std::optional<int> power_of_1000(double factor) {
    const double power = std::log10(factor) / 3;
    const double whole = std::round(power);
    if (std::abs(power - whole) > 1e-9 || std::abs(whole) > no_prefix) return std::nullopt;
    return static_cast<int>(whole);
}

std::string prefixed(int power, std::string_view name) {
    return std::string(prefixes.at(static_cast<std::size_t>(power + no_prefix))) + std::string(name);
}

/// "lb in/ms^2" from the three base names and their exponents.
std::string product(const Dimension& d, const Units& units) {
    std::string above, below;
    const auto factor = [&](const std::string& name, int exponent) {
        if (exponent == 0) return;
        std::string& part = exponent > 0 ? above : below;
        if (!part.empty()) part += ' ';
        part += name;
        if (std::abs(exponent) > 1) part += "^" + std::to_string(std::abs(exponent));
    };
    factor(units.mass_name(), d.mass);
    factor(units.length_name(), d.length);
    factor(units.time_name(), d.time);
    if (below.empty()) return above;
    const bool several = below.find(' ') != std::string::npos;
    return (above.empty() ? "1" : above) + "/" + (several ? "(" + below + ")" : below);
}

/// Prefixes that people use with a quantity: no kiloseconds, no megametres.
std::array<int, 2> usual_powers(Quantity quantity) {
    switch (quantity) {
        case Quantity::time:
            return {-4, 0};
        case Quantity::length:
            return {-3, 1};
        case Quantity::velocity:
            return {-1, 1};
        default:
            return {-3, 3};
    }
}

}  // namespace

Units::Units(std::string length, std::string time, std::string mass)
    : length_(std::move(length)), time_(std::move(time)), mass_(std::move(mass)) {
    base_si(length_, lengths, "length");
    base_si(time_, times, "time");
    base_si(mass_, masses, "mass");
}

double Units::si(Quantity quantity) const {
    const Dimension d = dimension(quantity);
    return std::pow(base_si(length_, lengths, "length"), d.length) *
           std::pow(base_si(time_, times, "time"), d.time) * std::pow(base_si(mass_, masses, "mass"), d.mass);
}

std::string Units::label(Quantity quantity) const {
    const Dimension d = dimension(quantity);
    if (quantity == Quantity::length) return length_;
    if (quantity == Quantity::time) return time_;
    if (quantity == Quantity::temperature) return "K";
    if (d.si_name.empty()) return product(d, *this);
    const auto power = power_of_1000(si(quantity));
    // Prefixes on a velocity other than the usual ones say less than the declared units: km/s, but cm/us.
    if (!power || (quantity == Quantity::velocity && std::abs(*power) > 1)) return product(d, *this);
    return prefixed(*power, d.si_name);
}

DisplayUnit Units::display(Quantity quantity, double magnitude) const {
    const Dimension d = dimension(quantity);
    const double in_si = std::abs(magnitude) * si(quantity);
    const bool inches = (length_ == "in" || length_ == "ft") && d.length != 0 && d.mass == 0;
    if (d.si_name.empty() || inches || !std::isfinite(in_si) || in_si == 0) return {1, label(quantity)};
    const auto [least, most] = usual_powers(quantity);
    // 0.9995 would be printed as 1000 of the smaller unit with three digits: it reads best as 1 of the
    // larger.
    const double power = std::floor(std::log10(in_si / 0.9995) / 3);
    const int chosen =
        static_cast<int>(std::clamp(power, static_cast<double>(least), static_cast<double>(most)));
    return {si(quantity) / std::pow(1000.0, chosen), prefixed(chosen, d.si_name)};
}

}  // namespace percuss
