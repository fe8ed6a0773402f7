// What other programs read in run.h5: each dataset is the quantity that FORMAT.md says, in the unit that it
// carries.
#include <cmath>

#include <gtest/gtest.h>

#include "record/hdf5.hpp"
#include "record/sample_run.hpp"

namespace percuss {
namespace {

constexpr int frame = 2;

class FrameLayout : public testing::Test {
  protected:
    FrameLayout() {
        const auto file = folder_.path() / "run.h5";
        RunFileWriter writer(file, setup_, test::sample_columns());
        for (int f = 0; f <= frame; ++f) writer.add_frame(test::sample_snapshot(setup_, f));
        writer.finish("{}");
        file_ = hdf5::Handle(H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), "run.h5");
        frames_ = hdf5::Handle(H5Gopen2(file_.id(), "frames", H5P_DEFAULT), "frames");
    }

    [[nodiscard]] hdf5::Rows dataset(const char* name) const { return {frames_.id(), name}; }
    [[nodiscard]] std::vector<double> row(const char* name) const {
        return dataset(name).read<double>(frame, 1);
    }
    [[nodiscard]] std::string unit(const char* name) const {
        return hdf5::read_text_attribute(dataset(name).id(), "unit");
    }

    test::TemporaryFolder folder_;
    std::shared_ptr<const RunSetup> setup_ =
        test::sample_setup({"material.steel.johnson_cook={yield=0.4, hardening=0.3, exponent=0.3, "
                            "melting_temperature=1800, heat_capacity=460}"});
    hdf5::Handle file_, frames_;
};

TEST_F(FrameLayout, EachDatasetIsTheQuantityOfItsName) {
    const Snapshot written = test::sample_snapshot(setup_, frame);
    const auto stress = row("stress"), von_mises = row("von_mises"), pressure = row("pressure");
    ASSERT_EQ(stress.size(), 12U);
    for (std::size_t c = 0; c < 3; ++c) {
        // Components xx, yy, zz, xy of the sample: f + c/10, 2 f, 3 f, c/2.
        const double f = frame, shift = 0.1 * static_cast<double>(c), xy = 0.5 * static_cast<double>(c);
        EXPECT_EQ(stress[4 * c], f + shift);
        EXPECT_EQ(stress[4 * c + 1], 2 * f);
        EXPECT_EQ(stress[4 * c + 2], 3 * f);
        EXPECT_EQ(stress[4 * c + 3], xy);
        EXPECT_DOUBLE_EQ(pressure[c], -(6 * f + shift) / 3);
        // sqrt(3 J2) of the deviator, whatever formula the program takes.
        const double mean = (6 * f + shift) / 3, x = f + shift - mean, y = 2 * f - mean, z = 3 * f - mean;
        EXPECT_DOUBLE_EQ(von_mises[c], std::sqrt(1.5 * (x * x + y * y + z * z + 2 * xy * xy)));
    }
    EXPECT_EQ(row("position"), written.position);
    EXPECT_EQ(row("velocity"), written.velocity);
    EXPECT_EQ(row("plastic_strain"), written.plastic_strain);
    EXPECT_EQ(row("yield_stress"), written.yield_stress);
    EXPECT_EQ(row("temperature"), written.temperature);
    EXPECT_EQ(row("pair_force"), (std::vector<double>{0.25 * frame, 0.5 * frame}));
    EXPECT_EQ(row("body_velocity"), (std::vector<double>{0, -1. / (1 + frame), 0.5, 0.25 * frame}));
}

TEST_F(FrameLayout, EnergiesStandInTheOrderOfTheirColumns) {
    EXPECT_EQ(hdf5::read_text_attribute(dataset("energies").id(), "columns"),
              "kinetic,internal,hourglass,viscous,contact,external,plastic");
    const Energies e = test::sample_snapshot(setup_, frame).energy;
    EXPECT_EQ(row("energies"), (std::vector<double>{e.kinetic, e.internal, e.hourglass, e.viscous, e.contact,
                                                    e.external, e.plastic}));
}

TEST_F(FrameLayout, DatasetsCarryTheirUnits) {
    // mm, ms and kg make kN, GPa, J and m/s.
    for (const char* name : {"time", "dt", "critical_step"}) EXPECT_EQ(unit(name), "ms") << name;
    for (const char* name : {"position", "pair_penetration"}) EXPECT_EQ(unit(name), "mm") << name;
    for (const char* name : {"velocity", "body_velocity"}) EXPECT_EQ(unit(name), "m/s") << name;
    for (const char* name : {"stress", "von_mises", "pressure", "yield_stress"})
        EXPECT_EQ(unit(name), "GPa") << name;
    for (const char* name : {"contact_force", "pair_force"}) EXPECT_EQ(unit(name), "kN") << name;
    EXPECT_EQ(unit("energies"), "J");
    EXPECT_EQ(unit("temperature"), "K");
    EXPECT_EQ(unit("plastic_strain"), "");
}

}  // namespace
}  // namespace percuss
