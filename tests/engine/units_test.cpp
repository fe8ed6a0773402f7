#include "units.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

#include "nearest_name.hpp"

namespace percuss {
namespace {

TEST(Units, OfMillimetreMillisecondKilogram) {
    const Units units;
    EXPECT_EQ(units.label(Quantity::force), "kN");
    EXPECT_EQ(units.label(Quantity::stress), "GPa");
    EXPECT_EQ(units.label(Quantity::energy), "J");
    EXPECT_EQ(units.label(Quantity::velocity), "m/s");
    EXPECT_EQ(units.label(Quantity::impulse), "N s");
    EXPECT_EQ(units.label(Quantity::acceleration), "mm/ms^2");
    EXPECT_EQ(units.label(Quantity::density), "kg/mm^3");
    EXPECT_EQ(units.label(Quantity::rate), "1/ms");
    EXPECT_EQ(units.label(Quantity::dimensionless), "");
    EXPECT_DOUBLE_EQ(units.si(Quantity::stress), 1e9);
    EXPECT_DOUBLE_EQ(units.si(Quantity::force), 1e3);
    EXPECT_DOUBLE_EQ(units.si(Quantity::density), 1e9);
}

TEST(Units, OfMillimetreSecondTonne) {
    const Units units("mm", "s", "t");
    EXPECT_EQ(units.label(Quantity::force), "N");
    EXPECT_EQ(units.label(Quantity::stress), "MPa");
    EXPECT_EQ(units.label(Quantity::energy), "mJ");
    EXPECT_EQ(units.label(Quantity::velocity), "mm/s");
}

TEST(Units, OfInchesAreProducts) {
    const Units units("in", "ms", "lb");
    EXPECT_EQ(units.label(Quantity::force), "lb in/ms^2");
    EXPECT_EQ(units.label(Quantity::stress), "lb/(in ms^2)");
    EXPECT_EQ(units.display(Quantity::length, 3).label, "in");
    EXPECT_EQ(units.display(Quantity::force, 1).label, "kN");  // 1 lb in/ms^2 = 11.5 kN
}

TEST(Units, DisplayTakesThePrefixThatReadsBest) {
    const Units units;
    const auto time = units.display(Quantity::time, 0.06);
    EXPECT_EQ(time.label, "µs");
    EXPECT_DOUBLE_EQ(time.scale * 0.06, 60);
    const auto stress = units.display(Quantity::stress, -0.2);
    EXPECT_EQ(stress.label, "MPa");
    EXPECT_DOUBLE_EQ(stress.scale * -0.2, -200);
    EXPECT_EQ(units.display(Quantity::force, 63.8).label, "kN");
    EXPECT_EQ(units.display(Quantity::force, 0.9996).label, "kN");
    EXPECT_EQ(units.display(Quantity::force, 0.9).label, "N");
    EXPECT_EQ(units.display(Quantity::time, 5e6).label, "s");
    EXPECT_EQ(units.display(Quantity::energy, 0).label, "J");
    EXPECT_EQ(units.display(Quantity::density, 1).label, "kg/mm^3");
}

TEST(Units, UnknownNamesAreRefusedWithTheNearest) {
    try {
        Units("mm", "mms", "kg");
        FAIL();
    } catch (const std::invalid_argument& error) {
        EXPECT_STREQ(error.what(), "unknown unit of time 'mms'; did you mean 'ms'?");
    }
}

TEST(NearestName, IsTheOneOfLeastEdits) {
    const std::vector<std::string> names{"young", "poisson", "density"};
    EXPECT_EQ(nearest_name("posson", names), "poisson");
    EXPECT_EQ(suggest_name("Yuong", names), "; did you mean 'young'?");
    EXPECT_EQ(suggest_name("mass", names), "; valid: young, poisson, density");
    EXPECT_EQ(suggest_name("mass", {}), "; there are none");
    EXPECT_EQ(nearest_name("mass", {}), "");
}

}  // namespace
}  // namespace percuss
