#include "record/layout.hpp"

#include <string>
#include <utility>

#include "record/run_file.hpp"

namespace percuss::layout {
namespace {

constexpr std::array<std::pair<Quantity, std::string_view>, 14> names{{
    {Quantity::dimensionless, "dimensionless"},
    {Quantity::length, "length"},
    {Quantity::time, "time"},
    {Quantity::mass, "mass"},
    {Quantity::velocity, "velocity"},
    {Quantity::acceleration, "acceleration"},
    {Quantity::force, "force"},
    {Quantity::impulse, "impulse"},
    {Quantity::angular_momentum, "angular_momentum"},
    {Quantity::stress, "stress"},
    {Quantity::energy, "energy"},
    {Quantity::density, "density"},
    {Quantity::rate, "rate"},
    {Quantity::temperature, "temperature"},
}};

}  // namespace

std::string_view quantity_name(Quantity quantity) {
    for (const auto& [value, name] : names) {
        if (value == quantity) return name;
    }
    throw RecordError("a quantity without a name in run.h5");
}

Quantity quantity_of(std::string_view name) {
    for (const auto& [value, known] : names) {
        if (known == name) return value;
    }
    throw RecordError("unknown quantity '" + std::string(name) + "'");
}

}  // namespace percuss::layout
