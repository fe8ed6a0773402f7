#include "run/fields.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace percuss {
namespace {

/// Two nodes that have moved and one cell under stress.
Snapshot one_cell(Geometry geometry) {
    auto setup = std::make_shared<RunSetup>();
    setup->scene.geometry = geometry;
    setup->mesh.nodes = {Vec2(1, 2), Vec2(3, 2)};
    setup->mesh.cells = {Cell{0, 1, 0, -1}};
    Snapshot snapshot;
    snapshot.setup = setup;
    snapshot.position = {1.5, 2, 3, 6};
    snapshot.velocity = {-3, 4, 0, -2};
    snapshot.stress = {{10, -20, 40, 5}};
    return snapshot;
}

std::vector<double> values(const Snapshot& snapshot, std::string_view name) {
    return field_values(snapshot, find_field(snapshot.setup->scene, name));
}

using testing::DoubleNear;
using testing::ElementsAre;

TEST(Fields, StressComponentsComeInTheOrderOfTheMean) {
    const Snapshot snapshot = one_cell(Geometry::axisymmetric);
    EXPECT_THAT(values(snapshot, "stress.radial"), ElementsAre(10));
    EXPECT_THAT(values(snapshot, "stress.axial"), ElementsAre(-20));
    EXPECT_THAT(values(snapshot, "stress.hoop"), ElementsAre(40));
    EXPECT_THAT(values(snapshot, "stress.shear"), ElementsAre(5));
    const Snapshot plane = one_cell(Geometry::plane_strain);
    EXPECT_THAT(values(plane, "stress.x"), ElementsAre(10));
    EXPECT_THAT(values(plane, "stress.y"), ElementsAre(-20));
    EXPECT_THAT(values(plane, "stress.z"), ElementsAre(40));
    EXPECT_THAT(values(plane, "stress.xy"), ElementsAre(5));
}

TEST(Fields, PressureIsMinusTheMeanStress) {
    EXPECT_THAT(values(one_cell(Geometry::axisymmetric), "pressure"), ElementsAre(-10));
}

TEST(Fields, VonMisesOfUniaxialTensionIsTheTensionAndOfShearIsItTimesRootThree) {
    Snapshot snapshot = one_cell(Geometry::plane_stress);
    snapshot.stress = {{7, 0, 0, 0}};
    EXPECT_THAT(values(snapshot, "von_mises"), ElementsAre(DoubleNear(7, 1e-12)));
    snapshot.stress = {{0, 0, 0, 7}};
    EXPECT_THAT(values(snapshot, "von_mises"), ElementsAre(DoubleNear(7 * std::sqrt(3.0), 1e-12)));
    snapshot.stress = {{-4, -4, -4, 0}};
    EXPECT_THAT(values(snapshot, "von_mises"), ElementsAre(0));
}

TEST(Fields, NodeFieldsHaveOneValueANode) {
    const Snapshot snapshot = one_cell(Geometry::axisymmetric);
    EXPECT_THAT(values(snapshot, "velocity.radial"), ElementsAre(-3, 0));
    EXPECT_THAT(values(snapshot, "velocity.axial"), ElementsAre(4, -2));
    EXPECT_THAT(values(snapshot, "velocity.magnitude"), ElementsAre(5, 2));
    EXPECT_THAT(values(snapshot, "displacement.radial"), ElementsAre(0.5, 0));
    EXPECT_THAT(values(snapshot, "displacement.axial"), ElementsAre(0, 4));
    EXPECT_THAT(values(snapshot, "displacement.magnitude"), ElementsAre(0.5, 4));
}

TEST(Fields, EveryAdvertisedFieldHasValuesTitleAndAUniqueName) {
    for (const Geometry geometry : {Geometry::axisymmetric, Geometry::plane_strain, Geometry::plane_stress}) {
        const Snapshot snapshot = one_cell(geometry);
        std::set<std::string> names;
        for (const FieldInfo& field : available_fields(snapshot.setup->scene)) {
            EXPECT_TRUE(names.insert(field.name).second) << field.name;
            EXPECT_FALSE(field.title.empty()) << field.name;
            EXPECT_EQ(field_values(snapshot, field).size(), field.per_cell ? 1U : 2U) << field.name;
        }
    }
}

TEST(Fields, AnUnknownNameSuggestsTheNearest) {
    try {
        static_cast<void>(find_field(Scene{}, "stress.axail"));
        FAIL() << "no exception";
    } catch (const std::invalid_argument& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr("unknown field 'stress.axail'"));
        EXPECT_THAT(error.what(), testing::HasSubstr("stress.axial"));
    }
}

TEST(Fields, PlaneScenesDoNotKnowAxialStress) {
    Scene plane;
    plane.geometry = Geometry::plane_strain;
    EXPECT_THROW(static_cast<void>(find_field(plane, "stress.axial")), std::invalid_argument);
}

TEST(Fields, TheDefaultViewNamesAFieldAndAColourMapThatExist) {
    const ViewOptions defaults;
    EXPECT_NO_THROW(static_cast<void>(find_field(Scene{}, defaults.field)));
    const auto maps = colour_map_names();
    EXPECT_NE(std::find(maps.begin(), maps.end(), defaults.colour_map), maps.end());
}

}  // namespace
}  // namespace percuss
