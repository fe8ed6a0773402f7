#pragma once

#include <string>

namespace percuss {

/// What a number measures. Momentum, work, ... are products of the three base units.
enum class Quantity {
    dimensionless,
    length,
    time,
    mass,
    velocity,
    acceleration,
    force,
    impulse,  ///< also linear momentum
    angular_momentum,
    stress,  ///< also pressure and moduli
    energy,
    density,
    rate,  ///< 1/time
    temperature,  ///< always kelvin
};

/// A multiplier and the unit label that belongs to the multiplied number.
struct DisplayUnit {
    double scale = 1;   ///< shown value = scale * value in scene units
    std::string label;  ///< e.g. "µs", "kN", "MPa", "" when dimensionless
};

/// The units that a scene declares. percuss computes in them as they are; they give labels and sanity checks.
class Units {
  public:
    Units() = default;  ///< mm, ms, kg: forces in kN, stresses in GPa, energies in J, velocities in m/s
    /// @param length one of "m", "cm", "mm", "um", "in", "ft"; @param time one of "s", "ms", "us", "ns";
    /// @param mass one of "t", "kg", "g", "mg", "lb". @throws std::invalid_argument naming the valid ones.
    Units(std::string length, std::string time, std::string mass);

    /// SI value of one scene unit of `quantity` (e.g. 1e9 for GPa).
    [[nodiscard]] double si(Quantity quantity) const;
    /// Label of the scene's own unit: the declared name, a prefixed SI name (kN, GPa, J) where the factor is a
    /// power of 1000, else the product of base units ("lb in/ms^2").
    [[nodiscard]] std::string label(Quantity quantity) const;
    /// The unit with the SI prefix in which `magnitude` (scene units) reads best: 0.06 ms -> µs, 0.2 GPa -> MPa.
    [[nodiscard]] DisplayUnit display(Quantity quantity, double magnitude) const;

    [[nodiscard]] const std::string& length_name() const { return length_; }
    [[nodiscard]] const std::string& time_name() const { return time_; }
    [[nodiscard]] const std::string& mass_name() const { return mass_; }
    bool operator==(const Units&) const = default;

  private:
    std::string length_ = "mm", time_ = "ms", mass_ = "kg";
};

}  // namespace percuss
