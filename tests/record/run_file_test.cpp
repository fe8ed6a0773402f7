#include "record/run_file.hpp"

#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "record/sample_run.hpp"

namespace percuss {
namespace {

using test::sample_snapshot;
using testing::HasSubstr;

class RunFileTest : public testing::Test {
  protected:
    void write(int frames, int rows, bool finish, const std::vector<std::string>& overrides = {}) {
        setup_ = test::sample_setup(overrides);
        RunFileWriter writer(file_, setup_, test::sample_columns());
        History history(test::sample_columns());
        for (int f = 0; f < frames; ++f) {
            test::append_sample_rows(history, rows / frames);
            writer.add_history(history);
            writer.add_frame(sample_snapshot(setup_, f));
        }
        if (finish) writer.finish(R"({"steps": 42})");
    }

    test::TemporaryFolder folder_;
    std::filesystem::path file_ = folder_.path() / "run.h5";
    std::shared_ptr<const RunSetup> setup_;
};

void expect_same(const Snapshot& read, const Snapshot& written) {
    EXPECT_EQ(read.time, written.time);
    EXPECT_EQ(read.step, written.step);
    EXPECT_EQ(read.dt, written.dt);
    EXPECT_EQ(read.critical_step, written.critical_step);
    EXPECT_EQ(read.position, written.position);
    EXPECT_EQ(read.velocity, written.velocity);
    EXPECT_EQ(read.stress, written.stress);
    ASSERT_EQ(read.contact_forces.size(), written.contact_forces.size());
    for (std::size_t i = 0; i < read.contact_forces.size(); ++i) {
        EXPECT_EQ(read.contact_forces[i].node, written.contact_forces[i].node);
        EXPECT_EQ(read.contact_forces[i].pair, written.contact_forces[i].pair);
        EXPECT_EQ(read.contact_forces[i].master, written.contact_forces[i].master);
        EXPECT_EQ(read.contact_forces[i].force, written.contact_forces[i].force);
    }
    ASSERT_EQ(read.pairs.size(), written.pairs.size());
    EXPECT_EQ(read.pairs[0].force, written.pairs[0].force);
    EXPECT_EQ(read.pairs[0].active, written.pairs[0].active);
    EXPECT_EQ(read.pairs[0].penetration, written.pairs[0].penetration);
    ASSERT_EQ(read.bodies.size(), written.bodies.size());
    EXPECT_EQ(read.bodies[1].velocity, written.bodies[1].velocity);
    EXPECT_EQ(read.plastic_strain, written.plastic_strain);
    EXPECT_EQ(read.yield_stress, written.yield_stress);
    EXPECT_EQ(read.temperature, written.temperature);
    for (const auto part : {&Energies::kinetic, &Energies::internal, &Energies::hourglass, &Energies::viscous,
                            &Energies::contact, &Energies::external, &Energies::plastic, &Energies::friction})
        EXPECT_EQ(read.energy.*part, written.energy.*part);
    EXPECT_EQ(read.status, written.status);
}

TEST_F(RunFileTest, GivesBackEveryFrameBitByBit) {
    write(5, 50, true);
    const RunFile run(file_);
    ASSERT_EQ(run.frames(), 5);
    for (int f : {4, 0, 1, 2, 3}) expect_same(*run.frame(f), sample_snapshot(setup_, f));
    EXPECT_EQ(run.summary(), R"({"steps": 42})");
}

TEST_F(RunFileTest, GivesBackPlasticFieldsAndTemperatures) {
    write(3, 3, true,
          {"material.steel.johnson_cook={yield=0.4, hardening=0.3, exponent=0.3, melting_temperature=1800, "
           "heat_capacity=460}"});
    ASSERT_TRUE(ambient_temperature(setup_->scene));
    const RunFile run(file_);
    for (int f : {2, 0, 1}) {
        const auto frame = run.frame(f);
        EXPECT_EQ(frame->temperature.size(), 3U);
        expect_same(*frame, sample_snapshot(setup_, f));
    }
}

TEST_F(RunFileTest, GivesBackTheWorkOfFriction) {
    write(3, 3, true, {"contact.impact.friction=0.2", "contact_solver.scheme=joint"});
    for (int f : {2, 0, 1}) {
        const double work = RunFile(file_).frame(f)->energy.friction;
        EXPECT_EQ(work, sample_snapshot(setup_, f).energy.friction);
        EXPECT_NE(work, 0);
    }
}

TEST_F(RunFileTest, GivesBackSceneAndMesh) {
    write(1, 1, true, {"model.duration=2.5"});
    const RunFile run(file_);
    const RunSetup& read = *run.setup();
    EXPECT_EQ(read.scene.text, test::sample_scene_text);
    EXPECT_EQ(read.scene.file, "sample.toml");
    EXPECT_EQ(read.scene.duration, 2.5);
    EXPECT_EQ(read.mesh.nodes, setup_->mesh.nodes);
    EXPECT_EQ(read.mesh.cells, setup_->mesh.cells);
    ASSERT_EQ(read.mesh.bodies.size(), 2U);
    const MeshBody &anvil = read.mesh.bodies[1], &striker = read.mesh.bodies[0];
    EXPECT_EQ(anvil.name, "anvil");
    EXPECT_EQ(anvil.kind, ElementKind::triangle_averaged);
    EXPECT_EQ(anvil.node_begin, 6);
    EXPECT_EQ(anvil.cell_end, 3);
    ASSERT_EQ(striker.edges.size(), 1U);
    EXPECT_EQ(striker.edges[0].name, "face");
    EXPECT_EQ(striker.edges[0].nodes, (std::vector<std::int32_t>{0, 1, 2}));
    EXPECT_FALSE(striker.edges[0].closed);
    ASSERT_EQ(striker.outlines.size(), 1U);
    EXPECT_EQ(striker.outlines[0].nodes, setup_->mesh.bodies[0].outlines[0].nodes);
    EXPECT_TRUE(striker.outlines[0].closed);
}

TEST_F(RunFileTest, GivesBackHistoriesAppendedInPieces) {
    write(3, 6000, true);
    const RunFile run(file_);
    const auto history = run.history();
    ASSERT_EQ(history->rows(), 6000U);
    EXPECT_EQ(history->columns()[1].name, "contact.impact.y");
    EXPECT_EQ(history->columns()[1].quantity, Quantity::force);
    History expected(test::sample_columns());
    test::append_sample_rows(expected, 6000);
    EXPECT_EQ(history->table(0, 6000), expected.table(0, 6000));
}

TEST_F(RunFileTest, KeepsEveryNthRowWhateverThePieces) {
    write(7, 70, true, {"record.history_every=4"});
    const auto history = RunFile(file_).history();
    ASSERT_EQ(history->rows(), 18U);  // rows 0, 4, ..., 68
    for (std::size_t i = 0; i < 18; ++i) {
        EXPECT_DOUBLE_EQ(history->table(i, i + 1)[2], -static_cast<double>(4 * i) / 3) << i;
    }
}

TEST_F(RunFileTest, ReadsARunThatDidNotFinish) {
    write(2, 20, false);
    const RunFile run(file_);
    EXPECT_EQ(run.frames(), 2);
    EXPECT_EQ(run.summary(), "");
    expect_same(*run.frame(1), sample_snapshot(setup_, 1));
}

TEST_F(RunFileTest, ReadsARunThatStillGoesOn) {
    setup_ = test::sample_setup();
    RunFileWriter writer(file_, setup_, test::sample_columns());
    for (int f = 0; f < 3; ++f) {
        writer.add_frame(sample_snapshot(setup_, f));
        const RunFile run(file_);
        ASSERT_EQ(run.frames(), f + 1);
        expect_same(*run.frame(f), sample_snapshot(setup_, f));
    }
}

std::string error_of(const std::filesystem::path& file) {
    try {
        const RunFile run(file);
    } catch (const RecordError& error) {
        return error.what();
    }
    return "no error";
}

TEST_F(RunFileTest, SaysWhyAFileCannotBeRead) {
    EXPECT_EQ(error_of(folder_.path() / "none.h5"), (folder_.path() / "none.h5").string() + ": no such file");
    std::ofstream(folder_.path() / "text.h5") << "not HDF5 at all";
    const std::string text = error_of(folder_.path() / "text.h5");
    EXPECT_THAT(text, HasSubstr("text.h5: cannot be opened: "));
    EXPECT_THAT(text, HasSubstr("signature"));
    write(1, 1, true);
    std::filesystem::resize_file(file_, std::filesystem::file_size(file_) / 2);
    EXPECT_THAT(error_of(file_), HasSubstr("run.h5: cannot be opened: "));
}

TEST_F(RunFileTest, RefusesFramesThatAreNotThere) {
    write(2, 2, true);
    const RunFile run(file_);
    try {
        static_cast<void>(run.frame(2));
        FAIL() << "a frame that is not there was read";
    } catch (const RecordError& error) {
        EXPECT_EQ(std::string(error.what()), file_.string() + ": no frame 2; the run has 2 (0 to 1)");
    }
}

TEST_F(RunFileTest, NeverOverwrites) {
    write(1, 1, true);
    try {
        const RunFileWriter writer(file_, setup_, test::sample_columns());
        FAIL() << "an existing file was opened for writing";
    } catch (const RecordError& error) {
        EXPECT_EQ(std::string(error.what()), file_.string() + ": the file exists already");
    }
}

TEST_F(RunFileTest, SaysWhyAFileCannotBeMade) {
    try {
        const RunFileWriter writer(folder_.path() / "no" / "run.h5", test::sample_setup(),
                                   test::sample_columns());
        FAIL() << "a file was made in a folder that does not exist";
    } catch (const RecordError& error) {
        EXPECT_THAT(error.what(), HasSubstr("run.h5: cannot be made: "));
        EXPECT_THAT(error.what(), HasSubstr("No such file or directory"));
    }
}

}  // namespace
}  // namespace percuss
