#include <algorithm>

#include <fmt/format.h>

#include "scene/readers.hpp"

namespace percuss {
namespace {

/// Yields at strains that no solid reaches are nearly always a slip of units.
constexpr double most_usual_elastic_strain = 0.2;

void check_yield(TableReader& reader, const Units& units, const Material& material, std::string_view key,
                 double yield) {
    if (yield <= most_usual_elastic_strain * material.young) return;
    reader.faults().warning(
        reader.place(key),
        fmt::format(
            "material '{}' yields at {:.6g} {}, above {} of its Young's modulus of {:.6g}; check the units",
            material.name, yield, units.label(Quantity::stress), most_usual_elastic_strain, material.young));
}

Plasticity read_points(TableReader& reader, const Units& units, const Material& material) {
    for (const std::string_view key : {"yield", "linear", "saturation", "rate"})
        if (reader.find(key))
            reader.error(
                key,
                fmt::format("'{}' and 'points' exclude each other; keep the points or the formula", key));
    TabulatedHardening table;
    for (const auto& row : reader.rows("points", 2).value_or(std::vector<std::vector<double>>{}))
        table.points.emplace_back(row[0], row[1]);
    const auto& points = table.points;
    if (points.empty()) {
        if (reader.node()["points"].is_array() && reader.node()["points"].as_array()->empty())
            reader.error("points",
                         "'points' is empty; write [[0, yield stress], [plastic strain, yield stress], ...]");
        return std::monostate{};
    }
    if (points.front().first != 0)
        reader.error("points",
                     fmt::format("'points' begin at plastic strain {}; the first point must be at 0",
                                 points.front().first));
    if (points.front().second <= 0)
        reader.error("points", fmt::format("the first yield stress of 'points' is {}; it must be > 0",
                                           points.front().second));
    for (std::size_t i = 1; i < points.size(); ++i) {
        if (points[i].first <= points[i - 1].first)
            reader.error(
                "points",
                fmt::format(
                    "the plastic strain of 'points' does not rise from {} to {}; order the points by it",
                    points[i - 1].first, points[i].first));
        if (points[i].second < points[i - 1].second)
            reader.error(
                "points",
                fmt::format("the yield stress of 'points' falls from {} to {}; softening would gather in one "
                            "row of cells, whatever their size: let it rise or stay",
                            points[i - 1].second, points[i].second));
    }
    check_yield(reader, units, material, "points", points.front().second);
    return table;
}

Plasticity read_plastic(TableReader& reader, const Units& units, const Material& material) {
    Plasticity result;
    if (reader.find("points")) {
        result = read_points(reader, units, material);
    } else {
        VoceHardening law;
        reader.need("yield", fmt::format("yield = NUMBER in {}, or points = [[0, yield stress], ...]",
                                         units.label(Quantity::stress)));
        const auto yield = reader.number("yield", positive);
        law.yield = yield.value_or(1);
        law.linear = reader.number("linear", not_negative).value_or(0);
        law.saturation = reader.number("saturation", not_negative).value_or(0);
        law.rate = reader.number("rate", positive).value_or(0);
        if (law.saturation > 0 && !reader.find("rate"))
            reader.error("saturation",
                         "'saturation' needs 'rate', how fast it is reached per unit of plastic strain; add "
                         "rate = 10");
        if (reader.find("rate") && !reader.find("saturation"))
            reader.error("rate", "'rate' belongs to 'saturation'; add saturation = STRESS or leave it out");
        if (yield) check_yield(reader, units, material, "yield", law.yield);
        result = law;
    }
    reader.finish();
    return result;
}

void read_heat(TableReader& reader, JohnsonCook& law) {
    law.room_temperature = reader.number("room_temperature", not_negative).value_or(293);
    law.initial_temperature =
        reader.number("initial_temperature", not_negative).value_or(law.room_temperature);
    law.melting_temperature = reader.number("melting_temperature", positive);
    if (law.melting_temperature && *law.melting_temperature <= law.room_temperature)
        reader.error("melting_temperature",
                     fmt::format("'melting_temperature' is {}; it must be above the room temperature of {}",
                                 *law.melting_temperature, law.room_temperature));
    if (law.melting_temperature && law.initial_temperature >= *law.melting_temperature &&
        reader.find("initial_temperature"))
        reader.error(
            "initial_temperature",
            fmt::format("'initial_temperature' is {}; it must be below the melting temperature of {}",
                        law.initial_temperature, *law.melting_temperature));
    law.softening_exponent = reader.number("softening_exponent", positive).value_or(1);
    if (reader.find("softening_exponent") && !reader.find("melting_temperature"))
        reader.error(
            "softening_exponent",
            "'softening_exponent' has no effect without 'melting_temperature'; add it or leave this out");
    law.heat_capacity = reader.number("heat_capacity", positive);
    law.heat_fraction = reader.number("heat_fraction", {.low = 0, .high = 1}).value_or(0.9);
    if (reader.find("heat_fraction") && !reader.find("heat_capacity"))
        reader.error("heat_fraction",
                     "'heat_fraction' has no effect without 'heat_capacity'; add it or leave this out");
}

Plasticity read_johnson_cook(TableReader& reader, const Units& units, const Material& material) {
    JohnsonCook law;
    reader.need("yield",
                fmt::format("yield = NUMBER in {}: A of (A + B ep^n)", units.label(Quantity::stress)));
    const auto yield = reader.number("yield", positive);
    law.yield = yield.value_or(1);
    law.hardening = reader.number("hardening", not_negative).value_or(0);
    law.exponent = reader.number("exponent", positive).value_or(1);
    if (law.hardening > 0 && !reader.find("exponent"))
        reader.error("hardening", "'hardening' B needs 'exponent' n of (A + B ep^n); add exponent = 0.3");
    if (reader.find("exponent") && !reader.find("hardening"))
        reader.error("exponent",
                     "'exponent' n belongs to 'hardening' B of (A + B ep^n); add it or leave this out");
    law.rate_factor = reader.number("rate_factor", not_negative).value_or(0);
    const auto reference = reader.number("reference_rate", positive);
    law.reference_rate = reference.value_or(1);
    if (law.rate_factor > 0 && !reader.find("reference_rate"))
        reader.error(
            "rate_factor",
            fmt::format("'rate_factor' C needs 'reference_rate'; 1/s is reference_rate = {:.6g} in 1/{}",
                        units.si(Quantity::time), units.time_name()));
    if (reference && !reader.find("rate_factor"))
        reader.error("reference_rate",
                     "'reference_rate' belongs to 'rate_factor' C; add it or leave this out");
    read_heat(reader, law);
    if (yield) check_yield(reader, units, material, "yield", law.yield);
    reader.finish();
    return law;
}

}  // namespace

void read_plasticity(TableReader& reader, const Scene& scene, Material& material) {
    auto plastic = reader.table("plastic");
    auto johnson_cook = reader.table("johnson_cook");
    if (plastic) material.plasticity = read_plastic(*plastic, scene.units, material);
    if (johnson_cook) material.plasticity = read_johnson_cook(*johnson_cook, scene.units, material);
    if (plastic && johnson_cook)
        reader.error(
            "johnson_cook",
            fmt::format("material '{}' has 'plastic' and 'johnson_cook', which exclude each other; keep one",
                        material.name));
    if ((plastic || johnson_cook) && scene.geometry == Geometry::plane_stress)
        reader.error(
            plastic ? "plastic" : "johnson_cook",
            fmt::format(
                "material '{}' is plastic, but in plane stress plastic flow would change the thickness, "
                "which "
                "the elements do not follow; take geometry = \"plane strain\" or \"axisymmetric\", or an "
                "elastic material",
                material.name));
}

}  // namespace percuss
